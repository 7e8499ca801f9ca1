package org.mechservice.guard;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Stream;
import javax.tools.ToolProvider;

/** Class files of forces that tests write as sources. */
final class CompiledForces {
  private static final String HEAD =
      "import org.mechservice.solver.api.*; import java.util.*; public class ";

  private CompiledForces() {}

  /**
   * Returns the class files of a source by binary name.
   *
   * @param body what follows the name of the class, such as {@code implements UserForce {...}}
   */
  static SortedMap<String, byte[]> of(Path folder, String name, String body) throws IOException {
    Path source = Files.writeString(folder.resolve(name + ".java"), HEAD + name + " " + body);
    Path classes = Files.createDirectories(folder.resolve("classes-" + name));
    int status =
        ToolProvider.getSystemJavaCompiler()
            .run(null, null, null, "-d", classes.toString(), "--release", "17", source.toString());
    if (status != 0) {
      throw new IOException("the source of a test does not compile");
    }
    SortedMap<String, byte[]> files = new TreeMap<>();
    try (Stream<Path> written = Files.list(classes)) {
      for (Path file : written.toList()) {
        String simple = String.valueOf(file.getFileName());
        files.put(simple.substring(0, simple.length() - 6), Files.readAllBytes(file));
      }
    }
    return files;
  }
}
