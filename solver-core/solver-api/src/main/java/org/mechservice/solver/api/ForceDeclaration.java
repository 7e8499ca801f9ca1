package org.mechservice.solver.api;

/**
 * The names of a model, through which a {@link UserForce} declares before the run what it uses. The
 * numbers returned are arguments of {@link ForceState} and {@link ForceLoads}.
 */
public interface ForceDeclaration {
  /** A quantity read of a point. */
  enum Reads {
    /** Its position. */
    POSITION,
    /** The rotation of its body. */
    ROTATION,
    /** Its velocity. */
    VELOCITY,
    /** The angular velocity of its body. */
    ANGULAR_VELOCITY
  }

  /**
   * Declares a point to read or to act on.
   *
   * @param body name of the body, or of the root
   * @param point name of the point
   * @param reads quantities that will be read; reading others is an error, and difference quotients
   *     are cheaper with fewer quantities. Empty for a point that is only acted on
   * @throws IllegalArgumentException if there is no such body or point
   */
  int point(String body, String point, Reads... reads);

  /**
   * Declares a point by its position in a body, for points without a name in the model.
   *
   * @param body name of the body, or of the root
   * @param x from the body's origin in body axes, m; likewise y and z
   * @param reads as for {@link #point}
   * @throws IllegalArgumentException if there is no such body
   */
  int pointAt(String body, double x, double y, double z, Reads... reads);

  /**
   * Declares a coordinate of a joint to read or to act on.
   *
   * @param joint name of a joint of the tree
   * @param component index among the joint's velocities, from 0
   * @throws IllegalArgumentException if there is no such joint or component
   */
  int coordinate(String joint, int component);

  /**
   * Declares a tunable parameter.
   *
   * @throws IllegalArgumentException if there is no such parameter
   */
  int parameter(String name);

  /**
   * Declares an output value of the force: column {@code <force>.<name>}.
   *
   * @param unit SI unit, {@code 1} for a pure number
   */
  int value(String name, String unit);
}
