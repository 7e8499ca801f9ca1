package org.mechservice.sim.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.mechanism.Armature;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/**
 * Random open chains: turning and sliding joints, branches, massless bodies between bodies with
 * mass, axes along coordinates and oblique, any zero rotations, joint points off the body origins,
 * a root that is moved and turned, armatures of some joints. Joints and bodies stand in an order in
 * which a child may come before its parent.
 */
public final class RandomMechmlTrees {
  private final Random random;
  private final boolean allJoints;

  private RandomMechmlTrees(long seed, boolean allJoints) {
    random = new Random(seed);
    this.allJoints = allJoints;
  }

  /** Returns a tree of 2 to 8 bodies, by turns with driven joints, all joints, or R and P alone. */
  public static Mechanism anyKind(int seed) {
    int bodies = 2 + seed % 7;
    return switch (seed % 3) {
      case 0 -> driven(seed, bodies);
      case 1 -> ofAllJoints(seed, bodies);
      default -> tree(seed, bodies);
    };
  }

  /** Returns the tree of a seed. */
  public static Mechanism tree(long seed, int bodies) {
    return new RandomMechmlTrees(seed, false).tree("tree" + seed, bodies);
  }

  /** Returns a tree of joints of all types. */
  public static Mechanism ofAllJoints(long seed, int bodies) {
    return new RandomMechmlTrees(seed, true).tree("mixed" + seed, bodies);
  }

  /** Returns a tree of joints of all types, some of which are driven. */
  public static Mechanism driven(long seed, int bodies) {
    Mechanism free = ofAllJoints(seed, bodies);
    return new Mechanism(
            "driven" + seed,
            free.root(),
            free.gravity(),
            free.bodies(),
            free.joints(),
            new RandomMechmlJoints(new Random(seed)).motions(free.joints()),
            free.startRoles(),
            List.of(),
            List.of(),
            List.of())
        .withArmatures(free.armatures());
  }

  /** Returns a random state [q; v] of a tree. */
  public static double[] state(long seed, Mechanism mechanism) {
    Random random = new Random(~seed);
    double[] y = new double[mechanism.positionCount() + mechanism.velocityCount()];
    for (int i = 0; i < y.length; i++) {
      y[i] = 4 * random.nextDouble() - 2;
    }
    return y;
  }

  private Mechanism tree(String name, int count) {
    List<Integer> places = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      places.add(random.nextInt(places.size() + 1), i);
    }
    List<Body> bodies = new ArrayList<>();
    List<Joint> joints = new ArrayList<>();
    boolean[] leaf = new boolean[count];
    int[] parents = new int[count];
    for (int i = 0; i < count; i++) {
      leaf[i] = true;
      parents[i] = i == 0 ? -1 : random.nextInt(Math.max(0, i - 3), i);
      if (i > 0) {
        leaf[parents[i]] = false;
      }
    }
    for (int place = 0; place < count; place++) {
      int i = places.get(place);
      boolean massless = !allJoints && !leaf[i] && random.nextInt(4) == 0;
      bodies.add(body("b" + i, massless));
      int parent = parents[i] < 0 ? Mechanism.ROOT : places.indexOf(parents[i]);
      joints.add(joint("j" + i, parent, place));
    }
    Root root = new Root("ground", vector(3), rotation());
    return armed(new Mechanism(name, root, new Vector3(1, -2, -9), bodies, joints));
  }

  /** Gives every fourth joint an armature. */
  private static Mechanism armed(Mechanism bare) {
    Random own = new Random(bare.name().hashCode());
    List<Armature> armatures = new ArrayList<>();
    for (int j = 0; j < bare.joints().size(); j++) {
      JointType type = bare.joints().get(j).type();
      if (type.velocityCount() > 0 && own.nextInt(4) == 0) {
        double turning = own.nextDouble();
        List<Double> inertias = new ArrayList<>();
        for (int k = 0; k < type.velocityCount(); k++) {
          inertias.add(type.hasEulerParameters() && k < 3 ? turning : own.nextDouble());
        }
        armatures.add(new Armature(j, inertias));
      }
    }
    return bare.withArmatures(armatures);
  }

  private Body body(String name, boolean massless) {
    if (massless) {
      return new Body(name, 0, Vector3.ZERO, InertiaTensor.ZERO, Origin.NONE);
    }
    double x = 0.1 + random.nextDouble();
    double y = 0.1 + random.nextDouble();
    double z = 0.1 + random.nextDouble();
    InertiaTensor principal = new InertiaTensor(y + z, x + z, x + y, 0, 0, 0);
    InertiaTensor inertia = random.nextBoolean() ? principal : principal.in(rotation());
    return new Body(name, 0.5 + random.nextDouble(), vector(0.5), inertia, Origin.NONE);
  }

  private Joint joint(String name, int parent, int child) {
    Rotation zero = random.nextInt(3) == 0 ? rotation() : Rotation.IDENTITY;
    Attachment attachment = new Attachment(parent, vector(0.5), child, vector(0.5), zero);
    if (allJoints) {
      return new RandomMechmlJoints(random).any(name, attachment, axis());
    }
    String type = random.nextInt(3) == 0 ? "P" : "R";
    return Scenes.joint(name, type, attachment, axis(), vector(1).x(), vector(1).y());
  }

  private Vector3 axis() {
    return switch (random.nextInt(5)) {
      case 0 -> new Vector3(1, 0, 0);
      case 1 -> new Vector3(0, -1, 0);
      case 2 -> new Vector3(0, 0, 1);
      case 3 -> new Vector3(0, 0.6, -0.8);
      default -> vector(1).plus(new Vector3(0, 0, 2));
    };
  }

  private Rotation rotation() {
    Vector3 axis = vector(1).plus(new Vector3(0, 0, 2)).normalized();
    return Rotation.about(axis, 6 * random.nextDouble() - 3);
  }

  private Vector3 vector(double size) {
    return new Vector3(
            2 * random.nextDouble() - 1, 2 * random.nextDouble() - 1, 2 * random.nextDouble() - 1)
        .times(size);
  }
}
