package org.mechservice.solver.oracle;

import java.util.List;
import java.util.function.IntFunction;

/** Equations and the bodies, root left out, that they depend on. */
record Condition(List<Integer> bodies, Equations equations) {
  /** Left sides of equations along a motion of the bodies. */
  interface Equations {
    List<Taylor> at(IntFunction<TaylorPose> pose, Taylor time);
  }
}
