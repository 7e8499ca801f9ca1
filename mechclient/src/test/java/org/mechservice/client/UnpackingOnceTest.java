package org.mechservice.client;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.pack.KeptClasses;
import org.mechservice.solver.pack.PackedClasses;

/** Classes that are packed together are unpacked once and kept; what is kept is checked. */
final class UnpackingOnceTest {
  private static final String PATH = "a/B.class";
  private static final SortedMap<String, byte[]> NONE = new TreeMap<>();

  @TempDir private Path folder;

  @Test
  void whatWasKeptIsUsed() throws IOException {
    byte[] kept = KeptClasses.write(new TreeMap<>(Map.of(PATH, new byte[] {1, 2, 3})));
    Files.write(folder.resolve(Sha256.of(kept) + ".classes"), kept);

    FetchedJar jar = unpack(Sha256.of(kept));

    assertThat(jar.entry(PATH)).contains(new byte[] {1, 2, 3});
  }

  @Test
  void whatIsUnpackedIsKept() throws IOException {
    byte[] expected = KeptClasses.write(NONE);

    unpack(Sha256.of(expected));

    assertThat(folder.resolve(Sha256.of(expected) + ".classes")).hasBinaryContent(expected);
  }

  @Test
  void whatWasChangedSinceIsUnpackedAnew() throws IOException {
    byte[] expected = KeptClasses.write(NONE);
    Path kept = folder.resolve(Sha256.of(expected) + ".classes");
    Files.write(kept, KeptClasses.write(new TreeMap<>(Map.of(PATH, new byte[] {9}))));

    FetchedJar jar = unpack(Sha256.of(expected));

    assertThat(jar.entry(PATH)).isEmpty();
    assertThat(kept).hasBinaryContent(expected);
  }

  @Test
  void whatIsNotWhatTheJarAnnouncesIsRefused() {
    assertThatThrownBy(() -> unpack(Sha256.of(new byte[] {7})))
        .isInstanceOf(JarRefusedException.class)
        .hasMessageContaining("what the runtime JAR holds was changed on its way");
    assertThat(folder).isEmptyDirectory();
  }

  private FetchedJar unpack(String keptSha256) throws IOException {
    Manifest manifest = TestJars.manifest(Integer.toString(Model.API_VERSION));
    manifest.getMainAttributes().putValue(PackedClasses.KEPT_SHA_256, keptSha256);
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (JarOutputStream jar = new JarOutputStream(bytes, manifest)) {
      jar.putNextEntry(new JarEntry(PackedClasses.ENTRY));
      jar.write(PackedClasses.pack(NONE));
    }
    return FetchedJar.unpack(bytes.toByteArray(), "the runtime JAR", new JarCache(folder));
  }
}
