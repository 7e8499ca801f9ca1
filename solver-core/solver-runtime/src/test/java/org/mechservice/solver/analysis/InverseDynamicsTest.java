package org.mechservice.solver.analysis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.RandomTrees;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.JointForce;
import org.mechservice.solver.text.Origin;

/** Inverse dynamics undoes forward dynamics. */
class InverseDynamicsTest {
  private static Mechanism with(Mechanism bare, List<ForceElement> forces) {
    return new Mechanism(
            bare.name(),
            bare.root(),
            bare.gravity(),
            bare.bodies(),
            bare.joints(),
            bare.motions(),
            bare.startRoles(),
            bare.closures(),
            forces,
            List.of())
        .withArmatures(bare.armatures());
  }

  private static double[] accelerations(ColumnsAt forward, double[] y) {
    double[] yDot = new double[y.length];
    forward.model.derivative(0, y, yDot);
    return Arrays.copyOfRange(yDot, forward.model.description().positionCount(), y.length);
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
  void forcesOfTreeAreThoseThatMadeTheMotion(long seed) {
    Mechanism bare = RandomTrees.ofAllJoints(seed, 8);
    Random random = new Random(seed);
    List<ForceElement> motors = new ArrayList<>();
    double[] expected = new double[bare.velocityCount()];
    for (int j = 0; j < bare.joints().size(); j++) {
      for (int i = 0; i < bare.joints().get(j).type().velocityCount(); i++) {
        double force = 20 * random.nextDouble() - 10;
        expected[bare.velocityOffset(j) + i] = force;
        motors.add(
            new JointForce(
                "f" + motors.size(), new JointCoordinate(j, i), Expression.of(force), Origin.NONE));
      }
    }
    ColumnsAt forward = new ColumnsAt(with(bare, motors));
    double[] y = forward.start();
    double[] a = accelerations(forward, y);
    double[] tau = new double[expected.length];
    int[] all = IntStream.range(0, tau.length).toArray();
    InverseDynamics inverse = new InverseDynamics(bare, UserForceSource.NONE);
    assertThat(inverse.forces(0, y, a, all, tau)).isEmpty();
    for (int i = 0; i < tau.length; i++) {
      // backward error 1e-12 times forces and inertia forces of some hundreds
      assertThat(tau[i]).isCloseTo(expected[i], within(1e-9));
    }
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void forceOfLoopIsTheOneThatMadeTheMotion(boolean sliding) {
    Mechanism bare = SpatialLoop.cutAt(3, sliding, List.of());
    JointForce motor =
        new JointForce("motor", new JointCoordinate(0, 0), Expression.of(7), Origin.NONE);
    ColumnsAt forward = new ColumnsAt(with(bare, List.of(motor)));
    double[] y = forward.start();
    double[] a = accelerations(forward, y);
    double[] tau = new double[bare.velocityCount()];
    InverseDynamics inverse = new InverseDynamics(bare, UserForceSource.NONE);
    assertThat(inverse.forces(0, y, a, new int[] {0}, tau)).isEmpty();
    assertThat(tau[0]).isCloseTo(7, within(1e-10));
    assertThat(Arrays.copyOfRange(tau, 1, tau.length)).containsOnly(0);
  }

  /** Many sets of forces make one motion of a loop; none is smaller than the one found. */
  @Test
  void forcesOfLeastNormMakeTheSameMotion() {
    Mechanism bare = SpatialLoop.cutAt(3, false, List.of());
    ColumnsAt forward =
        new ColumnsAt(
            with(
                bare,
                List.of(
                    new JointForce(
                        "motor", new JointCoordinate(0, 0), Expression.of(7), Origin.NONE))));
    double[] y = forward.start();
    double[] a = accelerations(forward, y);
    double[] tau = new double[bare.velocityCount()];
    int[] all = IntStream.range(0, tau.length).toArray();
    InverseDynamics inverse = new InverseDynamics(bare, UserForceSource.NONE);
    assertThat(inverse.forces(0, y, a, all, tau)).isEmpty();
    assertThat(Arrays.stream(tau).map(x -> x * x).sum()).isLessThan(49);
    List<ForceElement> motors = new ArrayList<>();
    for (int j = 0, k = 0; j < bare.joints().size(); j++) {
      for (int i = 0; i < bare.joints().get(j).type().velocityCount(); i++, k++) {
        motors.add(
            new JointForce("f" + k, new JointCoordinate(j, i), Expression.of(tau[k]), Origin.NONE));
      }
    }
    double[] again = accelerations(new ColumnsAt(with(bare, motors)), y);
    for (int i = 0; i < a.length; i++) {
      assertThat(again[i]).isCloseTo(a[i], within(1e-9 * (1 + Math.abs(a[i]))));
    }
  }

  @Test
  void coordinatesThatCannotDriveTheMotionAreRefused() {
    Mechanism tree = RandomTrees.tree(1, 3);
    ColumnsAt forward = new ColumnsAt(tree);
    double[] y = forward.start();
    double[] tau = new double[3];
    InverseDynamics inverse = new InverseDynamics(tree, UserForceSource.NONE);
    assertThat(inverse.forces(0, y, accelerations(forward, y), new int[] {0, 2}, tau))
        .hasValueSatisfying(
            defect -> assertThat(defect.code()).isEqualTo(MessageCode.FORCES_CANNOT_DRIVE));
  }
}
