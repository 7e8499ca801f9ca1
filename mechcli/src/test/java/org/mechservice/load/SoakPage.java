package org.mechservice.load;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** A page of docs/reports: what was done, what was counted, with which seed, on what machine. */
public final class SoakPage {
  private static final Path REPORTS = Path.of("../docs/reports");

  private final List<String> lines = new ArrayList<>();

  /**
   * @param what the paragraph that says what was done
   * @param seed where the random choices begin
   */
  public SoakPage(String title, String what, long seed) {
    lines.add("# " + title + "\n");
    lines.add(what + "\n");
    lines.add(
        String.format(
            Locale.ROOT,
            "Measured on %s by `mvn verify -Psoak`: seed %d; JDK %s, %s %s, %s, %d processors.%n",
            LocalDate.now(ZoneOffset.UTC),
            seed,
            Runtime.version(),
            System.getProperty("os.name"),
            System.getProperty("os.version"),
            processor(),
            Runtime.getRuntime().availableProcessors()));
  }

  private static String processor() {
    try {
      return Files.readAllLines(Path.of("/proc/cpuinfo")).stream()
          .filter(line -> line.startsWith("model name"))
          .map(line -> line.substring(line.indexOf(':') + 1).strip())
          .findFirst()
          .orElse("processor unknown");
    } catch (IOException e) {
      return "processor unknown";
    }
  }

  /** Adds a line of text, or of a table. */
  public SoakPage line(String format, Object... values) {
    lines.add(String.format(Locale.ROOT, format, values));
    return this;
  }

  /** Writes the page. */
  public void write(String name) throws IOException {
    Files.createDirectories(REPORTS);
    Files.writeString(REPORTS.resolve(name), String.join("\n", lines) + "\n");
  }
}
