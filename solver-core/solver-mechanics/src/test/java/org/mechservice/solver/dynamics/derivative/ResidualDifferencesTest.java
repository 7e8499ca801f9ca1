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
  static LongStream seeds() {
    return LongStream.rangeClosed(1, 40);
  }

  /** A tree at a state, with the accelerations for which its forces are differenced. */
  private static final class Case {
    final Evaluation at;
    final TreePattern pattern;
    final double[] accelerations;
    final double[] unit;
    int evaluations;

    Case(long seed) {
      Random random = new Random(seed);
      at = new Evaluation(RandomTrees.withRods(seed, 1 + (int) (seed % 15), (int) (seed % 3)));
      pattern = new TreePattern(at.tree, new MassiveRods(at.tree).pairs());
      accelerations = random.doubles(at.nv, -3, 3).toArray();
      unit = random.doubles(at.nv, 0.5, 2).toArray();
    }

    boolean forces(double[] y, double[] force) {
      evaluations++;
      at.motion.sweep(0, y);
      System.arraycopy(at.residual(accelerations), 0, force, 0, at.nv);
      return true;
    }

    ResidualJacobian differences() {
      ResidualJacobian jacobian = new ResidualJacobian(at.motion, pattern);
      var differences = new ResidualDifferences(jacobian, at.coordinates, pattern, at.nv);
      assertThat(differences.evaluate(at.y, unit, this::forces)).isTrue();
      return jacobian;
    }

    int velocitiesThatMove(int place) {
      int below = pattern.rowStart[place + 1] - pattern.rowStart[place];
      IntStream outer = IntStream.range(place + 1, at.nv);
      int above = (int) outer.filter(row -> pattern.find(row, place) >= 0).count();
      return 1 + below + above;
    }
  }

  /** A column that shares its evaluation has the bits that it has alone. */
  @MethodSource("seeds")
  @ParameterizedTest
  void everyColumnIsThatOfItsOwnDifference(long seed) {
    Case tree = new Case(seed);
    double[] together = new double[tree.at.nv * tree.at.nv];
    tree.differences().byPosition().toDense(together);
    double[] base = new double[tree.at.nv];
    tree.forces(tree.at.y, base);
    for (int j = 0; j < tree.at.nv; j++) {
      double[] direction = new double[tree.at.nv];
      direction[j] = tree.unit[j];
      double[] moved = tree.at.y.clone();
      double part = 0x1p-26;
      tree.at.coordinates.move(moved, 0, direction, 0, part);
      double[] force = new double[tree.at.nv];
      tree.forces(moved, force);
      for (int i = 0; i < tree.at.nv; i++) {
        assertThat(together[i * tree.at.nv + j])
            .isEqualTo((force[i] - base[i]) / (part * tree.unit[j]));
      }
    }
  }

  /** Half the digits of a difference quotient are lost; the analytic derivatives have them all. */
  @MethodSource("seeds")
  @ParameterizedTest
  void derivativesAreTheAnalyticOnesToHalfTheDigits(long seed) {
    Case tree = new Case(seed);
    double[] byVelocity = new double[tree.at.nv * tree.at.nv];
    tree.differences().byVelocity().toDense(byVelocity);
    tree.at.motion.sweep(0, tree.at.y);
    tree.at.motion.accelerationSweep(tree.accelerations);
    ResidualJacobian analytic = new ResidualJacobian(tree.at.motion, tree.pattern);
    analytic.evaluate(new double[6 * tree.at.tree.linkCount]);
    analytic.finish();
    double[] exact = new double[tree.at.nv * tree.at.nv];
    analytic.byVelocity().toDense(exact);
    double scale = Evaluation.norm(exact) + Evaluation.norm(tree.at.residual(tree.accelerations));
    double[] error = new double[exact.length];
    Arrays.setAll(error, i -> exact[i] - byVelocity[i]);
    assertThat(Evaluation.norm(error)).isLessThanOrEqualTo(1e-6 * Math.max(1, scale));
  }

  /** The velocities that move one force take an evaluation each. */
  @MethodSource("seeds")
  @ParameterizedTest
  void evaluationsLieBetweenThoseOfTheFullestRowAndOnePairForEachVelocity(long seed) {
    Case tree = new Case(3 * seed);
    tree.differences();
    int fullest = IntStream.range(0, tree.at.nv).map(tree::velocitiesThatMove).max().orElse(0);
    assertThat(tree.evaluations).isBetween(1 + 2 * fullest, 1 + 2 * tree.at.nv);
  }
}
