package org.mechservice.solver.mechanism.closure;

import org.mechservice.solver.mechanism.Origin;

/**
 * A condition between bodies, or between coordinates, that the tree does not hold by itself. Any
 * number of them may depend on each other.
 */
public sealed interface LoopClosure
    permits JointClosure,
        DistanceClosure,
        CoordinateClosure,
        PointOnPlaneClosure,
        PointOnLineClosure {
  /** Returns the name in the model file. */
  String name();

  /** Returns where it was written down. */
  Origin origin();
}
