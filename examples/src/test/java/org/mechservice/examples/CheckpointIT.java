package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
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

  /** A run of minutes that is ended by the operating system's signal, at once and after a while. */
  @CsvSource({"remote, 0", "local, 0", "remote, 1", "local, 1"})
  @ParameterizedTest
  void runThatIsEndedLeavesWhatItsRestNeeds(String mode, int rows) throws Exception {
    Terminal terminal = new Terminal(directory);
    String[] words = {
      "simulate",
      WorkingTree.PENDULUM.toString(),
      "--mode",
      mode,
      "--t-end",
      "20000",
      "--t-step",
      "1",
      "--out"
    };
    List<String> first = new ArrayList<>(List.of(words));
    first.addAll(List.of("first.csv", "--checkpoint", "c"));
    try (Terminal.Running run = terminal.startMech(first.toArray(String[]::new))) {
      run.awaitThat("the file of its rows", () -> bytesSoFar() >= rows);
      run.terminate();
      Terminal.Ended ended = run.awaitEnd();
      assumeTrue(!ended.stdout().contains("completed"), "the run was over before it was ended");
      assertThat(ended.exitStatus()).as(ended.toString()).isEqualTo(143);
    }
    if (!Files.exists(directory.resolve("c"))) {
      // It was ended before it began: there is no row, and nothing to continue.
      assertThat(rows).isZero();
      assertThat(lines(directory.resolve("first.csv"))).isLessThanOrEqualTo(1);
      return;
    }
    List<String> rest = new ArrayList<>(List.of(words));
    rest.addAll(List.of("rest.csv", "--resume", "c", "--quiet"));
    terminal.mech(rest.toArray(String[]::new)).orFail();
    List<String> whole = new ArrayList<>(List.of(words));
    whole.addAll(List.of("whole.csv", "--quiet"));
    terminal.mech(whole.toArray(String[]::new)).orFail();
    List<String> joined = new ArrayList<>(Files.readAllLines(directory.resolve("first.csv")));
    List<String> after = Files.readAllLines(directory.resolve("rest.csv"));
    joined.addAll(after.subList(1, after.size()));
    assertThat(joined).isEqualTo(Files.readAllLines(directory.resolve("whole.csv")));
  }

  /** The model of a server runs behind a wall of its own, which is asked for its checkpoints. */
  @Test
  void modelOfAServerLeavesCheckpointsHereWhileItGoesOn() throws Exception {
    Terminal terminal = new Terminal(directory);
    Path checkpoint = directory.resolve("c");
    int port = Service.freePort();
    try (Terminal.Running server = Service.startServer(directory, port);
        Terminal.Running run =
            terminal.startMech(
                "simulate",
                WorkingTree.PENDULUM.toString(),
                "--server",
                Service.url(port),
                "--mode",
                "local",
                "--unconfined",
                "--t-end",
                "1e8",
                "--t-step",
                "1000",
                "--out",
                "endless.csv",
                "--checkpoint",
                checkpoint.toString(),
                "--every",
                "0.2")) {
      run.awaitThat("its first checkpoint", () -> Files.exists(checkpoint));
      long first = checkpoint.toFile().lastModified();
      run.awaitThat("a later one", () -> checkpoint.toFile().lastModified() > first);
      assertThat(server.stdout()).isNotEmpty();
      run.terminate();
      assertThat(run.awaitEnd().exitStatus()).isEqualTo(143);
    }
  }

  /** Returns the size of the file that becomes first.csv when the command ends; -1: not there. */
  private long bytesSoFar() {
    try (Stream<Path> files = Files.list(directory)) {
      return files
          .filter(file -> file.getFileName().toString().startsWith(".first.csv-"))
          .mapToLong(file -> file.toFile().length())
          .findFirst()
          .orElse(-1);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static long lines(Path file) {
    try (Stream<String> lines = Files.lines(file)) {
      return lines.count();
    } catch (IOException | UncheckedIOException e) {
      return 0;
    }
  }

  /** A run goes on if its checkpoint cannot be written, here for want of room on the disk. */
  @Test
  void checkpointThatCannotBeWrittenIsToldAndTheRunGoesOn() {
    Terminal.Ended ended =
        new Terminal(directory)
            .shell(
                "ulimit -f 4; "
                    + WorkingTree.MECH
                    + " simulate "
                    + BALL
                    + " --checkpoint c --every 0 --quiet >out.txt 2>err.txt; status=$?; ulimit -f"
                    + " unlimited 2>/dev/null; cat err.txt; exit $status");
    assertThat(ended.exitStatus()).as(ended.toString()).isZero();
    assertThat(ended.stdout())
        .contains("S-075 the run goes on without a new checkpoint")
        .doesNotContain("\tat ");
    assertThat(directory.resolve("c")).doesNotExist();
  }

  /** A model that cannot go on keeps the checkpoint from before, and no half of one. */
  @Test
  void runThatFailsKeepsItsLastCheckpoint() throws IOException {
    Files.writeString(
        directory.resolve("m.xml"),
        Files.readString(WorkingTree.PENDULUM)
            .replaceFirst(
                "<Forces>",
                "<Forces><jointForce name=\"f\" joint=\"j1\" expression=\"1/(0.5-t)\"/>"));
    Terminal terminal = new Terminal(directory);
    Terminal.Ended failed =
        terminal.mech("simulate", "m.xml", "--checkpoint", "c", "--every", "0", "--out", "r.csv");
    assertThat(failed.exitStatus()).as(failed.toString()).isEqualTo(1);
    assertThat(failed.stdout() + failed.stderr()).contains("N-003").doesNotContain("\tat ");
    assertThat(directory.resolve("c")).isNotEmptyFile();
    Terminal.Ended again = terminal.mech("simulate", "m.xml", "--resume", "c", "--out", "s.csv");
    assertThat(again.exitStatus()).as(again.toString()).isEqualTo(1);
    assertThat(again.stdout() + again.stderr()).contains("N-003");
  }
}
