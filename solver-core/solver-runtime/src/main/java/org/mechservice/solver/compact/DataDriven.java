package org.mechservice.solver.compact;

import org.mechservice.solver.api.Model;
import org.mechservice.solver.force.user.UserForceSource;

/** The data-driven equations of motion of any mechanism. */
public final class DataDriven {
  private DataDriven() {}

  /**
   * Returns the equations of motion of a model's data, with its events.
   *
   * @param userForces creates the user forces
   * @throws IllegalArgumentException if the formulation or the closure does not fit the mechanism
   */
  public static Model model(CompactModel data, UserForceSource userForces) {
    return data.mechanism().closures().isEmpty()
        ? DataDrivenTree.model(data, userForces)
        : DataDrivenLoops.model(data, userForces);
  }
}
