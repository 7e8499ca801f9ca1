package org.mechservice.robot.fuzz;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentSkipListSet;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Files and expressions by the hundred thousand, and what came of them: docs/reports/fuzz.md. */
@Tag("soak")
class FuzzPageTest {
  private static final Path PAGE = Path.of("..", "docs", "reports", "fuzz.md");
  private static final long SEED = Long.getLong("fuzz.seed", 20031);
  private static final int EXAMPLES = 20_000;
  private static final int DRAWN = 20_000;
  private static final int ROBOTS = 10_000;
  private static final int EXPRESSIONS = 300_000;

  /** Files after which every class that reading needs has been asked for. */
  private static final int FIRST = 500;

  private final List<String> page = new ArrayList<>();

  /** Notes what is asked of the loader that code of a file's choice could only come through. */
  private static final class Witness extends ClassLoader {
    private final Set<String> asked = new ConcurrentSkipListSet<>();

    Witness(ClassLoader parent) {
      super(parent);
    }

    @Override
    protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
      asked.add(name);
      return super.loadClass(name, resolve);
    }
  }

  @Test
  void nothingButModelsAndMessagesComesOfFiles() throws IOException {
    Thread thread = Thread.currentThread();
    ClassLoader before = thread.getContextClassLoader();
    Witness witness = new Witness(before);
    thread.setContextClassLoader(witness);
    try {
      FuzzCampaign campaign = new FuzzCampaign(SEED);
      campaign.damagedExamples(FIRST);
      campaign.drawnFiles(FIRST);
      campaign.damagedRobots(FIRST);
      Set<String> needed = new TreeSet<>(witness.asked);
      campaign.damagedExamples(EXAMPLES - FIRST);
      campaign.drawnFiles(DRAWN - FIRST);
      campaign.damagedRobots(ROBOTS - FIRST);
      assertThat(witness.asked).isEqualTo(needed);
      ExpressionCampaign texts = new ExpressionCampaign(SEED);
      texts.texts(EXPRESSIONS);
      ExpressionCampaign expressions = new ExpressionCampaign(SEED);
      expressions.expressions(EXPRESSIONS);
      write(campaign, texts, expressions);
    } finally {
      thread.setContextClassLoader(before);
    }
    assertThat(PAGE).content().contains("Seed " + SEED);
  }

  private void write(FuzzCampaign files, ExpressionCampaign texts, ExpressionCampaign expressions)
      throws IOException {
    line("# Files and expressions at random");
    line("");
    line(
        "Written on %s by `mvn verify -Psoak`: %s %s, %d cores at load %.1f, Java %s. Seed %d;"
            + " `-Dfuzz.seed=N` takes another.",
        LocalDate.now(ZoneOffset.UTC),
        System.getProperty("os.name"),
        System.getProperty("os.arch"),
        Runtime.getRuntime().availableProcessors(),
        ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage(),
        System.getProperty("java.version"),
        SEED);
    line("");
    line("Every file is read, or refused with messages that have a code and name nothing of the");
    line(
        "program; anything else would fail the test. No class is looked for but those that the first");
    line("%d files of each kind need. A slice of this runs in `mvn verify`.", FIRST);
    line("");
    line("| files | read | refused | most memory for one | longest time for one |");
    line("|---|---|---|---|---|");
    row("the examples, damaged in one to four places", files.examples());
    row("drawn from the grammar, a third of them damaged", files.drawn());
    row("a robot in URDF, damaged", files.robots());
    line("");
    line("| expressions | with a value | refused |");
    line("|---|---|---|");
    line("| words in any order | %d | %d |", texts.finite(), texts.refused());
    line(
        "| right ones: the value is that worked out while they were drawn, to the last bit, and they"
            + " are refused where there is none | %d | %d |",
        expressions.finite(), expressions.refused());
    line("");
    line("Files that each message was about:");
    line("");
    line("| message | examples | drawn | robots |");
    line("|---|---|---|---|");
    Set<String> codes = new TreeSet<>(files.examples().codes().keySet());
    codes.addAll(files.drawn().codes().keySet());
    codes.addAll(files.robots().codes().keySet());
    for (String code : codes) {
      line(
          "| [%s](../errors/%s.md) | %d | %d | %d |",
          code,
          code,
          times(files.examples().codes(), code),
          times(files.drawn().codes(), code),
          times(files.robots().codes(), code));
    }
    Files.write(PAGE, page);
  }

  private static int times(Map<String, Integer> codes, String code) {
    return codes.getOrDefault(code, 0);
  }

  private void row(String what, Ordeal ordeal) {
    line(
        "| %s | %d | %d | %.0f MB | %.1f s |",
        what, ordeal.read(), ordeal.refused(), ordeal.mostMegabytes(), ordeal.slowest());
  }

  private void line(String format, Object... values) {
    page.add(String.format(Locale.ROOT, format, values));
  }
}
