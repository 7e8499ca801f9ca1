package org.mechservice.site;

import java.io.File;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.spi.ToolProvider;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The Javadoc of the modules that programs of users call. */
final class JavaReference {
  private static final List<Path> MODULES =
      List.of(
          Path.of("solver-core", "solver-api"),
          Path.of("solver-core", "solver-ode"),
          Path.of("mechguard"),
          Path.of("mechservice"),
          Path.of("mechclient"));

  private JavaReference() {}

  /**
   * Writes it.
   *
   * @param top of the repository, in which the program is built
   * @param target folder
   * @param style a further style sheet
   * @throws IOException with what javadoc said, if it failed
   */
  static void write(Path top, Path target, Path style) throws IOException {
    ToolProvider javadoc =
        ToolProvider.findFirst("javadoc")
            .orElseThrow(
                () ->
                    new IOException(
                        "this Java has no javadoc; set JAVA_HOME to a JDK (Debian:"
                            + " openjdk-17-jdk)"));
    String sources =
        MODULES.stream()
            .map(module -> top.resolve(module).resolve(Path.of("src", "main", "java")).toString())
            .collect(Collectors.joining(File.pathSeparator));
    String libraries =
        jars(top.resolve("mechcli")) + File.pathSeparator + jars(top.resolve("mechdocs"));
    List<String> words =
        new ArrayList<>(
            List.of(
                "-quiet",
                "-Xdoclint:none",
                "-notimestamp",
                "-windowtitle",
                "MechService for Java",
                "-doctitle",
                "MechService for Java",
                "-header",
                "<a href=\"{@docRoot}/../docs/index.html\">User guide</a>",
                "--add-stylesheet",
                style.toString(),
                "-sourcepath",
                sources,
                "-classpath",
                libraries,
                "-d",
                target.toString(),
                "-subpackages",
                "org.mechservice"));
    Files.createDirectories(target);
    StringWriter said = new StringWriter();
    PrintWriter out = new PrintWriter(said);
    if (javadoc.run(out, out, words.toArray(String[]::new)) != 0) {
      throw new IOException("javadoc failed:\n" + said);
    }
    // Its pages ask for this file, which Debian's javadoc leaves out together with the fonts.
    Path fonts = target.resolve(Path.of("resources", "fonts", "dejavu.css"));
    if (!Files.exists(fonts)) {
      Files.createDirectories(target.resolve(Path.of("resources", "fonts")));
      Files.writeString(fonts, "/* The fonts of the reader's machine. */\n");
    }
  }

  /** Returns the libraries of a module: javadoc takes no patterns when a program calls it. */
  private static String jars(Path module) throws IOException {
    try (Stream<Path> libraries = Files.list(module.resolve(Path.of("target", "lib")))) {
      return libraries.map(Path::toString).sorted().collect(Collectors.joining(File.pathSeparator));
    }
  }
}
