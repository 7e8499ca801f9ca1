package org.mechservice.cli.model;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;

/** What a JAR holds that runs by itself: compressed bytes by purpose. */
final class JarContents {
  private static final String SOLVER = "org/mechservice/solver/";

  /**
   * What classes are there for. A class belongs to the first purpose of which one of the paths is
   * the beginning of its own.
   */
  enum Purpose {
    MODEL("the model's own", "org/mechservice/model/", "META-INF/"),
    CHECKPOINTS(
        "checkpoints",
        SOLVER + "ode/SavedState",
        SOLVER + "api/run/Checkpoints",
        SOLVER + "simulation/Checkpoint",
        SOLVER + "simulation/SteppedRun$Saving"),
    STIFFNESS(
        "look for stiffness",
        SOLVER + "analysis/equation/FastSpectrum",
        SOLVER + "api/run/Stiffness",
        SOLVER + "linear/spectrum/",
        SOLVER + "ode/adams/StiffnessMonitor",
        SOLVER + "simulation/LocalMotion",
        SOLVER + "simulation/StiffnessSamples"),
    MESSAGES(
        "messages",
        SOLVER + "api/run/Failure",
        SOLVER + "api/run/RunNotes",
        SOLVER + "catalogue/MessageCode",
        SOLVER + "catalogue/Severity",
        SOLVER + "simulation/FailureText",
        SOLVER + "simulation/MethodNotes",
        SOLVER + "simulation/RunFailures",
        SOLVER + "simulation/RunNoteCollector"),
    METHOD("method of integration", SOLVER + "ode/"),
    RUN("run", SOLVER + "simulation/"),
    OPTIONS("options and results", SOLVER + "catalogue/", SOLVER + "standalone/", SOLVER + "text/"),
    INTERFACE("interface of models", SOLVER + "api/"),
    MECHANICS("mechanics", SOLVER),
    OTHER("other", "");

    private final String label;

    @SuppressWarnings("ImmutableEnumChecker") // not modifiable
    private final List<String> paths;

    Purpose(String label, String... paths) {
      this.label = label;
      this.paths = List.of(paths);
    }

    String label() {
      return label;
    }

    static Purpose of(String path) {
      return Arrays.stream(values())
          .filter(purpose -> purpose.paths.stream().anyMatch(path::startsWith))
          .findFirst()
          .orElse(OTHER);
    }
  }

  private final Map<Purpose, Long> bytes = new EnumMap<>(Purpose.class);
  private long headers;

  private JarContents() {}

  /**
   * Reads the list of a JAR's files.
   *
   * @throws IOException if it is none
   */
  static JarContents of(Path jar) throws IOException {
    JarContents contents = new JarContents();
    contents.headers = Files.size(jar);
    try (ZipFile files = new ZipFile(jar.toFile())) {
      files.stream().forEach(contents::add);
    }
    return contents;
  }

  private void add(ZipEntry file) {
    bytes.merge(Purpose.of(file.getName()), file.getCompressedSize(), Long::sum);
    headers -= file.getCompressedSize();
  }

  /** Returns the compressed bytes of each purpose that the JAR has. */
  Map<Purpose, Long> bytes() {
    return bytes;
  }

  /** Returns what the names of its files and their places take. */
  long headers() {
    return headers;
  }
}
