package org.mechservice.library.proof;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Random scenes in which something happens for a short time or over a short way: no result is wrong
 * without a word. Every build runs a slice of each set; {@code mvn verify -Psoak} runs them whole
 * and writes their tables into the page.
 */
@Tag("slow")
class NothingPassedOverTest {
  private static final Path PAGE = Path.of("..", "docs", "reports", "nothing-passed-over.md");

  /** Where models are written that are not right. */
  private static final Path MISSED = Path.of("target", "nothing-passed-over");

  private static final int EXPORTED = 60;

  static Stream<ProofSet> sets() {
    return RunSets.SETS.stream();
  }

  @ParameterizedTest
  @MethodSource("sets")
  void nothingIsWrongInSilence(ProofSet set) throws Exception {
    SetRun run = SetRun.of(set, set.slice());
    run.writeMissed(MISSED);
    assertThat(run.silent()).as("%s%n%s", set.title(), run.table()).isEmpty();
  }

  /** Scenes that showed what others of their sets did not, each another cause. */
  @ParameterizedTest
  @CsvSource({
    "short ways, 19", // eight knots in a row are not a choice that hovers
    "short ways, 213", // a change at the very end of a step
    "short ways, 239", // a table whose argument jumps with a floor
    "short ways, 281", // an interpolant that does not begin in the state of a restart
    "short ways, 292", // an argument finer than time
    "short ways, 467", // a square along a curved way through zero
    "roads, 739", // a minimum within a maximum, whose hollow the sphere meets early
    "one-sided elements, 127", // masses by differences that had become too small while all was calm
    "pulses in time, 28", // a place in time that rounding hides, of a jump
    "pulses in time, 64", // a cubic table between two knots
    "pulses in time, 155", // a drive known to rounding where it begins
    "pulses in time, 311" // the same of a drive whose argument is coarser than time
  })
  void sceneOfACauseIsRight(String title, long seed) throws Exception {
    ProofSet set =
        RunSets.SETS.stream().filter(one -> one.title().equals(title)).findFirst().orElseThrow();
    SetRun run = SetRun.of(set, LongStream.of(seed));
    assertThat(run.all().right).as(run.table()).isEqualTo(1);
  }

  /** Every sixth scene of a slice, so that it is quick: each starts another Java machine. */
  @ParameterizedTest
  @MethodSource("sets")
  void nothingIsWrongInSilenceAsJar(ProofSet set, @TempDir Path folder) throws Exception {
    LongStream seeds = set.slice().filter(seed -> seed % 6 == 1);
    SetRun run = SetRun.of(set, seeds, scene -> ExportedScene.jar(scene, folder));
    assertThat(run.silent()).as("%s as JAR%n%s", set.title(), run.table()).isEmpty();
  }

  @ParameterizedTest
  @MethodSource("sets")
  void nothingIsWrongInSilenceAsUnit(ProofSet set, @TempDir Path folder) throws Exception {
    assumeTrue(ExportedScene.hasCompiler(), "this machine has no C compiler");
    LongStream seeds = set.slice().filter(seed -> seed % 6 == 1);
    SetRun run = SetRun.of(set, seeds, scene -> ExportedScene.unit(scene, 7, folder));
    assertThat(run.silent()).as("%s as unit%n%s", set.title(), run.table()).isEmpty();
  }

  /** Both forms of 60 scenes of each set, and 7 steps of communication or 100. */
  @Test
  @Tag("soak")
  void nothingIsWrongInSilenceInManyExports(@TempDir Path folder) throws Exception {
    StringBuilder rows = new StringBuilder();
    List<SetRun.Missed> silent = new ArrayList<>();
    for (ProofSet set : RunSets.SETS) {
      LongStream seeds = LongStream.rangeClosed(1, EXPORTED);
      SetRun jars = SetRun.of(set, seeds, scene -> ExportedScene.jar(scene, folder));
      rows.append(jars.all().row(set.title() + ", standalone JAR"));
      silent.addAll(jars.silent());
      for (int steps : new int[] {7, 100}) {
        SetRun units =
            SetRun.of(
                set,
                LongStream.rangeClosed(1, EXPORTED),
                scene -> ExportedScene.unit(scene, steps, folder));
        rows.append(units.all().row("%s, Co-Simulation in %d steps".formatted(set.title(), steps)));
        silent.addAll(units.silent());
      }
    }
    ProofPage.write(PAGE, "exports", SetRun.HEAD + rows);
    assertThat(silent).isEmpty();
  }

  @Test
  @Tag("soak")
  void nothingIsWrongInSilenceInTheWholeSets() throws Exception {
    List<SetRun> runs = new ArrayList<>();
    for (ProofSet set : RunSets.SETS) {
      SetRun run = SetRun.of(set, LongStream.rangeClosed(1, set.size()));
      run.writeMissed(MISSED);
      runs.add(run);
    }
    ProofPage.write(PAGE, "sets", ProofPage.tables(runs));
    assertThat(runs.stream().flatMap(run -> run.silent().stream())).isEmpty();
  }

  /** Writes the hits with their right ends for {@code benchmarks/peers/hits.py}. */
  @Test
  @Tag("soak")
  void writesTheHitsForOtherPrograms() throws Exception {
    ProofSet hits = new Hits();
    for (long seed = 1; seed <= hits.size(); seed++) {
      Optional<Scene> scene = hits.scene(seed);
      if (scene.isPresent()) {
        scene.get().write(MISSED.resolve("hits"), Long.toString(seed));
      }
    }
    assertThat(MISSED.resolve("hits").resolve("1.csv")).exists();
  }
}
