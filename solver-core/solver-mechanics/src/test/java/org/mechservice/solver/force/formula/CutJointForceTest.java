package org.mechservice.solver.force.formula;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.expression.ClosureCoordinate;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.force.ForcedTree;
import org.mechservice.solver.force.RandomForces;
import org.mechservice.solver.force.law.Side;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.RandomJoints;
import org.mechservice.solver.mechanism.RandomTrees;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.JointForce;
import org.mechservice.solver.mechanism.force.JointFriction;
import org.mechservice.solver.mechanism.force.JointSpringDamper;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.mechanism.joint.StartRole;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/** Forces on the coordinates of joints that are not in the tree. */
class CutJointForceTest {
  private static final double TIME = 0.3;

  static Stream<Object[]> typesAndSeeds() {
    return Stream.of(JointType.values())
        .filter(type -> type.velocityCount() > 0)
        .flatMap(type -> IntStream.range(1, 7).mapToObj(seed -> new Object[] {type, seed}));
  }

  /** A tree of five bodies with a further joint between two of them, or the root, and forces. */
  private static ForcedTree tree(JointType type, long seed) {
    Random random = new Random(100 * seed + type.name().hashCode());
    Mechanism bare = RandomTrees.ofAllJoints(seed + 50, 5);
    int inner = random.nextInt(-1, 4);
    Joint cut = RandomJoints.joint(random, type, inner, 4);
    Mechanism closed =
        new Mechanism(
                bare.name(),
                bare.root(),
                bare.gravity(),
                bare.bodies(),
                bare.joints(),
                bare.motions(),
                bare.startRoles(),
                List.of(new JointClosure(cut)),
                List.of(),
                List.of())
            .withArmatures(bare.armatures());
    return new ForcedTree(new RandomForces(seed, closed).with(forces(seed, closed, type)), seed);
  }

  private static List<ForceElement> forces(long seed, Mechanism closed, JointType type) {
    RandomForces random = new RandomForces(seed, closed);
    List<ForceElement> forces = new ArrayList<>();
    int euler = type.hasEulerParameters() ? 4 : 0;
    for (int i = euler; i < type.positionCount(); i++) {
      ClosureCoordinate position = new ClosureCoordinate(0, i);
      forces.add(random.jointSpring("spring" + i, position, Side.BOTH));
      forces.add(random.jointSpring("stop" + i, position, Side.ABOVE));
    }
    for (int i = 0; i < type.velocityCount(); i++) {
      forces.add(random.friction("friction" + i, new ClosureCoordinate(0, i)));
    }
    if (euler == 0) {
      forces.add(random.jointForce("force", new ClosureCoordinate(0, type.velocityCount() - 1)));
    }
    return forces;
  }

  @MethodSource("typesAndSeeds")
  @ParameterizedTest
  void unitsOfForcesGiveThePowerOfTheirCoordinatesInWatts(JointType type, long seed) {
    Mechanism mechanism = tree(type, seed).geometry.mechanism();
    for (ForceElement force : mechanism.forces()) {
      Coordinate coordinate =
          force instanceof JointSpringDamper spring
              ? spring.coordinate()
              : force instanceof JointFriction friction
                  ? friction.coordinate()
                  : ((JointForce) force).coordinate();
      // a spring counts positions, of which Euler parameters have one more than velocities
      boolean euler = force instanceof JointSpringDamper && type.hasEulerParameters();
      String velocity = type.velocityUnit(coordinate.component() - (euler ? 1 : 0));
      assertThat(force.values(mechanism::jointOf))
          .containsExactly(new Variable("force", velocity.equals("rad/s") ? "N·m" : "N"));
    }
  }

  /** Bounds as for other forces. */
  @MethodSource("typesAndSeeds")
  @ParameterizedTest
  void jacobianIsTheDifferenceOfForces(JointType type, long seed) {
    ForcedTree tree = tree(type, seed);
    tree.evaluate(TIME);
    for (int k = 0; k < tree.geometry.stateVelocityCount; k++) {
      for (boolean ofVelocity : new boolean[] {false, true}) {
        double[] difference = tree.forceDifference(TIME, k, ofVelocity);
        double[] change = tree.forceChange(TIME, k, ofVelocity);
        double scale = 1;
        for (double entry : difference) {
          scale = Math.max(scale, Math.abs(entry));
        }
        for (int i = 0; i < change.length; i++) {
          assertThat(change[i])
              .as("component %d by %s %d", i, ofVelocity ? "velocity" : "position", k)
              .isCloseTo(difference[i], within(1e-9 * scale));
        }
      }
    }
  }

  @MethodSource("typesAndSeeds")
  @ParameterizedTest
  void workOfForcesIsLostEnergyAndPower(JointType type, long seed) {
    ForcedTree tree = tree(type, seed);
    double[] forces = tree.evaluate(TIME);
    double power = tree.forces.power();
    double work = tree.workRate(forces);
    double energyRate = tree.potentialEnergyRate(TIME);
    assertThat(power - energyRate)
        .isCloseTo(work, within(1e-9 * (1 + Math.abs(work) + Math.abs(energyRate))));
  }

  /** A spring on a cut joint is the spring on the same joint of the tree. */
  @Test
  void angleOfACutJointCountsWholeTurns() {
    Attachment attachment = new Attachment(-1, Vector3.ZERO, 0, Vector3.ZERO, Rotation.IDENTITY);
    Revolute joint = new Revolute("j", attachment, new Vector3(0, 0, 1), 0, 1, Origin.NONE);
    JointSpringDamper spring =
        new JointSpringDamper(
            "spring",
            new ClosureCoordinate(0, 0),
            Expression.of(2),
            Expression.ZERO,
            Expression.ZERO,
            Expression.ZERO,
            Side.BOTH,
            Expression.ZERO,
            Origin.NONE);
    Mechanism wheel =
        new Mechanism(
            "wheel",
            new Root("ground", Vector3.ZERO, Rotation.IDENTITY),
            Vector3.ZERO,
            List.of(
                new Body(
                    "wheel", 1, Vector3.ZERO, new InertiaTensor(1, 1, 1, 0, 0, 0), Origin.NONE)),
            List.of(joint),
            List.of(),
            List.of(StartRole.FREE),
            List.of(new JointClosure(joint)),
            List.of(spring),
            List.of());
    ForcedTree tree = new ForcedTree(wheel, 1);
    for (int step = 0; step <= 100; step++) {
      tree.q[0] = 0.2 * step;
      double[] forces = tree.evaluate(TIME);
      tree.forces.accepted();
      assertThat(forces[2]).isCloseTo(-2 * tree.q[0], within(1e-14 * (1 + tree.q[0])));
    }
  }
}
