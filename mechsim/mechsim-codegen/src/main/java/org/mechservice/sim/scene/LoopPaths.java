package org.mechservice.sim.scene;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.KnifeEdgeClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.closure.PointOnLineClosure;
import org.mechservice.solver.mechanism.closure.PointOnPlaneClosure;
import org.mechservice.solver.mechanism.closure.RollingClosure;
import org.mechservice.solver.mechanism.joint.Attachment;

/** The paths through the tree that constraints close to loops. */
public final class LoopPaths {
  private final Mechanism mechanism;

  /** Two bodies by index. */
  private record Pair(int first, int second) {}

  LoopPaths(Mechanism mechanism) {
    this.mechanism = mechanism;
  }

  /**
   * Returns the names of the bodies that a constraint connects; empty for a coupling of
   * coordinates.
   */
  List<String> bodies(LoopClosure closure) {
    List<String> names = new ArrayList<>();
    for (Pair pair : pair(closure)) {
      names.add(name(pair.first()));
      names.add(name(pair.second()));
    }
    return names;
  }

  /** Returns the names of the joints between the two bodies, from the first to the second. */
  List<String> path(LoopClosure closure) {
    List<String> path = new ArrayList<>();
    for (Pair pair : pair(closure)) {
      List<Integer> up = toRoot(pair.first());
      List<Integer> down = toRoot(pair.second());
      while (!up.isEmpty() && !down.isEmpty() && last(up) == last(down)) {
        up.remove(up.size() - 1);
        down.remove(down.size() - 1);
      }
      Collections.reverse(down);
      up.addAll(down);
      up.forEach(joint -> path.add(mechanism.joints().get(joint).name()));
    }
    return path;
  }

  /**
   * Returns the indices of the bodies that a constraint connects; none for a coupling of
   * coordinates.
   */
  public static List<Integer> indices(LoopClosure closure) {
    List<Integer> indices = new ArrayList<>();
    for (Pair pair : pair(closure)) {
      indices.add(pair.first());
      indices.add(pair.second());
    }
    return indices;
  }

  private static int last(List<Integer> list) {
    return list.get(list.size() - 1);
  }

  /** Returns one pair, or none. */
  private static List<Pair> pair(LoopClosure closure) {
    if (closure instanceof JointClosure joint) {
      Attachment attachment = joint.joint().attachment();
      return List.of(new Pair(attachment.parent(), attachment.child()));
    }
    if (closure instanceof DistanceClosure distance) {
      return List.of(new Pair(distance.point1().body(), distance.point2().body()));
    }
    if (closure instanceof PointOnPlaneClosure plane) {
      return List.of(new Pair(plane.plane().body(), plane.point().body()));
    }
    if (closure instanceof PointOnLineClosure line) {
      return List.of(new Pair(line.line().body(), line.point().body()));
    }
    if (closure instanceof RollingClosure rolling) {
      return List.of(new Pair(rolling.plane().body(), rolling.centre().body()));
    }
    if (closure instanceof KnifeEdgeClosure edge) {
      return List.of(new Pair(edge.ground().body(), edge.point().body()));
    }
    return List.of();
  }

  private String name(int body) {
    return body == Mechanism.ROOT ? mechanism.root().name() : mechanism.bodies().get(body).name();
  }

  private List<Integer> toRoot(int body) {
    List<Integer> joints = new ArrayList<>();
    for (int b = body; b != Mechanism.ROOT; ) {
      int joint = mechanism.jointOf(b);
      joints.add(joint);
      b = mechanism.joints().get(joint).attachment().parent();
    }
    return joints;
  }
}
