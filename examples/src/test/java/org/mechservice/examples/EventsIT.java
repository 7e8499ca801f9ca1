package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * The bouncing ball through the launcher: the report lists the events, the same ones in every mode.
 */
class EventsIT {
  private static final String BALL =
      WorkingTree.TOP.resolve("examples/benchmarks/bouncing_ball.xml").toString();
  private static final Pattern BOUNCE = Pattern.compile("t=(\\S+) s: Event \"bounce\"");

  @TempDir private Path directory;

  @Test
  void bouncesAreReportedWithTimeAndNameAndTheSameEverywhere() {
    Terminal terminal = new Terminal(directory);
    Report remote =
        Report.printedBy(terminal.mech("simulate", BALL, "--out", "remote.csv", "--json"));
    Report local =
        Report.printedBy(
            terminal.mech("simulate", BALL, "--mode", "local", "--out", "local.csv", "--json"));
    terminal.mech("build", BALL, "--standalone", "-o", "ball.jar").orFail();
    terminal.run("java", "-jar", "ball.jar", "--out", "standalone.csv").orFail();

    assertThat(local.text("notes")).isEqualTo(remote.text("notes"));
    assertThat(directory.resolve("local.csv"))
        .hasSameBinaryContentAs(directory.resolve("remote.csv"));
    assertThat(directory.resolve("standalone.csv"))
        .hasSameBinaryContentAs(directory.resolve("remote.csv"));

    Matcher bounces = BOUNCE.matcher(remote.text("notes"));
    double speed = Math.sqrt(2 * 9.81 * 10);
    double expected = speed / 9.81;
    for (int i = 0; i < 12; i++) {
      assertThat(bounces.find()).isTrue();
      assertThat(Double.parseDouble(bounces.group(1))).isCloseTo(expected, within(1e-8));
      speed *= 0.8;
      expected += 2 * speed / 9.81;
    }
    assertThat(bounces.find()).isFalse();
  }
}
