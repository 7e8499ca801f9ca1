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
import org.mechservice.solver.force.applied.ForceJacobian;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.mechanism.RandomTrees;

/** Elimination from link to link against the matrix formed element by element. */
class ArticulatedIterationTest {
  /** Rounding of two ways to the same elements, relative to the largest terms of a row. */
  private static final double ROUNDING = 1e-11;

  static LongStream seeds() {
    return LongStream.rangeClosed(1, 40);
  }

  private static final class Step {
    final Evaluation at;
    final ArticulatedIteration articulated;
    final TreeIteration elements;
    final RealMatrix matrix;

    Step(long seed, double hGamma) {
      at = new Evaluation(RandomTrees.ofAllJoints(seed, 1 + (int) (seed % 12))).loaded(seed);
      for (int i = 0; i < at.nv; i++) {
        at.y[at.nq + i] *= 10;
      }
      at.motion.sweep(0, at.y);
      at.motion.accelerationSweep(new Random(seed).doubles(at.nv, -3, 3).toArray());
      TreePattern pattern = new TreePattern(at.tree, pairs());
      ResidualJacobian jacobian = new ResidualJacobian(at.motion, pattern);
      jacobian.evaluate(at.wrench);
      addForces(seed, jacobian.forces());
      jacobian.finish();
      elements = new TreeIteration(at.tree, pattern, jacobian);
      articulated = new ArticulatedIteration(at.motion);
      articulated.evaluate(at.wrench);
      addForces(seed, articulated.forces());
      articulated.finish();
      for (StepReduction each : new StepReduction[] {elements, articulated}) {
        each.setState(at.y);
        assertThat(each.factor(hGamma)).isTrue();
      }
      double[] dense = new double[at.nv * at.nv];
      elements.matrix().toDense(dense);
      matrix = WholeStep.square(dense, at.nv);
      assertThat(articulated.isFinite()).isTrue();
    }

    private int[] pairs() {
      TreeGeometry tree = at.tree;
      int[] pairs = new int[2 * tree.linkCount];
      for (int link = 0; link < tree.linkCount; link++) {
        pairs[2 * link] = link;
        pairs[2 * link + 1] = tree.parent[link];
      }
      return pairs;
    }

    /** Springs and dampers of no law in particular, on each link, to its parent, and in joints. */
    private void addForces(long seed, ForceJacobian sink) {
      Random random = new Random(seed);
      TreeGeometry tree = at.tree;
      for (int link = 0; link < tree.linkCount; link++) {
        int parent = tree.parent[link];
        addWrench(random, sink, link, link);
        if (parent != TreeGeometry.ROOT && random.nextBoolean()) {
          addWrench(random, sink, link, parent);
          addWrench(random, sink, parent, link);
        }
        int end = tree.velocityAt[link] + tree.kind[link].velocityCount();
        for (int k = tree.velocityAt[link]; k < end; k++) {
          sink.forceByCoordinate(k, tree.velocityAt[link], -random.nextDouble(), -10);
        }
      }
    }

    private static void addWrench(Random random, ForceJacobian sink, int on, int by) {
      sink.wrenchByLink(
          on, by, random.doubles(36, -1, 1).toArray(), random.doubles(36, -1, 1).toArray());
    }
  }

  @MethodSource("seeds")
  @ParameterizedTest
  void productIsThatOfTheMatrix(long seed) {
    for (double hGamma : new double[] {1e-3, 0.1, 2}) {
      Step step = new Step(seed, hGamma);
      double[] x = new Random(seed).doubles(step.at.nv, -1, 1).toArray();
      double[] product = new double[x.length];
      step.articulated.addMatrixProduct(1, x, product);
      requireSmall(step, product, x);
      double[] places = new double[x.length];
      double[] expected = new double[x.length];
      step.articulated.addByPosition(-2, x, places);
      step.elements.addByPosition(-2, x, expected);
      double size = Evaluation.norm(expected) + step.matrix.getFrobeniusNorm();
      for (int i = 0; i < x.length; i++) {
        assertThat(Math.abs(places[i] - expected[i])).isLessThanOrEqualTo(ROUNDING * size);
      }
    }
  }

  private static void requireSmall(Step step, double[] product, double[] x) {
    if (x.length == 0) {
      return;
    }
    RealVector error =
        step.matrix.operate(new ArrayRealVector(x)).subtract(new ArrayRealVector(product));
    double size = step.matrix.getFrobeniusNorm() * Evaluation.norm(x) + Evaluation.norm(product);
    assertThat(error.getNorm()).isLessThanOrEqualTo(ROUNDING * size);
  }

  /** Judged by the residual of the equations, as a factorisation is. */
  @MethodSource("seeds")
  @ParameterizedTest
  void solutionObeysTheEquations(long seed) {
    for (double hGamma : new double[] {1e-3, 0.1, 2}) {
      Step step = new Step(seed, hGamma);
      double[] r = new Random(seed).doubles(step.at.nv, -1, 1).toArray();
      double[] x = r.clone();
      step.articulated.solveReduced(x);
      requireSmall(step, r, x);
    }
  }

  /** Steps whose positions have residuals too, and masses alone while the factors stay. */
  @MethodSource("seeds")
  @ParameterizedTest
  void stepsAndDerivativesAreThoseOfTheElements(long seed) {
    Step step = new Step(seed, 0.01);
    double[] r = new Random(seed).doubles(step.at.nq + step.at.nv, -1, 1).toArray();
    double[] expected = r.clone();
    double[] found = r.clone();
    assertThat(step.elements.solveForDerivative(expected)).isTrue();
    assertThat(step.articulated.solveForDerivative(found)).isTrue();
    requireEqual(found, expected);
    expected = r.clone();
    found = r.clone();
    step.elements.solve(expected);
    step.articulated.solve(found);
    requireEqual(found, expected);
  }

  /** The condition of random trees of twelve bodies costs up to five digits. */
  private static void requireEqual(double[] found, double[] expected) {
    double largest = Arrays.stream(expected).map(Math::abs).max().orElse(0);
    for (int i = 0; i < found.length; i++) {
      assertThat(Math.abs(found[i] - expected[i])).isLessThanOrEqualTo(1e-10 * largest);
    }
  }
}
