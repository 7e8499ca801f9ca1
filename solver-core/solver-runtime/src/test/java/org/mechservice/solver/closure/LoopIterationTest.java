package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.LongStream;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.RealMatrix;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.closure.model.LinearisedProjectionModel;
import org.mechservice.solver.closure.model.Partition;
import org.mechservice.solver.dynamics.WholeStep;
import org.mechservice.solver.dynamics.tree.TreeSquare;
import org.mechservice.solver.mechanism.Mechanism;

/** The equations of an implicit step on closed loops against the whole they are reduced from. */
class LoopIterationTest {
  /** Seeds of mechanisms that move. */
  static LongStream seeds() {
    return LongStream.rangeClosed(1, 40)
        .filter(seed -> LoopComparison.leftOut(LoopComparison.mechanism(seed)).isEmpty());
  }

  private static LinearisedProjectionModel model(Mechanism mechanism) {
    return (LinearisedProjectionModel)
        LoopModels.of(mechanism, "RR-JF", SceneRun.settings(1, 0.1, "ode15sR", 1e-8));
  }

  /** Derivatives at the start, but for a change of v' along the loops. */
  private static double[] derivatives(LinearisedProjectionModel model, double[] y, long seed) {
    double[] yDot = new double[y.length];
    assertThat(model.derivative(0, y, yDot)).isEqualTo(ExplicitModel.REGULAR);
    Random random = new Random(seed);
    for (int k = model.work.nq; k < y.length; k++) {
      yDot[k] += random.nextDouble() - 0.5;
    }
    return yDot;
  }

  private static RealMatrix dense(TreeSquare square, int n) {
    double[] elements = new double[n * n];
    square.toDense(elements);
    return WholeStep.square(elements, n);
  }

  /** Motions of the open tree that keep the loops closed: 1 and −J_D⁻¹ J_I. */
  private static RealMatrix motionsAlong(LinearisedProjectionModel model) {
    Partition partition = model.completion.ofVelocities();
    int n = model.work.nv;
    int r = partition.rank();
    RealMatrix along = MatrixUtils.createRealMatrix(n, partition.freedom());
    for (int j = 0; j < partition.freedom(); j++) {
      along.setEntry(partition.independent[j], j, 1);
    }
    if (r == 0) {
      return along;
    }
    RealMatrix dependent = MatrixUtils.createRealMatrix(r, r);
    RealMatrix independent = MatrixUtils.createRealMatrix(r, partition.freedom());
    for (int i = 0; i < r; i++) {
      int row = partition.kept[i];
      for (int j = 0; j < r; j++) {
        dependent.setEntry(i, j, model.work.loops.jacobian.get(row, partition.dependent[j]));
      }
      for (int j = 0; j < partition.freedom(); j++) {
        independent.setEntry(i, j, -model.work.loops.jacobian.get(row, partition.independent[j]));
      }
    }
    RealMatrix carried = new LUDecomposition(dependent).getSolver().solve(independent);
    for (int i = 0; i < r; i++) {
      along.setRow(partition.dependent[i], carried.getRow(i));
    }
    return along;
  }

  @MethodSource("seeds")
  @ParameterizedTest
  void matrixIsTheSchurComplementOfTheWholeAlongTheLoops(long seed) {
    LinearisedProjectionModel model = model(LoopComparison.mechanism(seed));
    double[] y = model.closed.start().state();
    double[] yDot = derivatives(model, y, seed);
    int nq = model.work.nq;
    int n = model.work.nv;
    for (double hGamma : new double[] {1e-3, 0.1, 2}) {
      assertThat(model.linearise(0, y, yDot)).isTrue();
      RealMatrix along = motionsAlong(model);
      assertThat(model.factor(hGamma)).isTrue();
      double[] mass = new double[n * n];
      model.jacobian().mass().toDense(mass);
      RealMatrix whole =
          new WholeStep(model.work.coordinates, y)
              .matrix(
                  WholeStep.square(mass, n),
                  dense(model.jacobian().byVelocity(), n),
                  dense(model.jacobian().byPosition(), n),
                  hGamma);
      RealMatrix schur = WholeStep.schurComplement(whole, nq);
      RealMatrix expected = along.transpose().multiply(schur).multiply(along);
      RealMatrix reduced = WholeStep.square(model.reduced(), model.closed.freedom());
      double error = reduced.subtract(expected).getFrobeniusNorm();
      double size = along.getFrobeniusNorm() * schur.getFrobeniusNorm() * along.getFrobeniusNorm();
      assertThat(error).isLessThanOrEqualTo(1e-12 * size);
    }
  }

  /** ∂(M v' + b − τ + Jᵀ λ)/∂q for fixed v', v and λ, by differences of sixth order. */
  @MethodSource("seeds")
  @ParameterizedTest
  void derivativeByPositionsHoldsThatOfTheLoopsForces(long seed) {
    LinearisedProjectionModel model = model(LoopComparison.mechanism(seed));
    double[] y = model.closed.start().state();
    double[] yDot = derivatives(model, y, seed);
    assertThat(model.linearise(0, y, yDot)).isTrue();
    int n = model.work.nv;
    double[] a = model.acceleration.clone();
    double[] lambda = model.lambda.clone();
    double[] exact = new double[n * n];
    model.jacobian().byPosition().toDense(exact);
    double difference = 0;
    double size = 0;
    for (int j = 0; j < n; j++) {
      double[] slope = slope(model, y, a, lambda, j);
      for (int i = 0; i < n; i++) {
        difference = Math.hypot(difference, slope[i] - exact[i * n + j]);
        size = Math.hypot(size, exact[i * n + j]);
      }
    }
    // the differences round at 1e-12 of the forces even where the block is zero
    double forces = 1 + Arrays.stream(lambda).map(Math::abs).max().orElse(0);
    assertThat(difference).isLessThanOrEqualTo(1e-9 * Math.max(size, 1e-2 * forces));
  }

  private static double[] slope(
      LinearisedProjectionModel model, double[] y, double[] a, double[] lambda, int j) {
    double[] h1 = central(model, y, a, lambda, j, 4e-3);
    double[] h2 = central(model, y, a, lambda, j, 2e-3);
    double[] h4 = central(model, y, a, lambda, j, 1e-3);
    double[] slope = new double[h1.length];
    Arrays.setAll(
        slope,
        i -> {
          double fine = h4[i] + (h4[i] - h2[i]) / 3;
          double coarse = h2[i] + (h2[i] - h1[i]) / 3;
          return fine + (fine - coarse) / 15;
        });
    return slope;
  }

  private static double[] central(
      LinearisedProjectionModel model, double[] y, double[] a, double[] lambda, int j, double h) {
    double[] ahead = force(model, y, a, lambda, j, h);
    double[] behind = force(model, y, a, lambda, j, -h);
    double[] slope = new double[ahead.length];
    Arrays.setAll(slope, i -> (ahead[i] - behind[i]) / (2 * h));
    return slope;
  }

  /** M v' + b − τ + Jᵀ λ where one coordinate has moved, of the open tree: loops may be open. */
  private static double[] force(
      LinearisedProjectionModel model, double[] y, double[] a, double[] lambda, int j, double h) {
    ClosedTree work = model.work;
    double[] moved = y.clone();
    double[] step = new double[work.nv];
    step[j] = h;
    work.coordinates.move(moved, 0, step, 0, 1);
    work.place(0, moved);
    double[] force = new double[work.tree.velocityCount];
    assertThat(work.formResidual(0, a, 0, force)).isTrue();
    for (int row = 0; row < lambda.length; row++) {
      for (int k = 0; k < work.nv; k++) {
        force[k] += lambda[row] * work.loops.jacobian.get(row, k);
      }
    }
    return Arrays.copyOf(force, work.nv);
  }
}
