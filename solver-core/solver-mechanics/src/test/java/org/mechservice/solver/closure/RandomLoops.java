package org.mechservice.solver.closure;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.RandomJoints;
import org.mechservice.solver.mechanism.RandomTrees;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.closure.PointOnLineClosure;
import org.mechservice.solver.mechanism.closure.PointOnPlaneClosure;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.oracle.GlobalFormulation;
import org.mechservice.solver.oracle.TaylorPose;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/**
 * Seeded trees of joints of all types whose positions at the start close loops of all kinds: cut
 * joints, rods with and without mass, points on planes and lines. Velocities at the start are for
 * assembly to fit.
 */
final class RandomLoops {
  private static final List<JointType> CUTS =
      Stream.of(JointType.values()).filter(type -> type != JointType.F).toList();

  private RandomLoops() {}

  /** Returns a mechanism with as many closures as asked for. */
  static Mechanism of(long seed, int bodyCount, int closureCount) {
    Mechanism tree = RandomTrees.ofAllJoints(seed, bodyCount);
    Random random = new Random(seed);
    TaylorPose[] poses = posesAtStart(tree);
    List<LoopClosure> closures = new ArrayList<>();
    for (int i = 0; i < closureCount; i++) {
      int second = random.nextInt(bodyCount);
      int first = random.nextInt(-1, second);
      TaylorPose onFirst = first < 0 ? root(tree) : poses[first];
      closures.add(closure(random, "c" + i, first, onFirst, second, poses[second]));
    }
    return new Mechanism(
            "loops" + seed,
            tree.root(),
            tree.gravity(),
            tree.bodies(),
            tree.joints(),
            List.of(),
            tree.startRoles(),
            closures,
            List.of(),
            List.of())
        .withArmatures(tree.armatures());
  }

  private static TaylorPose[] posesAtStart(Mechanism tree) {
    double[] y = new double[tree.positionCount() + tree.velocityCount()];
    tree.initialState(y);
    double[] still = new double[tree.velocityCount()];
    return new GlobalFormulation(tree, List.of()).poses(0, y, still, still);
  }

  private static TaylorPose root(Mechanism tree) {
    return GlobalFormulation.root(tree);
  }

  private static LoopClosure closure(
      Random random, String name, int first, TaylorPose a, int second, TaylorPose b) {
    BodyPoint onA = new BodyPoint(first, vector(random).times(0.5));
    Vector3 place = a.at(onA.position()).value();
    return switch (random.nextInt(5)) {
      case 0, 1 -> cut(random, name, onA, a, second, b);
      case 2 -> {
        BodyPoint onB = new BodyPoint(second, vector(random).times(0.5));
        double length = b.at(onB.position()).value().minus(place).norm();
        double mass = random.nextBoolean() ? 0 : 0.5 + random.nextDouble();
        yield new DistanceClosure(name, onA, onB, length, mass, Origin.NONE);
      }
      case 3 ->
          new PointOnPlaneClosure(
              name, at(second, b, place), onA, vector(random).normalized(), Origin.NONE);
      default ->
          new PointOnLineClosure(
              name, at(second, b, place), onA, vector(random).normalized(), Origin.NONE);
    };
  }

  /** A joint at zero, whatever the poses of its bodies. */
  private static LoopClosure cut(
      Random random, String name, BodyPoint onA, TaylorPose a, int second, TaylorPose b) {
    JointType type = CUTS.get(random.nextInt(CUTS.size()));
    Vector3 onB = at(second, b, a.at(onA.position()).value()).position();
    Rotation zero =
        type == JointType.S
            ? Rotation.IDENTITY
            : a.rotation().value().transposed().times(b.rotation().value());
    Attachment attachment = new Attachment(onA.body(), onA.position(), second, onB, zero);
    return new JointClosure(RandomJoints.with(random, type, name, attachment));
  }

  private static BodyPoint at(int body, TaylorPose pose, Vector3 place) {
    Vector3 from = place.minus(pose.position().value());
    return new BodyPoint(body, pose.rotation().value().transposed().apply(from));
  }

  private static Vector3 vector(Random random) {
    return new Vector3(
        2 * random.nextDouble() - 1, 2 * random.nextDouble() - 1, 2 * random.nextDouble() - 1);
  }
}
