package org.mechservice.library.proof;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Random scenes in which something happens for a short time or over a short way: no result is wrong
 * without a word. Every build runs a slice of each set; {@code mvn verify -Psoak} runs them whole
 * and writes their tables into the page.
 */
class NothingPassedOverTest {
  private static final Path PAGE = Path.of("..", "docs", "reports", "nothing-passed-over.md");

  /** Where models are written that are not right. */
  private static final Path MISSED = Path.of("target", "nothing-passed-over");

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

  @Test
  @Tag("soak")
  void nothingIsWrongInSilenceInTheWholeSets() throws Exception {
    List<SetRun> runs = new ArrayList<>();
    for (ProofSet set : RunSets.SETS) {
      SetRun run = SetRun.of(set, LongStream.rangeClosed(1, set.size()));
      run.writeMissed(MISSED);
      runs.add(run);
    }
    ProofPage.write(PAGE, runs);
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
