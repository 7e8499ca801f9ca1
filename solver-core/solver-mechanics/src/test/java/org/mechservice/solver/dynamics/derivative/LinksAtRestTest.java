package org.mechservice.solver.dynamics.derivative;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.EigenDecomposition;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.QRDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.SingularValueDecomposition;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.solver.dynamics.Evaluation;
import org.mechservice.solver.dynamics.WholeStep;
import org.mechservice.solver.dynamics.tree.TreePattern;
import org.mechservice.solver.force.applied.ForceJacobian;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.RandomTrees;

/** The sparse system of links against matrices formed element by element. */
class LinksAtRestTest {
  /** Rounding of two ways to the same elements. */
  private static final double ROUNDING = 1e-11;

  static LongStream seeds() {
    return LongStream.rangeClosed(1, 60);
  }

  private static Mechanism tree(long seed) {
    return RandomTrees.ofAllJoints(seed, 1 + (int) (seed % 12));
  }

  private static LongStream ofFreedom(int least) {
    return LongStream.iterate(1, seed -> seed + 1)
        .filter(seed -> tree(seed).velocityCount() >= least)
        .limit(60);
  }

  /** Seeds of trees that are not welded as a whole: those have no matrices. */
  static LongStream moving() {
    return ofFreedom(1);
  }

  /** Seeds of trees on which the rows of a loop leave something free. */
  static LongStream movingMore() {
    return ofFreedom(3);
  }

  /** A random tree of all joints at rest, with forces between random links. */
  private static final class Rest {
    final Random random;
    final Evaluation at;
    final int nv;
    final LinksAtRest links;
    final LoopWrenches rows;
    final RealMatrix mass;
    final RealMatrix damping;
    final RealMatrix stiffness;
    final RealMatrix jacobian;

    /**
     * @param forces whether forces without a potential act, beside weight
     */
    Rest(long seed, boolean forces, boolean loops) {
      random = new Random(seed);
      Evaluation tree = new Evaluation(tree(seed));
      at = forces ? tree.loaded(seed) : tree;
      nv = at.nv;
      Arrays.fill(at.y, at.nq, at.nq + nv, 0);
      at.motion.sweep(0, at.y);
      at.motion.accelerationSweep(new double[nv]);
      double[] wrench = forces ? at.wrench : new double[6 * at.tree.linkCount];
      int[] pairs = pairs();
      rows = rows(loops);
      ResidualJacobian matrices = new ResidualJacobian(at.motion, new TreePattern(at.tree, pairs));
      matrices.evaluate(wrench);
      links = new LinksAtRest(at.motion, pairs, rows);
      links.evaluate(wrench);
      if (forces) {
        addForces(seed, pairs, matrices.forces());
        addForces(seed, pairs, links.forces());
      }
      matrices.finish();
      mass = symmetric(matrices.mass()::toDense);
      damping = symmetric(matrices.byVelocity()::toDense);
      stiffness = symmetric(matrices.byPosition()::toDense);
      jacobian = jacobian();
      links.weigh(new double[nv], IntStream.range(0, nv).mapToDouble(i -> 1).toArray());
    }

    private interface Elements {
      void write(double[] out);
    }

    private RealMatrix symmetric(Elements elements) {
      double[] dense = new double[nv * nv];
      elements.write(dense);
      RealMatrix matrix = WholeStep.square(dense, nv);
      return matrix.add(matrix.transpose()).scalarMultiply(0.5);
    }

    private int[] pairs() {
      int count = at.tree.linkCount;
      int[] pairs = new int[2 * count];
      for (int link = 0; link < count; link++) {
        pairs[2 * link] = link;
        pairs[2 * link + 1] = random.nextInt(count);
      }
      return pairs;
    }

    private LoopWrenches rows(boolean loops) {
      int last = at.tree.linkCount - 1;
      if (!loops || last < 0 || nv < 3) {
        return LoopWrenches.NONE;
      }
      int[] ends = last == 0 ? new int[] {0} : new int[] {0, last};
      return new LoopWrenches(
          new int[][] {ends, {last}, {last}}, new int[][] {{}, {0, nv - 1}, {}});
    }

    /** Forces of no law in particular; those on the first link of a pair by the other's motion. */
    private void addForces(long seed, int[] pairs, ForceJacobian sink) {
      Random numbers = new Random(-seed);
      TreeGeometry tree = at.tree;
      for (int i = 0; i < pairs.length; i += 2) {
        int on = pairs[i];
        int by = pairs[i + 1];
        sink.wrenchByLink(on, by, numbers(numbers, 36), numbers(numbers, 36));
        sink.wrenchByLink(on, on, numbers(numbers, 36), numbers(numbers, 36));
        for (int k = tree.velocityAt[by]; k < tree.velocityAt[by] + count(by); k++) {
          sink.wrenchByCoordinate(on, k, numbers(numbers, 6), numbers(numbers, 6));
          for (int j = tree.velocityAt[on]; j < tree.velocityAt[on] + count(on); j++) {
            sink.forceByCoordinate(j, k, numbers.nextDouble(), numbers.nextDouble());
          }
        }
        for (int j = tree.velocityAt[on]; j < tree.velocityAt[on] + count(on); j++) {
          sink.forceByLink(j, by, numbers(numbers, 6), numbers(numbers, 6));
        }
      }
    }

    /** J of the rows, of which the last is left zero. */
    private RealMatrix jacobian() {
      int m = rows.count();
      RealMatrix j = MatrixUtils.createRealMatrix(Math.max(1, m - 1), Math.max(1, nv));
      for (int row = 0; row < m - 1; row++) {
        double[] wrenches = numbers(random, 6 * at.tree.linkCount);
        double[] forces = numbers(random, at.tree.velocityCount);
        double[] sum = new double[nv];
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
        j.setRow(row, sum);
        rows.take(row, wrenches, forces);
      }
      return j;
    }

    private int count(int link) {
      return at.tree.kind[link].velocityCount();
    }

    private static double[] numbers(Random random, int count) {
      return random.doubles(count, -1, 1).toArray();
    }
  }

  @MethodSource("moving")
  @ParameterizedTest
  void productsAreThoseOfTheSymmetricParts(long seed) {
    Rest rest = new Rest(seed, true, false);
    requireProduct(rest, rest.mass, 1, 0, 0);
    requireProduct(rest, rest.damping, 0, 1, 0);
    requireProduct(rest, rest.stiffness, 0, 0, 1);
  }

  private static void requireProduct(
      Rest rest, RealMatrix expected, double mass, double damping, double stiffness) {
    double[] x = rest.random.doubles(rest.nv, -1, 1).toArray();
    double[] found = new double[rest.nv];
    rest.links.multiply(mass, damping, stiffness, x, found);
    double error =
        expected.operate(new ArrayRealVector(x)).subtract(new ArrayRealVector(found)).getNorm();
    double size = rest.mass.getFrobeniusNorm() + rest.stiffness.getFrobeniusNorm();
    assertThat(error).isLessThanOrEqualTo(ROUNDING * (1 + size + Evaluation.norm(found)));
  }

  /** Negative eigenvalues and solutions of m M + c C + k K in directions that loops leave free. */
  @MethodSource("movingMore")
  @ParameterizedTest
  void countsNegativeEigenvaluesAlongTheLoopsAndSolves(long seed) {
    requireEigenvaluesAndSolutions(seed);
  }

  /** Rows that depend on each other count for nothing, and few forms are too flat to be solved. */
  @Test
  void enoughTreesAreCountedAndSolved() {
    Checked all = new Checked(0, 0, 0);
    for (long seed : movingMore().toArray()) {
      all = all.plus(requireEigenvaluesAndSolutions(seed));
    }
    assertThat(all.alone).isEqualTo(60);
    assertThat(all.withLoops).isGreaterThan(30);
    assertThat(all.solved).isGreaterThan((all.alone + all.withLoops) / 2);
  }

  /**
   * What was checked.
   *
   * @param alone trees without loops whose negative eigenvalues were counted
   * @param withLoops the same with loops
   * @param solved how many of both were solved
   */
  private record Checked(int alone, int withLoops, int solved) {
    Checked plus(Checked other) {
      return new Checked(alone + other.alone, withLoops + other.withLoops, solved + other.solved);
    }
  }

  private static Checked requireEigenvaluesAndSolutions(long seed) {
    Checked checked = new Checked(0, 0, 0);
    for (boolean loops : new boolean[] {false, true}) {
      Rest rest = new Rest(seed, true, loops);
      SingularValueDecomposition svd = new SingularValueDecomposition(rest.jacobian);
      int rank = rest.rows.count() == 0 ? 0 : rest.rows.count() - 1;
      double[] singular = svd.getSingularValues();
      if (rank > 0 && (rank > singular.length || singular[rank - 1] < 1e-3 * singular[0])) {
        continue;
      }
      double shift = seed % 3 == 0 ? 3 : seed % 3;
      RealMatrix a = rest.stiffness.add(rest.damping.scalarMultiply(0.3));
      a = a.add(rest.mass.scalarMultiply(shift));
      int found = rest.links.negative(shift, 0.3, 1);
      if (rank == rest.nv) {
        assertThat(found).isZero();
        continue;
      }
      RealMatrix z = free(rest, rank);
      int negative = 0;
      RealMatrix reduced = z.transpose().multiply(a).multiply(z);
      reduced = reduced.add(reduced.transpose()).scalarMultiply(0.5);
      for (double value : new EigenDecomposition(reduced).getRealEigenvalues()) {
        negative += value < 0 ? 1 : 0;
      }
      assertThat(found).isEqualTo(negative);
      assertThat(rest.links.factor(shift, 0.3, 1, 0)).isEqualTo(negative == 0);
      rest.links.negative(shift, 0.3, 1);
      int solved = solves(rest, a, z) ? 1 : 0;
      checked = checked.plus(new Checked(loops ? 0 : 1, loops ? 1 : 0, solved));
    }
    return checked;
  }

  /** Returns an orthonormal basis of the kernel of J. */
  private static RealMatrix free(Rest rest, int rank) {
    if (rank == 0) {
      return MatrixUtils.createRealIdentityMatrix(rest.nv);
    }
    RealMatrix q = new QRDecomposition(rest.jacobian.transpose()).getQ();
    return q.getSubMatrix(0, rest.nv - 1, rank, rest.nv - 1);
  }

  /** Asserts the solution; returns false if the condition is too bad to tell. */
  private static boolean solves(Rest rest, RealMatrix a, RealMatrix z) {
    double[] b = rest.random.doubles(rest.nv, -1, 1).toArray();
    double[] x = b.clone();
    rest.links.solve(x);
    RealMatrix reduced = z.transpose().multiply(a).multiply(z);
    double condition = new SingularValueDecomposition(reduced).getConditionNumber();
    if (condition < 1e6) {
      ArrayRealVector expected =
          (ArrayRealVector)
              z.operate(
                  new LUDecomposition(reduced)
                      .getSolver()
                      .solve(z.transpose().operate(new ArrayRealVector(b))));
      double error = expected.subtract(new ArrayRealVector(x)).getNorm();
      assertThat(error).isLessThanOrEqualTo(ROUNDING * condition * expected.getNorm());
    }
    return condition < 1e6;
  }

  /** Weight has a potential, and so have springs; forces that turn with a link have none. */
  @MethodSource("seeds")
  @ParameterizedTest
  void tellsWhetherForcesHaveAPotential(long seed) {
    Rest weight = new Rest(seed, false, false);
    assertThat(weight.links.isStiffnessSymmetric()).isTrue();
    assertThat(weight.links.isDampingSymmetric()).isTrue();
    Rest forces = new Rest(seed, true, false);
    if (forces.at.tree.linkCount > 0) {
      assertThat(forces.links.isStiffnessSymmetric()).isFalse();
      assertThat(forces.links.isDampingSymmetric()).isFalse();
    }
  }

  /** With much of D the form is positive definite, whatever the forces are. */
  @MethodSource("seeds")
  @ParameterizedTest
  void aLargeShiftMakesItPositiveDefinite(long seed) {
    Rest rest = new Rest(seed, true, true);
    assertThat(rest.links.factor(0, 0, 1, 1e6)).isTrue();
  }
}
