package org.mechservice.solver.mechanism.closure;

import org.mechservice.solver.text.Origin;

/**
 * A constraint between bodies or between coordinates, in addition to the joints of the tree.
 * Constraints may be redundant.
 */
public sealed interface LoopClosure
    permits JointClosure,
        DistanceClosure,
        CoordinateClosure,
        PointOnPlaneClosure,
        PointOnLineClosure,
        RollingClosure,
        KnifeEdgeClosure {
  /** Returns the name in the model file. */
  String name();

  /** Returns its position in the model file. */
  Origin origin();
}
