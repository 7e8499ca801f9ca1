package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A run saved with --checkpoint and continued with --resume. */
class CheckpointIT {
  private static final String BALL =
      WorkingTree.TOP.resolve("examples/benchmarks/bouncing_ball.xml").toString();

  @TempDir private Path directory;

  @ValueSource(strings = {"remote", "local"})
  @ParameterizedTest
  void restOfARunIsTheSameToTheBit(String mode) throws IOException {
    Terminal terminal = new Terminal(directory);
    String[] first = {
      "simulate", BALL, "--mode", mode, "--out", "all.csv", "--checkpoint", "c", "--every", "0"
    };
    terminal.mech(first).orFail();
    terminal
        .mech("simulate", BALL, "--mode", mode, "--out", "rest.csv", "--resume", "c", "--quiet")
        .orFail();

    List<String> all = Files.readAllLines(directory.resolve("all.csv"));
    List<String> rest = Files.readAllLines(directory.resolve("rest.csv"));
    int missing = all.size() - rest.size();
    assertThat(rest.get(0)).isEqualTo(all.get(0));
    assertThat(rest).hasSizeGreaterThan(1);
    assertThat(rest.subList(1, rest.size())).isEqualTo(all.subList(1 + missing, all.size()));
  }

  @Test
  void checkpointOfAnotherModelAndRowsThatWouldBeLostAreRefused() {
    Terminal terminal = new Terminal(directory);
    String[] first = {"simulate", BALL, "--mode", "local", "--checkpoint", "c", "--every", "0"};
    terminal.mech(first).orFail();

    String pendulum = WorkingTree.PENDULUM.toString();
    Terminal.Ended other =
        terminal.mech("simulate", pendulum, "--out", "rest.csv", "--resume", "c");
    assertThat(other.exitStatus()).isEqualTo(2);
    assertThat(other.stderr()).contains("S-071").contains("bouncing_ball");

    terminal.mech("simulate", BALL, "--out", "all.csv").orFail();
    Terminal.Ended lost = terminal.mech("simulate", BALL, "--out", "all.csv", "--resume", "c");
    assertThat(lost.exitStatus()).isEqualTo(2);
    assertThat(lost.stderr()).contains("S-074");
  }
}
