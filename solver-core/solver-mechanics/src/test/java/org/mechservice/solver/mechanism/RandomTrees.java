package org.mechservice.solver.mechanism;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.Prismatic;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/**
 * Seeded open chains with branches, oblique axes, displaced points and turned zero positions: of R
 * and P joints, or of all nine types, half of them taken against the file's sense; some joints have
 * an armature.
 */
public final class RandomTrees {
  private static final List<JointType> TYPES = List.of(JointType.values());

  private RandomTrees() {}

  /** Returns the tree of a seed. */
  public static Mechanism tree(long seed, int bodyCount) {
    Random random = new Random(seed);
    List<Body> bodies = new ArrayList<>();
    List<Joint> joints = new ArrayList<>();
    for (int i = 0; i < bodyCount; i++) {
      bodies.add(body(random, i));
      joints.add(joint(random, i));
    }
    Root root = new Root("ground", vector(random), rotation(random));
    return armed(
        seed, new Mechanism("random" + seed, root, vector(random).times(10), bodies, joints));
  }

  /** Returns a tree of joints of all types. */
  public static Mechanism ofAllJoints(long seed, int bodyCount) {
    Random random = new Random(seed);
    List<Body> bodies = new ArrayList<>();
    List<Joint> joints = new ArrayList<>();
    for (int i = 0; i < bodyCount; i++) {
      bodies.add(body(random, i));
      int parent = i == 0 ? Mechanism.ROOT : random.nextInt(-1, i);
      JointType type = TYPES.get(random.nextInt(TYPES.size()));
      joints.add(RandomJoints.joint(random, type, parent, i));
    }
    Root root = new Root("ground", vector(random), rotation(random));
    return armed(
        seed, new Mechanism("mixed" + seed, root, vector(random).times(10), bodies, joints));
  }

  /** Returns a tree of joints of all types whose first body floats and carries all others. */
  public static Mechanism floating(long seed, int bodyCount) {
    Random random = new Random(seed);
    List<Body> bodies = new ArrayList<>();
    List<Joint> joints = new ArrayList<>();
    for (int i = 0; i < bodyCount; i++) {
      bodies.add(body(random, i));
      int parent = i == 0 ? Mechanism.ROOT : random.nextInt(i);
      JointType type = i == 0 ? JointType.F : TYPES.get(random.nextInt(TYPES.size()));
      joints.add(RandomJoints.joint(random, type, parent, i));
    }
    Root root = new Root("space", vector(random), rotation(random));
    return armed(
        seed, new Mechanism("floating" + seed, root, vector(random).times(10), bodies, joints));
  }

  /** Gives every fourth joint an armature. */
  private static Mechanism armed(long seed, Mechanism bare) {
    Random random = new Random(~seed);
    List<Armature> armatures = new ArrayList<>();
    for (int j = 0; j < bare.joints().size(); j++) {
      JointType type = bare.joints().get(j).type();
      if (type.velocityCount() > 0 && random.nextInt(4) == 0) {
        double turning = random.nextDouble();
        List<Double> inertias = new ArrayList<>();
        for (int k = 0; k < type.velocityCount(); k++) {
          inertias.add(type.hasEulerParameters() && k < 3 ? turning : random.nextDouble());
        }
        armatures.add(new Armature(j, inertias));
      }
    }
    return bare.withArmatures(armatures);
  }

  /**
   * Returns a tree of joints of all types, and rods with mass between random points of random
   * bodies, the root among them. Distances play no part: nobody closes the loops.
   */
  public static Mechanism withRods(long seed, int bodyCount, int rodCount) {
    Mechanism tree = ofAllJoints(seed, bodyCount);
    Random random = new Random(seed);
    List<LoopClosure> rods = new ArrayList<>();
    for (int i = 0; i < rodCount; i++) {
      BodyPoint a = new BodyPoint(random.nextInt(bodyCount), vector(random).times(0.5));
      BodyPoint b = new BodyPoint(random.nextInt(bodyCount + 1) - 1, vector(random).times(0.5));
      rods.add(new DistanceClosure("rod" + i, a, b, 1, 1 + random.nextDouble(), Origin.NONE));
    }
    return new Mechanism(
            tree.name(),
            tree.root(),
            tree.gravity(),
            tree.bodies(),
            tree.joints(),
            List.of(),
            tree.startRoles(),
            rods,
            List.of(),
            List.of())
        .withArmatures(tree.armatures());
  }

  /**
   * A body of a few kilograms and decimetres; its inertia is that of three point masses, so it is
   * one a body can have.
   */
  private static Body body(Random random, int index) {
    double xx = 0;
    double yy = 0;
    double zz = 0;
    double xy = 0;
    double xz = 0;
    double yz = 0;
    for (int k = 0; k < 3; k++) {
      Vector3 p = vector(random).times(0.3);
      xx += p.y() * p.y() + p.z() * p.z();
      yy += p.x() * p.x() + p.z() * p.z();
      zz += p.x() * p.x() + p.y() * p.y();
      xy -= p.x() * p.y();
      xz -= p.x() * p.z();
      yz -= p.y() * p.z();
    }
    return new Body(
        "b" + index,
        0.5 + 3 * random.nextDouble(),
        vector(random).times(0.3),
        new InertiaTensor(xx, yy, zz, xy, xz, yz),
        Origin.NONE);
  }

  private static Joint joint(Random random, int index) {
    int parent = index == 0 ? Mechanism.ROOT : random.nextInt(-1, index);
    Attachment attachment =
        new Attachment(
            parent, vector(random).times(0.5), index, vector(random).times(0.2), rotation(random));
    Vector3 axis = axis(random);
    double q = 2 * random.nextDouble() - 1;
    double v = 2 * random.nextDouble() - 1;
    return random.nextInt(4) == 0
        ? new Prismatic("j" + index, attachment, axis, q, v, Origin.NONE)
        : new Revolute("j" + index, attachment, axis, q, v, Origin.NONE);
  }

  static Vector3 axis(Random random) {
    return switch (random.nextInt(5)) {
      case 0 -> new Vector3(1, 0, 0);
      case 1 -> new Vector3(0, -1, 0);
      case 2 -> new Vector3(0, 0, 1);
      default -> vector(random).normalized();
    };
  }

  static Rotation rotation(Random random) {
    return random.nextInt(3) == 0
        ? Rotation.IDENTITY
        : Rotation.about(vector(random).normalized(), 6 * random.nextDouble() - 3);
  }

  static Vector3 vector(Random random) {
    return new Vector3(
        2 * random.nextDouble() - 1, 2 * random.nextDouble() - 1, 2 * random.nextDouble() - 1);
  }
}
