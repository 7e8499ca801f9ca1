package org.mechservice.solver.kinematics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.RandomJoints;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/** One body on the root by a joint of each type, in both directions. */
class JointMotionTest {
  private static final String TYPES = "org.mechservice.solver.mechanism.RandomJoints#typesAndSeeds";

  /** Poses are a few products of rotations of size 1. */
  private static final double ROUNDING = 1e-14;

  @MethodSource(TYPES)
  @ParameterizedTest
  void childStandsWhereTheLanguageDefinesIt(JointType type, int seed) {
    Joint joint = RandomJoints.forward(new Random(seed), type, Mechanism.ROOT, 0);
    double[] y = start(joint);
    JointDefinition defined = JointDefinition.of(joint, y);
    assertPose(joint, y, defined.rotation(), defined.translation());
  }

  @MethodSource(TYPES)
  @ParameterizedTest
  void fileBody1MovesInverselyIfItIsTheChild(JointType type, int seed) {
    Joint forward = RandomJoints.forward(new Random(seed), type, 0, Mechanism.ROOT);
    double[] y = start(forward);
    JointDefinition defined = JointDefinition.of(forward, y);
    Rotation inverse = defined.rotation().transposed();
    assertPose(forward.reversed(), y, inverse, inverse.apply(defined.translation()).negated());
  }

  private static void assertPose(Joint joint, double[] y, Rotation rotation, Vector3 translation) {
    TreeMotion motion = swept(joint, y);
    TreeGeometry tree = motion.tree();
    int link = tree.linkOfBody[0];
    for (int column = 0; column < 3; column++) {
      double[] unit = new double[3];
      unit[column] = 1;
      double[] out = new double[3];
      motion.toWorld(link, unit, 0, out, 0);
      assertClose(out, rotation.apply(new Vector3(unit[0], unit[1], unit[2])), ROUNDING);
    }
    double[] point = new double[3];
    motion.points.position(link, new double[3], 0, point, 0);
    assertClose(point, joint.attachment().parentPoint().plus(translation), ROUNDING);
  }

  /** Central differences with Richardson's correction at 1e-3 are exact to about 1e-11. */
  @MethodSource(TYPES)
  @ParameterizedTest
  void velocityIsTheRateOfThePoseAlongQPrime(JointType type, int seed) {
    Joint joint = RandomJoints.joint(new Random(seed), type, Mechanism.ROOT, 0);
    double[] y = start(joint);
    TreeMotion motion = swept(joint, y);
    double[] r = {0.3, -0.7, 0.5};
    double[] velocity = new double[3];
    motion.points.velocity(motion.tree().linkOfBody[0], r, 0, velocity, 0);
    double[] coarse = pointDifference(joint, y, r, 2e-3);
    double[] fine = pointDifference(joint, y, r, 1e-3);
    for (int i = 0; i < 3; i++) {
      assertThat(velocity[i]).isCloseTo(fine[i] + (fine[i] - coarse[i]) / 3, within(1e-10));
    }
  }

  /** As for velocities, one order further. */
  @MethodSource(TYPES)
  @ParameterizedTest
  void accelerationIsTheRateOfTheVelocity(JointType type, int seed) {
    Joint joint = RandomJoints.joint(new Random(seed), type, Mechanism.ROOT, 0);
    double[] y = start(joint);
    double[] a = new Random(seed).doubles(type.velocityCount(), -1, 1).toArray();
    TreeMotion motion = swept(joint, y);
    motion.accelerationSweep(a);
    double[] r = {0.3, -0.7, 0.5};
    double[] acceleration = new double[3];
    motion.points.acceleration(motion.tree().linkOfBody[0], r, 0, acceleration, 0);
    double[] coarse = velocityDifference(joint, y, a, r, 2e-3);
    double[] fine = velocityDifference(joint, y, a, r, 1e-3);
    for (int i = 0; i < 3; i++) {
      assertThat(acceleration[i]).isCloseTo(fine[i] + (fine[i] - coarse[i]) / 3, within(1e-10));
    }
  }

  private static double[] pointDifference(Joint joint, double[] y, double[] r, double h) {
    double[] ahead = new double[3];
    double[] behind = new double[3];
    TreeMotion there = swept(joint, moved(joint, y, new double[6], h));
    there.points.position(there.tree().linkOfBody[0], r, 0, ahead, 0);
    TreeMotion back = swept(joint, moved(joint, y, new double[6], -h));
    back.points.position(back.tree().linkOfBody[0], r, 0, behind, 0);
    return difference(ahead, behind, h);
  }

  private static double[] velocityDifference(
      Joint joint, double[] y, double[] a, double[] r, double h) {
    double[] ahead = new double[3];
    double[] behind = new double[3];
    TreeMotion there = swept(joint, moved(joint, y, a, h));
    there.points.velocity(there.tree().linkOfBody[0], r, 0, ahead, 0);
    TreeMotion back = swept(joint, moved(joint, y, a, -h));
    back.points.velocity(back.tree().linkOfBody[0], r, 0, behind, 0);
    return difference(ahead, behind, h);
  }

  private static double[] difference(double[] ahead, double[] behind, double h) {
    double[] rate = new double[3];
    for (int i = 0; i < 3; i++) {
      rate[i] = (ahead[i] - behind[i]) / (2 * h);
    }
    return rate;
  }

  /** Returns [q + h q'; v + h a], with q' = N(q) v added plainly. */
  private static double[] moved(Joint joint, double[] y, double[] a, double h) {
    StateCoordinates coordinates = new StateCoordinates(mechanism(joint));
    int nq = coordinates.positionCount();
    double[] rate = new double[y.length];
    coordinates.rates(y, 0, y, nq, rate, 0);
    System.arraycopy(a, 0, rate, nq, coordinates.velocityCount());
    double[] moved = y.clone();
    for (int i = 0; i < y.length; i++) {
      moved[i] += h * rate[i];
    }
    return moved;
  }

  private static TreeMotion swept(Joint joint, double[] y) {
    TreeMotion motion = new TreeMotion(new TreeGeometry(mechanism(joint)));
    motion.sweep(0, y);
    return motion;
  }

  private static double[] start(Joint joint) {
    JointType type = joint.type();
    double[] y = new double[type.positionCount() + type.velocityCount()];
    joint.initialPositions(y, 0);
    joint.initialVelocities(y, type.positionCount());
    return y;
  }

  private static Mechanism mechanism(Joint joint) {
    Body body = new Body("b", 1, Vector3.ZERO, InertiaTensor.ZERO, Origin.NONE);
    Root root = new Root("ground", Vector3.ZERO, Rotation.IDENTITY);
    Joint outwards = joint.attachment().parent() == Mechanism.ROOT ? joint : joint.reversed();
    return new Mechanism("m", root, Vector3.ZERO, List.of(body), List.of(outwards));
  }

  private static void assertClose(double[] actual, Vector3 expected, double bound) {
    assertThat(actual[0]).isCloseTo(expected.x(), within(bound));
    assertThat(actual[1]).isCloseTo(expected.y(), within(bound));
    assertThat(actual[2]).isCloseTo(expected.z(), within(bound));
  }
}
