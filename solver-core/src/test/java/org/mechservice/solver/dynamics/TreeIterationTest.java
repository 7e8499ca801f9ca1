package org.mechservice.solver.dynamics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.LongStream;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.solver.mechanism.RandomTrees;

/** The n equations of an implicit step against the 2n they are reduced from. */
class TreeIterationTest {
  static LongStream seeds() {
    return LongStream.rangeClosed(1, 30);
  }

  /** State, derivatives, and the whole matrix hγ ∂F/∂y + ∂F/∂y' of one tree. */
  private static final class Step {
    final Evaluation at;
    final TreeIteration iteration;
    final double hGamma;
    final RealMatrix whole;

    Step(long seed, double hGamma) {
      this.hGamma = hGamma;
      at = new Evaluation(RandomTrees.ofAllJoints(seed, 1 + (int) (seed % 10))).loaded(seed);
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
      assertThat(iteration.factor(hGamma)).isEqualTo(TreeLu.NONSINGULAR);
      whole = whole(jacobian);
    }

    private RealMatrix whole(ResidualJacobian jacobian) {
      double[] m = new double[at.nv * at.nv];
      jacobian.mass().toDense(m);
      return new WholeStep(at.coordinates, at.y)
          .matrix(
              WholeStep.square(m, at.nv),
              dense(jacobian.byVelocity()),
              dense(jacobian.byPosition()),
              hGamma);
    }

    private RealMatrix dense(TreeSquare square) {
      double[] elements = new double[at.nv * at.nv];
      square.toDense(elements);
      return WholeStep.square(elements, at.nv);
    }
  }

  @MethodSource("seeds")
  @ParameterizedTest
  void matrixIsTheSchurComplementOfTheWhole(long seed) {
    for (double hGamma : new double[] {1e-3, 0.1, 2}) {
      Step step = new Step(seed, hGamma);
      if (step.at.nv == 0) {
        continue;
      }
      RealMatrix schur = WholeStep.schurComplement(step.whole, step.at.nq);
      RealMatrix reduced = step.dense(step.iteration.matrix());
      double error = reduced.subtract(schur).getFrobeniusNorm();
      assertThat(error).isLessThanOrEqualTo(1e-12 * schur.getFrobeniusNorm());
    }
  }

  /** Judged by the residual of the whole equations, as a factorisation is. */
  @MethodSource("seeds")
  @ParameterizedTest
  void solutionObeysTheWholeEquations(long seed) {
    for (double hGamma : new double[] {1e-3, 0.1, 2}) {
      Step step = new Step(seed, hGamma);
      double[] r = new Random(seed).doubles(step.at.y.length, -1, 1).toArray();
      double[] d = r.clone();
      step.iteration.solve(d);
      if (d.length == 0) {
        continue;
      }
      RealVector error =
          step.whole.operate(new ArrayRealVector(d)).subtract(new ArrayRealVector(r));
      double size = step.whole.getFrobeniusNorm() * Evaluation.norm(d) + Evaluation.norm(r);
      assertThat(error.getNorm()).isLessThanOrEqualTo(1e-12 * size);
    }
  }

  @Test
  void matrixWithoutPivotsAlongTheTreeIsFactoredAsADenseOne() {
    Evaluation at = new Evaluation(RandomTrees.tree(3, 6));
    int[] pair = {at.tree.linkOf(2), at.tree.linkOf(5)};
    TreePattern pattern = new TreePattern(at.tree, pair);
    TreeSquare matrix = new TreeSquare(pattern);
    int last = pattern.velocityAt[pattern.size - 1];
    int before = pattern.velocityAt[pattern.column[pattern.rowStart[pattern.size] - 1]];
    for (int i = 0; i < at.nv; i++) {
      matrix.add(i, i, i == last || i == before ? 0 : 2);
    }
    matrix.add(last, before, 1);
    matrix.add(before, last, 4);
    TreeLu lu = new TreeLu(pattern);
    assertThat(lu.factor(matrix)).isEqualTo(TreeLu.NONSINGULAR);
    assertThat(lu.denseFactorizations()).isEqualTo(1);
    double[] b = new double[at.nv];
    b[last] = 3;
    lu.solve(b);
    assertThat(b[before]).isCloseTo(3, within(1e-15));
  }

  @Test
  void singularMatrixNamesAVelocity() {
    Evaluation at = new Evaluation(RandomTrees.tree(3, 4));
    int[] noPairs = {};
    TreePattern pattern = new TreePattern(at.tree, noPairs);
    assertThat(new TreeLu(pattern).factor(new TreeSquare(pattern))).isNotNegative();
  }

  /** Fill by a coupled pair: random elements in the whole pattern, against a dense solution. */
  @MethodSource("seeds")
  @ParameterizedTest
  void coupledBranchesAreEliminatedExactly(long seed) {
    Evaluation at = new Evaluation(RandomTrees.ofAllJoints(seed, 12));
    Random random = new Random(seed);
    int[] pairs = new int[6];
    for (int i = 0; i < pairs.length; i++) {
      pairs[i] = at.tree.linkOf(random.nextInt(12));
    }
    TreePattern pattern = new TreePattern(at.tree, pairs);
    TreeSquare matrix = new TreeSquare(pattern);
    for (int i = 0; i < at.nv; i++) {
      matrix.diagonal[i] = 20 + random.nextDouble();
    }
    for (int e = 0; e < pattern.elementCount(); e++) {
      matrix.lower[e] = random.nextDouble();
      matrix.upper[e] = random.nextDouble();
    }
    double[] elements = new double[at.nv * at.nv];
    matrix.toDense(elements);
    double[][] rows = new double[at.nv][];
    for (int i = 0; i < at.nv; i++) {
      rows[i] = Arrays.copyOfRange(elements, at.nv * i, at.nv * (i + 1));
    }
    double[] b = random.doubles(at.nv).toArray();
    RealVector expected =
        new LUDecomposition(new Array2DRowRealMatrix(rows))
            .getSolver()
            .solve(new ArrayRealVector(b));
    TreeLu lu = new TreeLu(pattern);
    assertThat(lu.factor(matrix)).isEqualTo(TreeLu.NONSINGULAR);
    lu.solve(b);
    for (int i = 0; i < at.nv; i++) {
      assertThat(b[i]).isCloseTo(expected.getEntry(i), within(1e-13));
    }
  }
}
