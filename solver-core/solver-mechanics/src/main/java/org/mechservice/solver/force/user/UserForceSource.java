package org.mechservice.solver.force.user;

import org.mechservice.solver.api.UserForce;
import org.mechservice.solver.mechanism.force.UserForceElement;

/** Creates the user forces of a model; loads their classes if that is permitted. */
public interface UserForceSource {
  /** A source that creates no forces. */
  UserForceSource NONE =
      element -> {
        throw new IllegalArgumentException(
            "force "
                + element.name()
                + " is the class "
                + element.className()
                + ", but no classes of users are loaded here");
      };

  /**
   * Returns a new force.
   *
   * @throws IllegalArgumentException if its class cannot be loaded or is no user force
   */
  UserForce create(UserForceElement element);
}
