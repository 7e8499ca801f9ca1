package org.mechservice.solver.dynamics.derivative;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import java.util.function.Function;
import java.util.stream.LongStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.solver.dynamics.Evaluation;
import org.mechservice.solver.dynamics.recursion.MassiveRods;
import org.mechservice.solver.dynamics.tree.TreePattern;
import org.mechservice.solver.mechanism.RandomTrees;

/**
 * Analytic derivatives of the residual against central differences with Richardson's extrapolation,
 * on trees of all joints with up to two rods, under wrenches that turn with their links.
 */
class ResidualJacobianTest {
  /** Bound of the differences, as a part of the norm of the block. */
  private static final double BOUND = 1e-9;

  static LongStream seeds() {
    return LongStream.rangeClosed(1, 40);
  }

  private static Evaluation at(long seed) {
    int bodies = 1 + (int) (seed % 9);
    int rods = (int) (seed % 3);
    return new Evaluation(RandomTrees.withRods(seed, bodies, rods)).loaded(seed);
  }

  private static double[] accelerations(Evaluation at, long seed) {
    return new Random(seed).doubles(at.nv, -3, 3).toArray();
  }

  private static ResidualJacobian jacobian(Evaluation at, double[] a) {
    at.motion.accelerationSweep(a);
    int[] pairs = new MassiveRods(at.tree).pairs();
    ResidualJacobian jacobian = new ResidualJacobian(at.motion, new TreePattern(at.tree, pairs));
    jacobian.evaluate(at.wrench);
    jacobian.finish();
    return jacobian;
  }

  @MethodSource("seeds")
  @ParameterizedTest
  void derivativeByPositionsIsThatOfDifferences(long seed) {
    Evaluation at = at(seed);
    double[] a = accelerations(at, seed);
    double[] exact = new double[at.nv * at.nv];
    jacobian(at, a).byPosition().toDense(exact);
    double[] y = at.y.clone();
    double[] differences =
        differences(
            at.nv,
            step -> {
              double[] moved = y.clone();
              at.coordinates.move(moved, 0, step, 0, 1);
              at.motion.sweep(0, moved);
              return at.residual(a);
            });
    assertClose(exact, differences);
  }

  @MethodSource("seeds")
  @ParameterizedTest
  void derivativeByVelocitiesIsThatOfDifferences(long seed) {
    Evaluation at = at(seed);
    double[] a = accelerations(at, seed);
    double[] exact = new double[at.nv * at.nv];
    jacobian(at, a).byVelocity().toDense(exact);
    double[] y = at.y.clone();
    double[] differences =
        differences(
            at.nv,
            step -> {
              double[] moved = y.clone();
              for (int i = 0; i < at.nv; i++) {
                moved[at.nq + i] += step[i];
              }
              at.motion.sweep(0, moved);
              return at.residual(a);
            });
    assertClose(exact, differences);
  }

  @MethodSource("seeds")
  @ParameterizedTest
  void derivativeByAccelerationsIsTheMassMatrix(long seed) {
    Evaluation at = at(seed);
    double[] exact = new double[at.nv * at.nv];
    double[] alone = new double[at.nv * at.nv];
    double[] semiRecursive = new double[at.nv * at.nv];
    ResidualJacobian jacobian = jacobian(at, accelerations(at, seed));
    jacobian.mass().toDense(exact);
    jacobian.evaluateMass();
    jacobian.mass().toDense(alone);
    at.semiRecursive().massMatrix().toDense(semiRecursive);
    assertThat(exact).containsExactly(semiRecursive);
    assertThat(alone).containsExactly(semiRecursive);
  }

  /** Returns ∂f/∂x at 0 column by column: (16 D(h) − D(2h)) … of fourth and sixth order terms. */
  private static double[] differences(int n, Function<double[], double[]> f) {
    double[] columns = new double[n * n];
    for (int j = 0; j < n; j++) {
      double[] h1 = central(n, j, 4e-3, f);
      double[] h2 = central(n, j, 2e-3, f);
      double[] h4 = central(n, j, 1e-3, f);
      for (int i = 0; i < n; i++) {
        double fine = h4[i] + (h4[i] - h2[i]) / 3;
        double coarse = h2[i] + (h2[i] - h1[i]) / 3;
        columns[n * i + j] = fine + (fine - coarse) / 15;
      }
    }
    return columns;
  }

  private static double[] central(int n, int j, double h, Function<double[], double[]> f) {
    double[] step = new double[n];
    step[j] = h;
    double[] ahead = f.apply(step);
    step[j] = -h;
    double[] behind = f.apply(step);
    double[] slope = new double[n];
    for (int i = 0; i < n; i++) {
      slope[i] = (ahead[i] - behind[i]) / (2 * h);
    }
    return slope;
  }

  private static void assertClose(double[] exact, double[] differences) {
    double[] error = new double[exact.length];
    for (int i = 0; i < error.length; i++) {
      error[i] = exact[i] - differences[i];
    }
    // the differences round at 1e-12 even where the block is zero
    double size = Math.max(1e-2, Evaluation.norm(exact));
    assertThat(Evaluation.norm(error)).isLessThanOrEqualTo(BOUND * size);
  }
}
