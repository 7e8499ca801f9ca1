package org.mechservice.solver.dynamics.derivative;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.LongStream;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.solver.dynamics.Evaluation;
import org.mechservice.solver.dynamics.WholeStep;
import org.mechservice.solver.dynamics.tree.TreePattern;
import org.mechservice.solver.dynamics.tree.TreeSquare;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.RandomTrees;

/** The n equations of an implicit step against the 2n they are reduced from. */
class TreeIterationTest {
  static LongStream seeds() {
    return LongStream.rangeClosed(1, 30);
  }

  private static Mechanism tree(long seed) {
    return RandomTrees.ofAllJoints(seed, 1 + (int) (seed % 10));
  }

  /** Seeds of trees that are not welded as a whole: those have nothing to solve for. */
  static LongStream moving() {
    return LongStream.iterate(1, seed -> seed + 1)
        .filter(seed -> tree(seed).velocityCount() > 0)
        .limit(30);
  }

  /** State, derivatives, and the whole matrix hγ ∂F/∂y + ∂F/∂y' of one tree. */
  private static final class Step {
    final Evaluation at;
    final TreeIteration iteration;
    final double hGamma;
    final RealMatrix whole;
    final RealMatrix mass;

    Step(long seed, double hGamma) {
      this.hGamma = hGamma;
      at = new Evaluation(tree(seed)).loaded(seed);
      for (int i = 0; i < at.nv; i++) {
        at.y[at.nq + i] *= 10;
      }
      // Euler parameters need not have norm 1
      for (int ball = 0; ball < at.coordinates.ballCount(); ball++) {
        at.y[at.coordinates.ballPosition(ball)] += 1e-3;
      }
      at.motion.sweep(0, at.y);
      at.motion.accelerationSweep(new Random(seed).doubles(at.nv, -3, 3).toArray());
      int[] noPairs = {};
      TreePattern pattern = new TreePattern(at.tree, noPairs);
      ResidualJacobian jacobian = new ResidualJacobian(at.motion, pattern);
      jacobian.evaluate(at.wrench);
      jacobian.finish();
      iteration = new TreeIteration(at.tree, pattern, jacobian);
      iteration.setState(at.y);
      assertThat(iteration.factor(hGamma)).isTrue();
      double[] m = new double[at.nv * at.nv];
      jacobian.mass().toDense(m);
      mass = WholeStep.square(m, at.nv);
      whole = whole(jacobian);
    }

    private RealMatrix whole(ResidualJacobian jacobian) {
      return new WholeStep(at.coordinates, at.y)
          .matrix(mass, dense(jacobian.byVelocity()), dense(jacobian.byPosition()), hGamma);
    }

    private RealMatrix dense(TreeSquare square) {
      double[] elements = new double[at.nv * at.nv];
      square.toDense(elements);
      return WholeStep.square(elements, at.nv);
    }
  }

  @MethodSource("moving")
  @ParameterizedTest
  void matrixIsTheSchurComplementOfTheWhole(long seed) {
    for (double hGamma : new double[] {1e-3, 0.1, 2}) {
      Step step = new Step(seed, hGamma);
      RealMatrix schur = WholeStep.schurComplement(step.whole, step.at.nq);
      RealMatrix reduced = step.dense(step.iteration.matrix());
      double error = reduced.subtract(schur).getFrobeniusNorm();
      assertThat(error).isLessThanOrEqualTo(1e-12 * schur.getFrobeniusNorm());
    }
  }

  /** Judged by the residual of the whole equations, as a factorisation is. */
  @MethodSource("moving")
  @ParameterizedTest
  void solutionObeysTheWholeEquations(long seed) {
    for (double hGamma : new double[] {1e-3, 0.1, 2}) {
      Step step = new Step(seed, hGamma);
      double[] r = new Random(seed).doubles(step.at.y.length, -1, 1).toArray();
      double[] d = r.clone();
      step.iteration.solve(d);
      RealVector error =
          step.whole.operate(new ArrayRealVector(d)).subtract(new ArrayRealVector(r));
      double size = step.whole.getFrobeniusNorm() * Evaluation.norm(d) + Evaluation.norm(r);
      assertThat(error.getNorm()).isLessThanOrEqualTo(1e-12 * size);
    }
  }

  @MethodSource("seeds")
  @ParameterizedTest
  void derivativesAreSolvedForWithTheMassesAloneAndTheFactorsStay(long seed) {
    Step step = new Step(seed, 0.1);
    int nq = step.at.nq;
    double[] r = new Random(seed).doubles(step.at.y.length, -1, 1).toArray();
    double[] before = r.clone();
    step.iteration.solve(before);
    double[] d = r.clone();
    assertThat(step.iteration.solveForDerivative(d)).isTrue();
    double[] after = r.clone();
    step.iteration.solve(after);
    assertThat(after).isEqualTo(before);
    assertThat(Arrays.copyOf(d, nq)).isEqualTo(Arrays.copyOf(r, nq));
    if (step.at.nv == 0) {
      return;
    }
    double[] solution = Arrays.copyOfRange(d, nq, d.length);
    double[] right = Arrays.copyOfRange(r, nq, d.length);
    RealVector error =
        step.mass.operate(new ArrayRealVector(solution)).subtract(new ArrayRealVector(right));
    double size = step.mass.getFrobeniusNorm() * Evaluation.norm(solution) + Evaluation.norm(right);
    assertThat(error.getNorm()).isLessThanOrEqualTo(1e-12 * size);
  }
}
