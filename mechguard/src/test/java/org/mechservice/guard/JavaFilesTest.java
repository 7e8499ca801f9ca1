package org.mechservice.guard;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.jar.Attributes;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class JavaFilesTest {
  @TempDir private Path folder;

  private Path jar(String name, String classPath) throws IOException {
    Manifest manifest = new Manifest();
    manifest.getMainAttributes().put(Attributes.Name.MANIFEST_VERSION, "1.0");
    if (!classPath.isEmpty()) {
      manifest.getMainAttributes().put(Attributes.Name.CLASS_PATH, classPath);
    }
    Path file = folder.resolve(name);
    Files.createDirectories(file.resolveSibling("."));
    try (OutputStream out = Files.newOutputStream(file);
        JarOutputStream written = new JarOutputStream(out, manifest)) {
      written.finish();
    }
    return file;
  }

  /**
   * Of a program that {@code java -jar} starts, the class path is one file. Its manifest has the
   * others, which may have manifests of their own; a circle ends.
   */
  @Test
  void classPathOfManifestsIsShown() throws Exception {
    Path main =
        jar("main.jar", "lib/a%20b.jar lib/gone.jar lib/classes/ https://example.org/x.jar");
    Path first = jar("lib/a b.jar", "c.jar ../main.jar");
    Path second = jar("lib/c.jar", "");
    Path classes = Files.createDirectories(folder.resolve("lib/classes"));

    JavaFiles files = new JavaFiles(main.toString());

    assertThat(files.classPath()).isEqualTo("/classes/0:/classes/1:/classes/2:/classes/3");
    assertThat(files.arguments())
        .containsSubsequence(
            main.toRealPath().toString(),
            "/classes/0",
            first.toRealPath().toString(),
            "/classes/1",
            second.toRealPath().toString(),
            "/classes/2",
            classes.toRealPath().toString(),
            "/classes/3");
  }

  @Test
  void whatIsNoJarIsShownAsItIs() throws Exception {
    Path file = Files.writeString(folder.resolve("x.jar"), "no zip");
    assertThat(new JavaFiles(file + ":" + folder.resolve("none.jar")).classPath())
        .isEqualTo("/classes/0");
  }
}
