package org.mechservice.library.proof;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Random scenes in which something happens for a short time or over a short way: no result is wrong
 * without a word. Every build runs a slice of each set.
 */
class NothingPassedOverTest {
  /** Seeds of a slice: each kind of scene at least once. */
  private static final int SLICE = 24;

  static Stream<ProofSet> sets() {
    return RunSets.SETS.stream();
  }

  @ParameterizedTest
  @MethodSource("sets")
  void nothingIsWrongInSilence(ProofSet set) throws Exception {
    SetRun run = SetRun.of(set, LongStream.rangeClosed(1, SLICE));
    List<SetRun.Missed> silent = run.silent();
    assertThat(silent).as("%s, seeds 1 to %d%n%s", set.title(), SLICE, run.table()).isEmpty();
  }
}
