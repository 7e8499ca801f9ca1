package org.mechservice.sim.equations.recursion;

import org.mechservice.sim.symbolic.ScalarVector;

/** Forces that act in the joints themselves. */
public interface JointForces {
  /**
   * Returns the forces along the axes of a link's computing frame: of a link that turns or slides
   * the third alone counts, N·m or N; of one with Euler parameters all three are moments on the
   * link, N·m.
   */
  ScalarVector of(int link);
}
