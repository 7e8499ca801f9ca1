package org.mechservice.sim.equations.recursion;

import org.mechservice.solver.symbol.ScalarVector;

/** Forces applied in joints. */
public interface JointForces {
  /**
   * Returns the forces along the axes of a link's computing frame: only the third is used for a
   * link that rotates or slides, N·m or N; all three are moments on a link with Euler parameters,
   * N·m.
   */
  ScalarVector of(int link);
}
