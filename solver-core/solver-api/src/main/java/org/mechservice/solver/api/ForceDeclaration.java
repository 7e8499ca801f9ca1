package org.mechservice.solver.api;

/**
 * The model by its names, as a {@link UserForce} sees it before the run. The numbers it gives are
 * what {@link ForceState} and {@link ForceLoads} want.
 */
public interface ForceDeclaration {
  /** What is read of a point. */
  enum Reads {
    /** Where it is. */
    POSITION,
    /** How its body is turned. */
    ROTATION,
    /** How fast it moves. */
    VELOCITY,
    /** How fast its body turns. */
    ANGULAR_VELOCITY
  }

  /**
   * Asks for a point to read or to act on.
   *
   * @param body name of the body, or of the root
   * @param point name of the point
   * @param reads what will be read of it; reading anything else is refused, and the fewer these
   *     are, the cheaper are differences. None for a point that is only acted on
   * @throws IllegalArgumentException if there is no such body or point
   */
  int point(String body, String point, Reads... reads);

  /**
   * Asks for a point by its place in a body, for those the model does not name.
   *
   * @param body name of the body, or of the root
   * @param x from the body's origin in body axes, m; likewise y and z
   * @param reads as for {@link #point}
   * @throws IllegalArgumentException if there is no such body
   */
  int pointAt(String body, double x, double y, double z, Reads... reads);

  /**
   * Asks for a coordinate of a joint to read or to act on.
   *
   * @param joint name of a joint of the tree
   * @param component among the joint's velocities, from 0
   * @throws IllegalArgumentException if there is no such joint or component
   */
  int coordinate(String joint, int component);

  /**
   * Asks for a tunable parameter.
   *
   * @throws IllegalArgumentException if there is no such parameter
   */
  int parameter(String name);

  /**
   * Adds a value that the force puts out: column {@code <force>.<name>}.
   *
   * @param unit SI unit, {@code 1} for a pure number
   */
  int value(String name, String unit);
}
