package org.mechservice.library.proof;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.List;
import java.util.Locale;

/** The part of a report page that the sets write, between two marks in its text. */
public final class ProofPage {
  private ProofPage() {}

  /**
   * Writes a part of a page; the rest of it stays.
   *
   * @param name of the part in its marks
   */
  public static void write(Path page, String name, String part) throws IOException {
    String text = Files.readString(page);
    String begin = "<!-- " + name + " -->\n";
    int from = text.indexOf(begin);
    int to = text.indexOf("<!-- end of " + name + " -->");
    if (from < 0 || to < from) {
      throw new IllegalStateException("the page " + page + " has lost its marks of " + name);
    }
    Files.writeString(page, text.substring(0, from) + begin + part + text.substring(to));
  }

  /** Returns a table of all sets, and one of each. */
  static String tables(List<SetRun> runs) {
    StringBuilder text = new StringBuilder();
    text.append(
        String.format(
            Locale.ROOT,
            "Written on %s by `NothingPassedOverTest` under `mvn verify -Psoak`, %s %s, Java %s.%n%n",
            LocalDate.now(ZoneOffset.UTC),
            System.getProperty("os.name"),
            System.getProperty("os.arch"),
            System.getProperty("java.version")));
    text.append("| set | scenes | right | told | wrong in silence | before: wrong in silence |\n");
    text.append("|---|---|---|---|---|---|\n");
    for (SetRun run : runs) {
      SetRun.Counts all = run.all();
      text.append(
          String.format(
              Locale.ROOT,
              "| %s, seeds 1 to %d | %d | %d | %d | %d | %s |%n",
              run.set().title(),
              run.set().size(),
              all.right + all.told + all.silent,
              all.right,
              all.told,
              all.silent,
              run.set().before()));
    }
    for (SetRun run : runs) {
      String title = run.set().title();
      text.append("\n### ").append(title.substring(0, 1).toUpperCase(Locale.ROOT));
      text.append(title.substring(1)).append("\n\n").append(run.table());
    }
    return text.toString();
  }
}
