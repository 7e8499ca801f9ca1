package org.mechservice.solver.dynamics.derivative;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.LongStream;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;
import org.apache.commons.math3.linear.SingularValueDecomposition;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.solver.dynamics.Evaluation;
import org.mechservice.solver.dynamics.WholeStep;
import org.mechservice.solver.dynamics.tree.TreePattern;
import org.mechservice.solver.force.applied.ForceJacobian;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.RandomTrees;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/** Elimination from link to link against the matrix formed element by element. */
class ArticulatedIterationTest {
  /** Rounding of two ways to the same elements, relative to the largest terms of a row. */
  private static final double ROUNDING = 1e-11;

  static LongStream seeds() {
    return LongStream.rangeClosed(1, 40);
  }

  private static Mechanism tree(long seed) {
    return RandomTrees.ofAllJoints(seed, 1 + (int) (seed % 12));
  }

  /** Seeds of trees that are not welded as a whole: those have nothing to solve for. */
  static LongStream moving() {
    return LongStream.iterate(1, seed -> seed + 1)
        .filter(seed -> tree(seed).velocityCount() > 0)
        .limit(40);
  }

  private static final class Step {
    final Evaluation at;
    final ArticulatedIteration articulated;
    final TreeIteration elements;
    final RealMatrix matrix;

    /** Links that forces couple, two for each pair, and rows of a loop. */
    final int[] coupled;

    final LoopWrenches rows;

    Step(long seed, double hGamma) {
      this(seed, hGamma, false, false);
    }

    /**
     * @param far whether forces act between any links and by the coordinates of any joint
     * @param loops whether there are rows of loops
     */
    Step(long seed, double hGamma, boolean far, boolean loops) {
      at = new Evaluation(tree(seed)).loaded(seed);
      for (int i = 0; i < at.nv; i++) {
        at.y[at.nq + i] *= 10;
      }
      at.motion.sweep(0, at.y);
      at.motion.accelerationSweep(new Random(seed).doubles(at.nv, -3, 3).toArray());
      coupled = pairs(seed, far);
      rows = rows(loops);
      TreePattern pattern = new TreePattern(at.tree, coupled);
      ResidualJacobian jacobian = new ResidualJacobian(at.motion, pattern);
      jacobian.evaluate(at.wrench);
      addForces(seed, jacobian.forces());
      jacobian.finish();
      elements = new TreeIteration(at.tree, pattern, jacobian);
      LinkJacobian byLinks =
          far ? new LinkJacobian(at.motion, coupled) : new LinkJacobian(at.motion);
      byLinks.evaluate(at.wrench);
      addForces(seed, byLinks.forces());
      byLinks.finish();
      articulated = new ArticulatedIteration(byLinks, rows);
      at.motion.sweep(0, new double[at.y.length]); // the derivatives stay where they were formed
      for (StepReduction each : new StepReduction[] {elements, articulated}) {
        each.setState(at.y);
        boolean withRows = rows.count() > 0 && each instanceof ArticulatedIteration;
        assertThat(withRows || each.factor(hGamma)).isTrue();
      }
      double[] dense = new double[at.nv * at.nv];
      elements.matrix().toDense(dense);
      matrix = WholeStep.square(dense, at.nv);
      assertThat(byLinks.isFinite()).isTrue();
    }

    /** Each link and its parent, and from each link to another one. */
    private int[] pairs(long seed, boolean far) {
      TreeGeometry tree = at.tree;
      Random random = new Random(-seed);
      int[] pairs = new int[far ? 4 * tree.linkCount : 2 * tree.linkCount];
      for (int link = 0; link < tree.linkCount; link++) {
        pairs[2 * link] = link;
        pairs[2 * link + 1] = tree.parent[link];
        if (far) {
          pairs[2 * (tree.linkCount + link)] = link;
          pairs[2 * (tree.linkCount + link) + 1] = random.nextInt(tree.linkCount);
        }
      }
      return pairs;
    }

    /** Rows between the first and last link and of the first and last velocity. */
    private LoopWrenches rows(boolean loops) {
      int last = at.tree.linkCount - 1;
      if (!loops || last < 0 || at.nv == 0) {
        return LoopWrenches.NONE;
      }
      int[] ends = last == 0 ? new int[] {0} : new int[] {0, last};
      int[] velocities = at.nv == 1 ? new int[] {0} : new int[] {0, at.nv - 1};
      return new LoopWrenches(new int[][] {ends, {last}}, new int[][] {{}, velocities});
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
      addFarForces(random, sink);
    }

    /** Wrenches by motions, and by coordinates, and joint forces by both. */
    private void addFarForces(Random random, ForceJacobian sink) {
      TreeGeometry tree = at.tree;
      for (int i = 2 * tree.linkCount; i < coupled.length; i += 2) {
        int on = coupled[i];
        int by = coupled[i + 1];
        addWrench(random, sink, on, by);
        addWrench(random, sink, by, on);
        for (int k = tree.velocityAt[by]; k < tree.velocityAt[by] + count(by); k++) {
          sink.wrenchByCoordinate(on, k, numbers(random, 6), numbers(random, 6));
          for (int j = tree.velocityAt[on]; j < tree.velocityAt[on] + count(on); j++) {
            sink.forceByCoordinate(j, k, random.nextDouble(), random.nextDouble());
          }
        }
        for (int j = tree.velocityAt[on]; j < tree.velocityAt[on] + count(on); j++) {
          sink.forceByLink(j, by, numbers(random, 6), numbers(random, 6));
        }
      }
    }

    /** Returns the row of J by velocities: the joint forces of wrenches on the links of the row. */
    private double[] jointForces(int row, double[] wrenches, double[] forces) {
      double[] sum = new double[at.nv];
      for (int link : rows.links[row]) {
        double[] w = Arrays.copyOfRange(wrenches, 6 * link, 6 * link + 6);
        for (int i = link; i != TreeGeometry.ROOT; i = at.tree.parent[i]) {
          for (int k = at.tree.velocityAt[i]; k < at.tree.velocityAt[i] + count(i); k++) {
            sum[k] += PlacedLinks.dot6(at.motion.subspace, 6 * k, w, 0);
          }
          at.motion.wrenches.toParent(i, w, 0);
        }
      }
      for (int k : rows.velocities[row]) {
        sum[k] += forces[k];
      }
      return sum;
    }

    private int count(int link) {
      return at.tree.kind[link].velocityCount();
    }

    private static double[] numbers(Random random, int count) {
      return random.doubles(count, -1, 1).toArray();
    }

    private static void addWrench(Random random, ForceJacobian sink, int on, int by) {
      sink.wrenchByLink(
          on, by, random.doubles(36, -1, 1).toArray(), random.doubles(36, -1, 1).toArray());
    }
  }

  @MethodSource("moving")
  @ParameterizedTest
  void productIsThatOfTheMatrix(long seed) {
    for (double hGamma : new double[] {1e-3, 0.1, 2}) {
      requireProduct(seed, new Step(seed, hGamma));
      requireProduct(seed, new Step(seed, hGamma, true, false));
    }
  }

  private static void requireProduct(long seed, Step step) {
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

  private static void requireSmall(Step step, double[] product, double[] x) {
    RealVector error =
        step.matrix.operate(new ArrayRealVector(x)).subtract(new ArrayRealVector(product));
    double size = step.matrix.getFrobeniusNorm() * Evaluation.norm(x) + Evaluation.norm(product);
    assertThat(error.getNorm()).isLessThanOrEqualTo(ROUNDING * size);
  }

  /** Judged by the residual of the equations, as a factorisation is. */
  @MethodSource("moving")
  @ParameterizedTest
  void solutionObeysTheEquations(long seed) {
    for (double hGamma : new double[] {1e-3, 0.1, 2}) {
      for (Step step : new Step[] {new Step(seed, hGamma), new Step(seed, hGamma, true, false)}) {
        double[] r = new Random(seed).doubles(step.at.nv, -1, 1).toArray();
        double[] x = r.clone();
        step.articulated.solveReduced(x);
        requireSmall(step, r, x);
      }
    }
  }

  /** Forces and loops between any links: A x + Jᵀ λ = r and J x = λ / α − g. */
  @MethodSource("seeds")
  @ParameterizedTest
  void solutionWithLoopsObeysTheEquations(long seed) {
    solvesWithLoops(seed);
  }

  /** Two thirds of the trees have room for independent rows. */
  @Test
  void enoughLoopsAreSolved() {
    assertThat(seeds().filter(ArticulatedIterationTest::solvesWithLoops).count()).isGreaterThan(20);
  }

  /** Returns whether the rows of loops have a solution, which is checked for every step. */
  private static boolean solvesWithLoops(long seed) {
    int solved = 0;
    for (double hGamma : new double[] {1e-3, 0.1, 2}) {
      Step step = new Step(seed, hGamma, true, true);
      Random random = new Random(seed);
      int m = step.rows.count();
      RealMatrix j = MatrixUtils.createRealMatrix(Math.max(1, m), Math.max(1, step.at.nv));
      step.at.motion.sweep(0, step.at.y);
      for (int row = 0; row < m; row++) {
        double[] wrenches = Step.numbers(random, 6 * step.at.tree.linkCount);
        double[] forces = Step.numbers(random, step.at.tree.velocityCount);
        j.setRow(row, step.jointForces(row, wrenches, forces));
        step.rows.take(row, wrenches, forces);
      }
      double[] r = Step.numbers(random, step.at.nv);
      double[] gap = Step.numbers(random, m);
      double[] x = r.clone();
      double[] lambda = gap.clone();
      assertThat(step.articulated.factorWithRows(hGamma, new double[] {1e12, 1e12})).isTrue();
      step.articulated.solveWithRows(x, lambda);
      // rows that repeat each other, or that no joint obeys, have no solution without α
      if (m > 0
          && m <= step.at.nv
          && new SingularValueDecomposition(j).getInverseConditionNumber() > 0.01) {
        RealVector pushed =
            new ArrayRealVector(r).subtract(j.preMultiply(new ArrayRealVector(lambda)));
        requireSmall(step, pushed.toArray(), x);
        RealVector left = j.operate(new ArrayRealVector(x)).add(new ArrayRealVector(gap));
        double size = j.getFrobeniusNorm() * Evaluation.norm(x) + Evaluation.norm(gap);
        // 1/α leaves 1e-12 of what the inertias allow
        assertThat(left.getNorm()).isLessThanOrEqualTo(1e-9 * size);
        solved++;
      }
    }
    return solved == 3;
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

  /** The matrix of this chain would have 9 million elements. */
  @Test
  void aChainOf3000LinksIsSolvedFromLinkToLink() {
    Evaluation at = new Evaluation(chain(3000));
    assertThat(ArticulatedIteration.pays(at.tree)).isTrue();
    at.motion.sweep(0, at.y);
    at.motion.accelerationSweep(new Random(1).doubles(at.nv, -3, 3).toArray());
    LinkJacobian byLinks = new LinkJacobian(at.motion);
    byLinks.evaluate(at.wrench);
    for (int k = 0; k < at.nv; k++) {
      byLinks.forces().forceByCoordinate(k, k, -1e5, -1e3);
    }
    byLinks.finish();
    ArticulatedIteration articulated = new ArticulatedIteration(byLinks);
    articulated.setState(at.y);
    assertThat(articulated.factor(1e-3)).isTrue();
    assertThat(articulated.denseFactorizations()).isZero();
    double[] x = new Random(2).doubles(at.nv, -1, 1).toArray();
    double[] b = new double[at.nv];
    articulated.addMatrixProduct(1, x, b);
    articulated.solveReduced(b);
    // the condition of the chain's matrix, some 1e6, times rounding
    for (int k = 0; k < at.nv; k++) {
      assertThat(Math.abs(b[k] - x[k])).isLessThanOrEqualTo(1e-8);
    }
  }

  /** Bars that turn about y and about z in turn. */
  private static Mechanism chain(int links) {
    List<Body> bodies = new ArrayList<>();
    List<Joint> joints = new ArrayList<>();
    for (int i = 0; i < links; i++) {
      InertiaTensor inertia = new InertiaTensor(1e-3, 1.0 / 12, 1.0 / 12, 0, 0, 0);
      bodies.add(new Body("link" + i, 1, new Vector3(0.5, 0, 0), inertia, Origin.NONE));
      Vector3 onParent = i == 0 ? Vector3.ZERO : new Vector3(1, 0, 0);
      Vector3 axis = i % 2 == 0 ? new Vector3(0, 1, 0) : new Vector3(0, 0, 1);
      Attachment attachment = new Attachment(i - 1, onParent, i, Vector3.ZERO, Rotation.IDENTITY);
      joints.add(new Revolute("joint" + i, attachment, axis, 0.1, 0.2, Origin.NONE));
    }
    Root root = new Root("Ground", Vector3.ZERO, Rotation.IDENTITY);
    return new Mechanism("chain", root, new Vector3(0, 0, -9.81), bodies, joints);
  }

  /** The condition of random trees of twelve bodies costs up to five digits. */
  private static void requireEqual(double[] found, double[] expected) {
    double largest = Arrays.stream(expected).map(Math::abs).max().orElse(0);
    for (int i = 0; i < found.length; i++) {
      assertThat(Math.abs(found[i] - expected[i])).isLessThanOrEqualTo(1e-10 * largest);
    }
  }
}
