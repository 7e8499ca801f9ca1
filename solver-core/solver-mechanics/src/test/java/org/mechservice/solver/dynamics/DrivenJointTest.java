package org.mechservice.solver.dynamics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.mechservice.solver.dynamics.Evaluation.largest;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.dynamics.recursion.ArticulatedBody;
import org.mechservice.solver.dynamics.recursion.TreeSteps;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.Product;
import org.mechservice.solver.expression.Expression.Sum;
import org.mechservice.solver.expression.Expression.Time;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.PrescribedMotion;
import org.mechservice.solver.mechanism.RandomTrees;
import org.mechservice.solver.mechanism.joint.Joint;

/** Joints whose coordinates follow q0 + v0 t + ½ a0 t², so that all three are known at t = 0. */
class DrivenJointTest {
  static LongStream seeds() {
    return LongStream.rangeClosed(1, 16);
  }

  /** Driving forces, applied to the same mechanism with that joint free, give the same motion. */
  @MethodSource("seeds")
  @ParameterizedTest
  void drivingForceMovesTheFreeJointAsItIsDriven(long seed) {
    Mechanism free = RandomTrees.ofAllJoints(seed, 10);
    Evaluation driven = new Evaluation(driven(free, seed)).loaded(seed);
    double[] driving = new double[driven.tree.velocityCount - driven.nv];
    double[] a = drivenByArticulatedBodies(driven, driving);
    Evaluation at = new Evaluation(free);
    System.arraycopy(driven.wrench, 0, at.wrench, 0, at.wrench.length);
    double[] expected = new double[at.nv];
    transfer(driven, at, a, driving, expected);
    double[] whole = at.byArticulatedBodies();
    double scale = 1 + largest(expected) + largest(at.tau);
    for (int i = 0; i < at.nv; i++) {
      // condition of trees of this size is below 1e5
      assertThat(whole[i]).isCloseTo(expected[i], within(1e-10 * scale));
    }
  }

  /** Writes joint forces of the free mechanism, and the accelerations it should have. */
  private static void transfer(
      Evaluation driven, Evaluation at, double[] a, double[] driving, double[] expected) {
    Mechanism free = at.mechanism;
    int next = driven.nv;
    for (int j = 0; j < free.joints().size(); j++) {
      boolean isDriven = driven.mechanism.isDriven(j);
      for (int k = 0; k < free.joints().get(j).type().velocityCount(); k++) {
        int here = free.velocityOffset(j) + k;
        int there = isDriven ? next++ : driven.mechanism.velocityOffset(j) + k;
        at.tau[here] = driven.tau[there] + (isDriven ? driving[there - driven.nv] : 0);
        expected[here] = isDriven ? driven.motion.a[there] : a[there];
      }
    }
  }

  private static double[] drivenByArticulatedBodies(Evaluation driven, double[] driving) {
    TreeSteps steps = new TreeSteps(driven.motion);
    double[] a = new double[driven.nv];
    assertThat(steps.accelerations(driven.wrench, driven.tau, a, 0)).isNegative();
    System.arraycopy(steps.drivingForces(), 0, driving, 0, driving.length);
    ArticulatedBody bodies = new ArticulatedBody(driven.tree);
    ArticulatedBody.Workspace w = bodies.newWorkspace(driven.motion);
    double[] byBodies = new double[driven.nv];
    assertThat(bodies.accelerations(w, driven.wrench, driven.tau, byBodies, 0)).isNegative();
    double scale = 1 + largest(a) + largest(driving);
    for (int i = 0; i < a.length; i++) {
      assertThat(a[i]).isCloseTo(byBodies[i], within(1e-10 * scale));
    }
    for (int i = 0; i < driving.length; i++) {
      assertThat(driving[i]).isCloseTo(w.drivingForces()[i], within(1e-10 * scale));
    }
    return a;
  }

  @MethodSource("seeds")
  @ParameterizedTest
  void formulationsAgreeOnAccelerationsAndDrivingForces(long seed) {
    Evaluation at = new Evaluation(driven(RandomTrees.ofAllJoints(seed, 10), seed)).loaded(seed);
    double[] driving = new double[at.tree.velocityCount - at.nv];
    double[] articulated = drivenByArticulatedBodies(at, driving);
    double[] composite = at.bySemiRecursion();
    double[] residual = at.extendedResidual(articulated);
    double scale = 1 + largest(articulated) + largest(residual);
    for (int i = 0; i < at.nv; i++) {
      assertThat(composite[i]).isCloseTo(articulated[i], within(1e-10 * scale));
      assertThat(residual[i]).isCloseTo(0, within(1e-11 * scale));
    }
    for (int i = 0; i < driving.length; i++) {
      assertThat(residual[at.nv + i]).isCloseTo(driving[i], within(1e-11 * scale));
    }
  }

  @Test
  void motionThatDependsOnTheStateIsRefused() {
    Mechanism free = RandomTrees.tree(1, 2);
    Expression ofState = new Expression.CoordinatePosition(new JointCoordinate(0, 0));
    Mechanism wrong = with(free, List.of(new PrescribedMotion(1, List.of(ofState))));
    assertThatThrownBy(() -> new TreeMotion(new Evaluation(wrong).tree))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("may depend on time alone");
  }

  /** Drives every third joint that can be driven, and the first of these in any case. */
  private static Mechanism driven(Mechanism free, long seed) {
    Random random = new Random(seed);
    List<PrescribedMotion> motions = new ArrayList<>();
    for (int j = 0; j < free.joints().size(); j++) {
      JointType type = free.joints().get(j).type();
      boolean can = type.positionCount() == type.velocityCount() && type != JointType.W;
      if (can && (motions.isEmpty() || random.nextInt(3) == 0)) {
        motions.add(new PrescribedMotion(j, coordinates(random, free.joints().get(j))));
      }
    }
    return with(free, motions);
  }

  private static Mechanism with(Mechanism free, List<PrescribedMotion> motions) {
    return new Mechanism(
            free.name(),
            free.root(),
            free.gravity(),
            free.bodies(),
            free.joints(),
            motions,
            free.startRoles(),
            List.of(),
            List.of(),
            List.of())
        .withArmatures(free.armatures());
  }

  private static List<Expression> coordinates(Random random, Joint joint) {
    int n = joint.type().positionCount();
    double[] q = new double[n];
    double[] v = new double[n];
    joint.initialPositions(q, 0);
    joint.initialVelocities(v, 0);
    List<Expression> all = new ArrayList<>();
    for (int i = 0; i < n; i++) {
      Expression t = new Time();
      Expression slope =
          new Sum(Expression.of(v[i]), new Product(Expression.of(random.nextDouble()), t));
      all.add(new Sum(Expression.of(q[i]), new Product(slope, t)));
    }
    return all;
  }
}
