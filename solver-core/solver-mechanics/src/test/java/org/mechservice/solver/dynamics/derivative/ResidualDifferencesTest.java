package org.mechservice.solver.dynamics.derivative;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.solver.dynamics.Evaluation;
import org.mechservice.solver.dynamics.recursion.MassiveRods;
import org.mechservice.solver.dynamics.tree.TreePattern;
import org.mechservice.solver.mechanism.RandomTrees;

/** Differences of several columns at a time, on trees of all joints with up to two rods. */
class ResidualDifferencesTest {
  private final Random random = new Random(7);
  private Evaluation at;
  private TreePattern pattern;
  private double[] accelerations;
  private double[] unit;
  private int evaluations;

  static LongStream seeds() {
    return LongStream.rangeClosed(1, 40);
  }

  private void make(long seed) {
    at = new Evaluation(RandomTrees.withRods(seed, 1 + (int) (seed % 15), (int) (seed % 3)));
    pattern = new TreePattern(at.tree, new MassiveRods(at.tree).pairs());
    accelerations = random.doubles(at.nv, -3, 3).toArray();
    unit = random.doubles(at.nv, 0.5, 2).toArray();
    evaluations = 0;
  }

  private boolean forces(double[] y, double[] force) {
    evaluations++;
    at.motion.sweep(0, y);
    System.arraycopy(at.residual(accelerations), 0, force, 0, at.nv);
    return true;
  }

  private ResidualJacobian differences() {
    ResidualJacobian jacobian = new ResidualJacobian(at.motion, pattern);
    var differences = new ResidualDifferences(jacobian, at.coordinates, pattern, at.nv);
    assertThat(differences.evaluate(at.y, unit, this::forces)).isTrue();
    return jacobian;
  }

  /** A column that shares its evaluation has the bits that it has alone. */
  @MethodSource("seeds")
  @ParameterizedTest
  void everyColumnIsThatOfItsOwnDifference(long seed) {
    make(seed);
    double[] together = new double[at.nv * at.nv];
    differences().byPosition().toDense(together);
    double[] base = new double[at.nv];
    forces(at.y, base);
    for (int j = 0; j < at.nv; j++) {
      double[] direction = new double[at.nv];
      direction[j] = unit[j];
      double[] moved = at.y.clone();
      double part = 0x1p-26;
      at.coordinates.move(moved, 0, direction, 0, part);
      double[] force = new double[at.nv];
      forces(moved, force);
      for (int i = 0; i < at.nv; i++) {
        assertThat(together[i * at.nv + j]).isEqualTo((force[i] - base[i]) / (part * unit[j]));
      }
    }
  }

  /** Half the digits of a difference quotient are lost; the analytic derivatives have them all. */
  @MethodSource("seeds")
  @ParameterizedTest
  void derivativesAreTheAnalyticOnesToHalfTheDigits(long seed) {
    make(seed);
    double[] byVelocity = new double[at.nv * at.nv];
    differences().byVelocity().toDense(byVelocity);
    at.motion.sweep(0, at.y);
    at.motion.accelerationSweep(accelerations);
    ResidualJacobian analytic = new ResidualJacobian(at.motion, pattern);
    analytic.evaluate(new double[6 * at.tree.linkCount]);
    analytic.finish();
    double[] exact = new double[at.nv * at.nv];
    analytic.byVelocity().toDense(exact);
    double scale = Evaluation.norm(exact) + Evaluation.norm(at.residual(accelerations));
    double[] error = new double[exact.length];
    Arrays.setAll(error, i -> exact[i] - byVelocity[i]);
    assertThat(Evaluation.norm(error)).isLessThanOrEqualTo(1e-6 * Math.max(1, scale));
  }

  /** The velocities that move one force take an evaluation each. */
  @MethodSource("seeds")
  @ParameterizedTest
  void evaluationsLieBetweenThoseOfTheFullestRowAndOnePairForEachVelocity(long seed) {
    make(3 * seed);
    differences();
    int fullest = IntStream.range(0, at.nv).map(this::velocitiesThatMove).max().orElse(0);
    assertThat(evaluations).isBetween(1 + 2 * fullest, 1 + 2 * at.nv);
  }

  private int velocitiesThatMove(int place) {
    int below = pattern.rowStart[place + 1] - pattern.rowStart[place];
    int above =
        (int)
            IntStream.range(place + 1, at.nv).filter(row -> pattern.find(row, place) >= 0).count();
    return 1 + below + above;
  }
}
