package org.mechservice.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.cli.shell.ExitStatus;

/** Reports of scenes that come with the product, through the embedded service. */
@Tag("soak")
class ReportCommandTest {
  private static final Path EXAMPLES = Path.of("..", "examples");

  @TempDir Path folder;

  private static int mech(String... words) {
    StringWriter ignored = new StringWriter();
    return Mech.run(new PrintWriter(ignored), new PrintWriter(ignored), words);
  }

  private String quickPage(String model) throws IOException {
    Path file = EXAMPLES.resolve(model);
    assertThat(mech("report", file.toString(), "-o", folder.toString(), "--quick"))
        .isEqualTo(ExitStatus.DONE);
    String name = file.getFileName().toString().replace(".xml", ".html");
    String page = Files.readString(folder.resolve(name));
    return page.replaceFirst("(?s)<style>.*?</style>", ""); // one for all pages
  }

  @Test
  void pageOfThePendulumRecommendsRaisesNoDoubtAndSaysNothingOfLoops() throws IOException {
    assertThat(quickPage("pendulum/pendulum.xml"))
        .contains("Recommendation", "Not stiff", "the one that comes with the product")
        .doesNotContain("class=\"doubt\"", "projection");
  }

  @Test
  void pageOfTheOverdampedSpringCallsItStiff() throws IOException {
    assertThat(quickPage("extremes/stiff_1e9_c1e5.xml"))
        .contains("<b>Stiff.</b>", "best implicit method wins")
        .doesNotContain("class=\"doubt\"");
  }

  @Test
  void pageOfTheBouncingBallMeasuresEveryMethodThoughTheStateJumps() throws IOException {
    String page = quickPage("benchmarks/bouncing_ball.xml");
    assertThat(page)
        .contains("the state jumps 12 times", "by event &quot;bounce&quot;", "RR-JF ode15sR")
        .doesNotContain("class=\"doubt\"");
    assertThat(Files.readAllLines(folder.resolve("bouncing_ball.csv")).stream().skip(2))
        .isNotEmpty()
        .noneMatch(run -> run.contains(",NaN,NaN,NaN,NaN,NaN,NaN,"));
  }

  @Test
  void reportThatIsTakenUpAgainTakesTheReferenceFromItsFile() throws IOException {
    quickPage("benchmarks/bouncing_ball.xml");
    Path file = folder.resolve("bouncing_ball-reference.csv");
    Files.writeString(file, Files.readString(file).replaceFirst("# Reference: .*", "# Kept."));
    assertThat(quickPage("benchmarks/bouncing_ball.xml")).contains("<li>Kept.");
  }

  @Test
  void reportIsTakenUpAgainWithTheSameCodeOnly() throws IOException {
    quickPage("benchmarks/bouncing_ball.xml");
    Path file = folder.resolve("bouncing_ball.csv");
    List<String> lines = Files.readAllLines(file);
    String kept = lines.get(lines.size() - 1).replaceFirst("^[^,]*", "kept");
    Files.writeString(file, String.join("\n", lines) + "\n" + kept + "\n");
    quickPage("benchmarks/bouncing_ball.xml");
    assertThat(Files.readAllLines(file)).contains(kept);
    Files.writeString(file, Files.readString(file).replaceFirst("; code \\w+", "; code other"));
    quickPage("benchmarks/bouncing_ball.xml");
    assertThat(Files.readAllLines(file)).doesNotContain(kept).hasSameSizeAs(lines);
  }

  @Test
  void extremeScenesEndAsExpected() {
    assertThat(mech("stability", "-o", folder.toString())).isEqualTo(ExitStatus.DONE);
  }
}
