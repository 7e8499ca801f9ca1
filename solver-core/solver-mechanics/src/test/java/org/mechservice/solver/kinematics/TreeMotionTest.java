package org.mechservice.solver.kinematics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.RandomTrees;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.spatial.Vector3;

/** Trees of all joints. */
class TreeMotionTest {
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
  @ParameterizedTest
  void powerOfAForceAtAPointIsThatOfItsJointForces(long seed) {
    Mechanism tree = RandomTrees.ofAllJoints(seed, 12);
    TreeMotion motion = swept(tree);
    int link = motion.tree().linkOfBody[11];
    Random random = new Random(seed);
    double[] r = random.doubles(3, -1, 1).toArray();
    double[] force = random.doubles(3, -1, 1).toArray();
    double[] velocity = new double[3];
    motion.points.velocity(link, r, 0, velocity, 0);
    double[] wrench = new double[6 * motion.tree().linkCount];
    motion.wrenches.addForceAtPoint(link, r, 0, force, 0, wrench);
    double[] row = new double[tree.velocityCount()];
    motion.wrenches.addRow(link, wrench, 6 * link, 2, row);
    double power = 0;
    for (int i = 0; i < row.length; i++) {
      power += row[i] * motion.v[i];
    }
    double expected =
        2 * (force[0] * velocity[0] + force[1] * velocity[1] + force[2] * velocity[2]);
    assertThat(power).isCloseTo(expected, within(1e-13 * (1 + Math.abs(expected))));
  }

  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
  @ParameterizedTest
  void differenceOfPointsIsThatOfTheirPlaces(long seed) {
    Mechanism mechanism = RandomTrees.ofAllJoints(seed, 12);
    TreeMotion motion = swept(mechanism);
    double[] r = new Random(seed).doubles(6, -1, 1).toArray();
    double[] there = new double[3];
    double[] here = new double[3];
    for (int first = -1; first < 12; first++) {
      int a = motion.tree().linkOf(first);
      int b = motion.tree().linkOf(11);
      double[] way = new double[3];
      motion.points.difference(motion.tree().commonAncestor(a, b), a, r, 0, b, r, 3, way, 0);
      motion.points.position(a, r, 0, here, 0);
      motion.points.position(b, r, 3, there, 0);
      for (int i = 0; i < 3; i++) {
        assertThat(way[i]).isCloseTo(there[i] - here[i], within(1e-13));
      }
    }
  }

  @Test
  void differenceOfPointsKeepsItsBitsFarFromTheOrigin() {
    Mechanism near = RandomTrees.ofAllJoints(3, 9);
    Root moved = new Root("ground", new Vector3(1e6, -1e6, 1e6), near.root().orientation());
    Mechanism far = new Mechanism("far", moved, near.gravity(), near.bodies(), near.joints());
    assertThat(difference(far)).containsExactly(difference(near));
  }

  private static double[] difference(Mechanism mechanism) {
    TreeMotion motion = swept(mechanism);
    int a = motion.tree().linkOf(4);
    int b = motion.tree().linkOf(8);
    double[] way = new double[3];
    int common = motion.tree().commonAncestor(a, b);
    motion.points.difference(common, a, new double[3], 0, b, new double[3], 0, way, 0);
    return way;
  }

  @Test
  void pointIsReferredToTheJointsPointOnItsBody() {
    Mechanism tree = RandomTrees.ofAllJoints(5, 4);
    TreeMotion motion = swept(tree);
    double[] r = new double[3];
    double[] place = new double[3];
    Vector3 jointPoint = tree.joints().get(tree.jointOf(2)).attachment().childPoint();
    motion.tree().fromReference(new BodyPoint(2, jointPoint), r, 0);
    assertThat(r).containsExactly(0, 0, 0);
    motion.tree().fromReference(new BodyPoint(Mechanism.ROOT, Vector3.ZERO), r, 0);
    motion.points.position(TreeGeometry.ROOT, r, 0, place, 0);
    Vector3 root = tree.root().position();
    assertThat(place).containsExactly(root.x(), root.y(), root.z());
  }

  @Test
  void lengthOfEulerParametersDoesNotMoveAnything() {
    Mechanism tree = RandomTrees.ofAllJoints(6, 15);
    StateCoordinates coordinates = new StateCoordinates(tree);
    assertThat(coordinates.ballCount()).isPositive();
    double[] y = state(tree);
    double[] longer = y.clone();
    for (int ball = 0; ball < coordinates.ballCount(); ball++) {
      for (int i = 0; i < 4; i++) {
        longer[coordinates.ballPosition(ball) + i] *= 2;
      }
    }
    TreeMotion motion = new TreeMotion(new TreeGeometry(tree));
    motion.sweep(0, y);
    double[] expected = motion.worldPosition.clone();
    motion.sweep(0, longer);
    assertThat(motion.worldPosition).containsExactly(expected);
  }

  /**
   * e ← exp(½δ) ∘ e is the exact flow of e' = ½ (0, δ) ∘ e over unit time: 1e4 small steps agree.
   */
  @Test
  void moveAlongTheTangentIsTheFlowOfTheRates() {
    Mechanism tree = RandomTrees.ofAllJoints(6, 15);
    StateCoordinates coordinates = new StateCoordinates(tree);
    int nq = coordinates.positionCount();
    double[] y = state(tree);
    double[] exact = y.clone();
    coordinates.move(exact, 0, y, nq, 0.5);
    double[] stepped = y.clone();
    double[] rate = new double[nq];
    double[] half = new double[nq];
    double h = 0.5 / 10_000;
    for (int step = 0; step < 10_000; step++) {
      coordinates.rates(stepped, 0, y, nq, rate, 0);
      for (int i = 0; i < nq; i++) {
        half[i] = stepped[i] + 0.5 * h * rate[i];
      }
      coordinates.rates(half, 0, y, nq, rate, 0);
      for (int i = 0; i < nq; i++) {
        stepped[i] += h * rate[i];
      }
    }
    for (int i = 0; i < nq; i++) {
      assertThat(stepped[i]).isCloseTo(exact[i], within(1e-9));
    }
  }

  @Test
  void ancestorsAreFoundWhereBranchesMeet() {
    Mechanism tree = RandomTrees.ofAllJoints(7, 30);
    TreeGeometry geometry = new TreeGeometry(tree);
    for (int a : geometry.linkOfBody) {
      for (int b : geometry.linkOfBody) {
        int common = geometry.commonAncestor(a, b);
        assertThat(ancestors(geometry, a)).contains(common);
        assertThat(ancestors(geometry, b)).contains(common);
      }
    }
  }

  private static List<Integer> ancestors(TreeGeometry tree, int link) {
    List<Integer> all = new ArrayList<>();
    for (int i = link; i != TreeGeometry.ROOT; i = tree.parent[i]) {
      all.add(i);
    }
    all.add(TreeGeometry.ROOT);
    return all;
  }

  private static TreeMotion swept(Mechanism mechanism) {
    TreeMotion motion = new TreeMotion(new TreeGeometry(mechanism));
    motion.sweep(0, state(mechanism));
    return motion;
  }

  private static double[] state(Mechanism mechanism) {
    double[] y = new double[mechanism.positionCount() + mechanism.velocityCount()];
    mechanism.initialState(y);
    return y;
  }
}
