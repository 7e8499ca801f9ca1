package org.mechservice.sim.scene;

import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.KnifeEdgeClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.closure.PointOnLineClosure;
import org.mechservice.solver.mechanism.closure.PointOnPlaneClosure;
import org.mechservice.solver.mechanism.closure.RollingClosure;

/** Names of the kinds of constraints in reports. */
final class LoopKind {
  private LoopKind() {}

  /** Returns the kind of a constraint in words, such as {@code distance, rod of mass}. */
  static String of(LoopClosure closure) {
    if (closure instanceof JointClosure joint) {
      return "joint " + joint.joint().type() + (joint.isDriven() ? ", driven" : "");
    }
    if (closure instanceof DistanceClosure distance) {
      return distance.hasRod() ? "distance, rod with mass" : "distance";
    }
    if (closure instanceof PointOnPlaneClosure) {
      return "point on plane";
    }
    if (closure instanceof PointOnLineClosure) {
      return "point on line";
    }
    if (closure instanceof RollingClosure rolling) {
      return rolling.isBall() ? "rolling ball" : "rolling wheel";
    }
    if (closure instanceof KnifeEdgeClosure) {
      return "knife edge";
    }
    return "coupling";
  }
}
