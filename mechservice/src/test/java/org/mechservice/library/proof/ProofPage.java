package org.mechservice.library.proof;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.List;
import java.util.Locale;

/** The part of a report page that the sets write, between two marks in its text. */
final class ProofPage {
  private static final String BEGIN = "<!-- sets -->\n";
  private static final String END = "<!-- end of sets -->\n";

  private ProofPage() {}

  /** Writes the tables of some runs into a page; the rest of it stays. */
  static void write(Path page, List<SetRun> runs) throws IOException {
    String text = Files.readString(page);
    int begin = text.indexOf(BEGIN);
    int end = text.indexOf(END);
    if (begin < 0 || end < begin) {
      throw new IllegalStateException("the page " + page + " has lost its marks");
    }
    Files.writeString(
        page, text.substring(0, begin) + BEGIN + tables(runs) + text.substring(end));
  }

  private static String tables(List<SetRun> runs) {
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
