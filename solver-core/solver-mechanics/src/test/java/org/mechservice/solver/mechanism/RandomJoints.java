package org.mechservice.solver.mechanism;

import static org.mechservice.solver.mechanism.RandomTrees.axis;
import static org.mechservice.solver.mechanism.RandomTrees.rotation;
import static org.mechservice.solver.mechanism.RandomTrees.vector;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Cylindrical;
import org.mechservice.solver.mechanism.joint.Free;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.JointStart;
import org.mechservice.solver.mechanism.joint.Planar;
import org.mechservice.solver.mechanism.joint.Prismatic;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.mechanism.joint.Screw;
import org.mechservice.solver.mechanism.joint.Spherical;
import org.mechservice.solver.mechanism.joint.Universal;
import org.mechservice.solver.mechanism.joint.Weld;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/** Seeded joints of a type, with coordinates and velocities around 1. */
public final class RandomJoints {
  private RandomJoints() {}

  /** Returns a joint that leads from one body to another, half of them against the file's sense. */
  public static Joint joint(Random random, JointType type, int parent, int child) {
    return random.nextBoolean()
        ? forward(random, type, parent, child)
        : forward(random, type, child, parent).reversed();
  }

  /** Returns a joint whose file sense leads from one body to another. */
  public static Joint forward(Random random, JointType type, int body1, int body2) {
    boolean parallel = type.hasEulerParameters();
    Attachment attachment =
        new Attachment(
            body1,
            vector(random).times(0.5),
            body2,
            vector(random).times(0.2),
            parallel ? Rotation.IDENTITY : rotation(random));
    return with(random, type, "j" + Math.max(body1, body2), attachment);
  }

  /** Returns a joint between two bodies as they are attached. */
  public static Joint with(Random random, JointType type, String name, Attachment attachment) {
    Vector3 axis = axis(random);
    Vector3 second = attachment.zeroRotation().transposed().apply(normalTo(axis));
    double q = 2 * random.nextDouble() - 1;
    double v = 2 * random.nextDouble() - 1;
    JointStart start = start(random, type);
    return switch (type) {
      case R -> new Revolute(name, attachment, axis, q, v, Origin.NONE);
      case P -> new Prismatic(name, attachment, axis, q, v, Origin.NONE);
      case H -> new Screw(name, attachment, axis, 0.4 * random.nextGaussian(), q, v, Origin.NONE);
      case C -> new Cylindrical(name, attachment, axis, start, Origin.NONE);
      case U -> new Universal(name, attachment, axis, second, start, false, Origin.NONE);
      case PL -> new Planar(name, attachment, axis, normalTo(axis), start, false, Origin.NONE);
      case S -> new Spherical(name, attachment, start, false, Origin.NONE);
      case F -> new Free(name, attachment, start, false, Origin.NONE);
      case W -> new Weld(name, attachment, Origin.NONE);
    };
  }

  private static Vector3 normalTo(Vector3 axis) {
    Vector3 aside = Math.abs(axis.x()) < 0.7 ? new Vector3(1, 0, 0) : new Vector3(0, 1, 0);
    return axis.cross(aside).normalized();
  }

  private static JointStart start(Random random, JointType type) {
    List<Double> q = new ArrayList<>(numbers(random, type.positionCount()));
    if (type.hasEulerParameters()) {
      double norm = Math.sqrt(q.subList(0, 4).stream().mapToDouble(e -> e * e).sum());
      q.subList(0, 4).replaceAll(e -> e / norm);
    }
    return new JointStart(q, numbers(random, type.velocityCount()));
  }

  private static List<Double> numbers(Random random, int count) {
    return IntStream.range(0, count).mapToObj(i -> 2 * random.nextDouble() - 1).toList();
  }

  /** Returns every type with each of some seeds, for parameterised tests. */
  public static Stream<Object[]> typesAndSeeds() {
    return Stream.of(JointType.values())
        .flatMap(type -> IntStream.range(1, 5).mapToObj(seed -> new Object[] {type, seed}));
  }
}
