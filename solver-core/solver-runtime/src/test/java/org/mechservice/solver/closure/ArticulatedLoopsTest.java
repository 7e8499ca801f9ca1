package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.QRDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.closure.model.Partition;
import org.mechservice.solver.closure.model.ProjectionModel;
import org.mechservice.solver.dynamics.recursion.MassiveRods;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.mechanism.Mechanism;

/** Factors by recursion against the whole dense system. */
class ArticulatedLoopsTest {
  private static final RunSettings SETTINGS = SceneRun.settings(1, 0.1, "ode113", 1e-8);

  /** What is left of the equations, over their size times the condition of the whole system. */
  private static final double ROUNDING = 1e-13;

  static Stream<Mechanism> mechanisms() {
    return LongStream.range(0, 40)
        .mapToObj(seed -> RandomLoops.of(seed, 3 + (int) (seed % 25), 1 + (int) (seed % 6)))
        .filter(mechanism -> LoopComparison.leftOut(mechanism).isEmpty());
  }

  @Test
  void thereAreEnoughMechanisms() {
    assertThat(mechanisms().count()).isGreaterThan(20);
    assertThat(mechanisms().filter(m -> !new MassiveRods(new TreeGeometry(m)).isEmpty()).count())
        .isGreaterThan(5);
  }

  @ParameterizedTest
  @MethodSource("mechanisms")
  void solvesTheWholeSystem(Mechanism mechanism) {
    ClosedMechanism closed = new ClosedMechanism(mechanism, "DSR", SETTINGS);
    ProjectionModel model = new ProjectionModel(closed, UserForceSource.NONE);
    Partition partition = model.completion.ofVelocities();
    ClosedTree work = model.work;
    work.place(closed.start().time(), closed.start().state());
    work.formMass();
    ArticulatedLoops factors =
        new ArticulatedLoops(work.motion, work.loops, partition.kept, work.rods);
    assertThat(factors.areOf(partition.kept)).isTrue();
    assertThat(factors.factor()).isEqualTo(ExplicitModel.REGULAR);

    assertSolves(factors, whole(work, partition.kept), work, partition.kept);
  }

  /**
   * Windows whose couplers have no mass: their joints have no pivot before the loops are closed.
   */
  @Test
  void inertiaIsAddedToJointsThatMoveNoneAlone() {
    int count = 8;
    ClosedMechanism closed = new ClosedMechanism(Linkages.windows(count, 1, 0), "DSR", SETTINGS);
    ProjectionModel model = new ProjectionModel(closed, UserForceSource.NONE);
    int[] kept = model.completion.ofVelocities().kept;
    ClosedTree work = model.work;
    work.place(closed.start().time(), closed.start().state());
    work.formMass();
    assertThat(new ArticulatedLoops(work.motion, work.loops, kept, work.rods).factor())
        .isNotNegative();

    ArticulatedLoops factors = ArticulatedLoops.withAdded(work.motion, work.loops, kept, work.rods);
    double[] least = new double[work.nv];
    Arrays.setAll(least, k -> 0.25 + 0.01 * k);
    for (int again = 0; again < 2; again++) {
      double[] added = new double[work.nv];
      assertThat(factors.factor(added, least)).isEqualTo(ExplicitModel.REGULAR);
      assertThat(Arrays.stream(added).filter(inertia -> inertia > 0).count()).isEqualTo(count);
      RealMatrix whole = whole(work, kept);
      for (int k = 0; k < added.length; k++) {
        assertThat(added[k]).isIn(0.0, least[k]);
        whole.addToEntry(k, k, added[k]);
      }
      assertSolves(factors, whole, work, kept);
    }
  }

  private static void assertSolves(
      ArticulatedLoops factors, RealMatrix whole, ClosedTree work, int[] kept) {
    Random random = new Random(1);
    double[] force = random.doubles(work.nv, -1, 1).toArray();
    double[] offset = random.doubles(work.loops.count(), -1, 1).toArray();
    double[] x = new double[work.nv];
    double[] lambda = new double[work.loops.count()];
    factors.solve(force, offset, x, 0, lambda);

    RealVector right = new ArrayRealVector(whole.getRowDimension());
    for (int i = 0; i < work.nv; i++) {
      right.setEntry(i, force[i]);
    }
    for (int i = 0; i < kept.length; i++) {
      right.setEntry(work.nv + i, -offset[kept[i]]);
    }
    RealVector found = new ArrayRealVector(whole.getRowDimension());
    for (int i = 0; i < work.nv; i++) {
      found.setEntry(i, x[i]);
    }
    for (int i = 0; i < kept.length; i++) {
      found.setEntry(work.nv + i, lambda[kept[i]]);
    }
    double left = whole.operate(found).subtract(right).getLInfNorm();
    double size = whole.getNorm() * found.getLInfNorm() + right.getLInfNorm();
    RealVector exact = new QRDecomposition(whole).getSolver().solve(right);
    double condition = exact.getLInfNorm() * whole.getNorm() / right.getLInfNorm();
    assertThat(left / size).isLessThan(ROUNDING * Math.max(1, condition));
  }

  private static RealMatrix whole(ClosedTree work, int[] kept) {
    RealMatrix whole = new Array2DRowRealMatrix(work.nv + kept.length, work.nv + kept.length);
    for (int i = 0; i < work.nv; i++) {
      for (int j = 0; j < work.nv; j++) {
        whole.setEntry(i, j, work.mass()[i * work.nv + j]);
      }
    }
    for (int i = 0; i < kept.length; i++) {
      for (int j = 0; j < work.nv; j++) {
        double element = work.loops.jacobian.get(kept[i], j);
        whole.setEntry(work.nv + i, j, element);
        whole.setEntry(j, work.nv + i, element);
      }
    }
    return whole;
  }

  /** Penalty, with velocities held or not, to which repeated equations do no harm. */
  @ParameterizedTest
  @MethodSource("mechanisms")
  void penaltyMeetsAllEquationsWhetherTheyRepeatOrNot(Mechanism mechanism) {
    ClosedMechanism closed = new ClosedMechanism(mechanism, "DSR", SETTINGS);
    ClosedTree work = closed.newEquations(UserForceSource.NONE);
    work.place(closed.start().time(), closed.start().state());
    work.formMass();
    RecursivePenalty recursive =
        new RecursivePenalty(work, PenaltySettings.DEFAULT.stiffness(), true);
    Random random = new Random(2);
    double[] right = random.doubles(work.nv, -1, 1).toArray();
    boolean[] held = new boolean[work.nv];
    for (int holding = 0; holding < 2; holding++) {
      assertThat(recursive.factor(held)).isNegative();
      double[] x = new double[work.nv];
      recursive.solve(right, new double[work.loops.count()], x, 0);
      assertMeets(work, right, held, x, recursive.multipliers());
      if (recursive.areWholeJoints(held)) {
        for (int k = 0; k < held.length; k++) {
          assertThat(held[k] ? x[k] : 0).isZero();
        }
      }
      held[random.nextInt(work.nv)] = true;
    }
  }

  /** The bounds are what ten repetitions leave, of what is summed up. */
  private static void assertMeets(
      ClosedTree work, double[] right, boolean[] held, double[] x, double[] lambda) {
    for (int i = 0; i < work.nv; i++) {
      double sum = -right[i];
      double size = 1;
      for (int j = 0; j < work.nv; j++) {
        double part = work.mass()[i * work.nv + j] * x[j];
        sum += part;
        size += Math.abs(part);
      }
      for (int row = 0; row < work.loops.count(); row++) {
        double part = work.loops.jacobian.get(row, i) * lambda[row] / work.loops.size(row);
        sum += part;
        size += Math.abs(part);
      }
      if (!held[i]) {
        assertThat(Math.abs(sum) / size).isLessThan(1e-9);
      }
    }
    double speed = Arrays.stream(x).map(Math::abs).max().orElse(0);
    for (int i = 0; i < work.nv; i++) {
      // an equation holds it where a part of a ball is held
      assertThat(held[i] ? Math.abs(x[i]) / (1 + speed) : 0).isLessThan(1e-9);
    }
    for (int row = 0; row < work.loops.count(); row++) {
      double moved = work.loops.jacobian.product(row, x, 0) / work.loops.size(row);
      assertThat(Math.abs(moved) / (1 + speed)).isLessThan(1e-9);
    }
  }

  /** An equation counted twice has no pivot, and is named. */
  @Test
  void anEquationThatRepeatsAnotherIsNamed() {
    Mechanism mechanism = mechanisms().findFirst().orElseThrow();
    ClosedMechanism closed = new ClosedMechanism(mechanism, "DSR", SETTINGS);
    ClosedTree work = closed.newEquations(UserForceSource.NONE);
    work.place(closed.start().time(), closed.start().state());
    int[] twice = {0, 0};
    ArticulatedLoops factors = new ArticulatedLoops(work.motion, work.loops, twice, work.rods);
    assertThat(factors.factor()).isEqualTo(-2);
  }

  /** Nothing depends on the joints outside of an equation's ways. */
  @ParameterizedTest
  @MethodSource("mechanisms")
  void whatAnEquationPutsOnTheJointsIsItsRowOfJ(Mechanism mechanism) {
    ClosedMechanism closed = new ClosedMechanism(mechanism, "DSR", SETTINGS);
    ClosedTree work = closed.newEquations(UserForceSource.NONE);
    LoopEquations loops = work.loops;
    work.place(closed.start().time(), closed.start().state());
    for (int row = 0; row < loops.count(); row++) {
      double[] wrench = new double[6 * work.tree.linkCount];
      double[] tau = new double[work.tree.velocityCount];
      loops.addForces(row, 1, wrench, tau);
      for (int link : loops.support(row).loaded()) {
        double[] own = Arrays.copyOfRange(wrench, 6 * link, 6 * link + 6);
        work.motion.wrenches.addRow(link, own, 0, 1, tau);
        Arrays.fill(wrench, 6 * link, 6 * link + 6, 0);
      }
      assertThat(wrench).containsOnly(0);
      for (int j = 0; j < work.nv; j++) {
        // sums of some ten products of numbers below 10
        assertThat(tau[j] - loops.jacobian.get(row, j)).isBetween(-1e-12, 1e-12);
      }
    }
  }
}
