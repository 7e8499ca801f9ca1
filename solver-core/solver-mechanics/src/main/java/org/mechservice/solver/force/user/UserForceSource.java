package org.mechservice.solver.force.user;

import org.mechservice.solver.api.UserForce;
import org.mechservice.solver.mechanism.force.UserForceElement;

/** Makes the user's forces of a model: loads their classes, where that is allowed. */
public interface UserForceSource {
  /** Makes none. */
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
   * Returns a new force that nobody else uses.
   *
   * @throws IllegalArgumentException if its class cannot be loaded or is no user force
   */
  UserForce create(UserForceElement element);
}
