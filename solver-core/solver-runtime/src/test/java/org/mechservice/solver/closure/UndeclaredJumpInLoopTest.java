package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.closure.JumpingLoops.Law;
import org.mechservice.solver.closure.JumpingLoops.Side;

/**
 * A closed loop in which a force of which only values are known jumps, or is too steep for any
 * step, moves as it should up to where the run is refused; hardly a run slides along the jump, or
 * sticks where it should have broken loose.
 */
@Tag("slow")
class UndeclaredJumpInLoopTest {
  /** Tolerances by which a run of some hundred steps may err, if nothing becomes of its errors. */
  private static final double STEPS = 1000;

  /**
   * What friction does within the width of its law, in widths: a joint that sticks is so far beside
   * a belt, or another one behind a gear, at every row.
   */
  private static final double WIDTHS = 100;

  private static final int ROWS = 50;

  /**
   * Loops in which runs went wrong before what is left of their equations was looked at; 34 and 44,
   * and likewise 35, 42 and 50, are in the long run.
   */
  private static final long[] SLID = {37, 53};

  private static final long[] STUCK = {17, 71, 118};

  /** Likewise, before it was looked at how much of each equation an iteration had mended. */
  private static final long[] HELD = {20, 23, 31, 52};

  /** A loop on whose belt an explicit method bounced. */
  private static final long CREPT = 12;

  /** Loops that stops lead far away from the exact motion; 8, 19 and 29 are in the long run. */
  private static final long[] CARRIED_AWAY = {1, 11, 34};

  /** Multipliers or not, loops stick and break loose when they should. */
  @ParameterizedTest
  @CsvSource({"RR penalty, ode15sR", "RR-JF penalty, ode15sR"})
  void loopsWithMultipliersBreakLooseInTime(String formulation, String integrator) {
    assertThat(wrong(Law.STEEP, formulation, integrator, LongStream.of(STUCK))).isEmpty();
  }

  @ParameterizedTest
  @CsvSource({"DSR, ode15s", "RR, ode15sR", "RR-JF, ode15sR"})
  void loopsInIndependentCoordinatesBreakLooseInTime(String formulation, String integrator) {
    assertThat(wrong(Law.STEEP, formulation, integrator, LongStream.of(HELD))).isEmpty();
  }

  /** What a jump has made of a Jacobian does not excuse what it leaves unsolved. */
  @ParameterizedTest
  @CsvSource({
    "DSR, ode15s",
    "DSR penalty, ode15s",
    "RR penalty, ode15sR",
    "RR-JF penalty, ode15sR"
  })
  void noLoopSlidesAlongTheSignOfAVelocity(String formulation, String integrator) {
    assertThat(wrong(Law.SIGN, formulation, integrator, LongStream.of(SLID))).isEmpty();
  }

  /** An explicit method to which the law is a jump crosses it again and again: a million steps. */
  @Test
  void theChangeOfMethodsDoesNotCreepAlongASteepLaw() {
    JumpingLoops scene = new JumpingLoops(Law.STEEP, CREPT);
    RunSettings settings =
        new RunSettings(
            0,
            scene.end(),
            scene.end() / ROWS,
            "switching",
            5.561403180379128e-6,
            5.561403180379128e-5);
    SceneRun run = LoopModels.runSearched(scene.mechanism(Side.OWN), "DSR", settings);
    assertThat(run.report.outcome()).isEqualTo(new Outcome.Completed());
    assertThat(committed(scene, settings, run)).isLessThan(1);
    // A thousand crossings are evidence; each takes some steps.
    assertThat(run.report.steps()).isLessThan(10_000);
  }

  @ParameterizedTest
  @CsvSource({"RR, ode15sR", "RR-JF, ode15sR", "RR penalty, ode15sR", "RR-JF penalty, ode15sR"})
  void jumpsInTimeAndInPlaceAreFollowed(String formulation, String integrator) {
    assertThat(wrong(Law.BANG_BANG, formulation, integrator, LongStream.range(0, 2))).isEmpty();
    assertThat(wrong(Law.STAIRS, formulation, integrator, LongStream.range(0, 2))).isEmpty();
  }

  /** They end 2 to 25 times as far away as the errors of their steps add up to. */
  @ParameterizedTest
  @CsvSource({"DSR, ode15s", "RR, ode15sR", "RR-JF, ode15sR", "RR penalty, ode15sR"})
  void whatStiffStopsMakeOfErrorsIsTheMotionsOwn(String formulation, String integrator) {
    assertThat(wrong(Law.STOP, formulation, integrator, LongStream.of(CARRIED_AWAY))).isEmpty();
  }

  /** At most one run in {@code rarely} is wrong; 0: none. */
  @Tag("soak")
  @ParameterizedTest
  @CsvSource({
    "DSR, ode15s, 60",
    "DSR penalty, ode15s, 60",
    "RR, ode15sR, 60",
    "RR-JF, ode15sR, 60",
    "RR penalty, ode15sR, 0",
    "RR-JF penalty, ode15sR, 0"
  })
  void inTheLongRunLoopsRarelyGoWrong(String formulation, String integrator, int rarely) {
    int runs = 60;
    for (Law law : Law.values()) {
      List<String> wrong = wrong(law, formulation, integrator, LongStream.range(0, runs));
      boolean steep = law == Law.STEEP && rarely > 0;
      assertThat(wrong).hasSizeLessThanOrEqualTo(steep ? runs / rarely : 0);
    }
  }

  private static List<String> wrong(
      Law law, String formulation, String integrator, LongStream seeds) {
    return seeds
        .mapToObj(seed -> wrong(law, seed, formulation, integrator))
        .flatMap(Optional::stream)
        .toList();
  }

  /** Describes a run that errs by more than its tolerances, and its motion, explain. */
  private static Optional<String> wrong(Law law, long seed, String formulation, String integrator) {
    Random random = new Random((1000 + seed) * 0x9E3779B97F4A7C15L);
    double relative = StrictMath.pow(10, -3 - 6 * random.nextDouble());
    double absolute = relative * StrictMath.pow(10, random.nextInt(3) - 1);
    JumpingLoops scene = new JumpingLoops(law, seed);
    double distance = scene.end() / ROWS;
    RunSettings settings =
        new RunSettings(0, scene.end(), distance, integrator, relative, absolute);
    SceneRun run = LoopModels.runSearched(scene.mechanism(Side.OWN), formulation, settings);
    double committed = committed(scene, settings, run);
    return committed <= 1
        ? Optional.empty()
        : Optional.of(
            seed + ": " + scene + " by " + settings + " errs by " + committed + " of all allowed");
  }

  /**
   * Returns the errors that a run makes, as a part of those allowed: how far each of its rows is
   * from where the exact motion leads from the row before. What a motion makes of them later is not
   * the run's doing: each tolerance may have become a hundred on a staircase within some seconds.
   * Rows after a refusal are missing.
   */
  private static double committed(JumpingLoops scene, RunSettings settings, SceneRun run) {
    ExactMotion motion = ExactMotion.of(scene);
    List<double[]> rows = run.rows;
    // A stiff stop takes thousands of steps, and what it makes of errors it does between two rows.
    double steps = scene.law() == Law.STOP ? Math.max(STEPS, (double) run.report.steps()) : STEPS;
    double committed = 0;
    for (int r = 1; r < rows.size(); r++) {
      double[] before = rows.get(r - 1);
      double[] row = rows.get(r);
      double[] exact =
          motion.after(before[0], Arrays.copyOfRange(before, 1, before.length), row[0]);
      double tolerance =
          Math.max(settings.absoluteTolerance(), settings.relativeTolerance() * size(exact));
      double error = difference(row, exact) - WIDTHS * scene.width();
      committed += Math.max(0, error) / (steps * tolerance);
    }
    return committed;
  }

  private static double size(double[] state) {
    return Math.max(1, Arrays.stream(state).map(Math::abs).max().orElseThrow());
  }

  /** Returns the largest difference of a row's state from another; infinite if one is no number. */
  private static double difference(double[] row, double[] exact) {
    double difference = 0;
    for (int i = 0; i < exact.length; i++) {
      double error = Math.abs(row[i + 1] - exact[i]);
      difference = Math.max(difference, Double.isNaN(error) ? Double.POSITIVE_INFINITY : error);
    }
    return difference;
  }
}
