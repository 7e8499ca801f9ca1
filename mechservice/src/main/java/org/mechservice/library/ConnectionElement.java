package org.mechservice.library;

import java.util.Optional;

/**
 * A joint, a constraint or a force between two bodies of a {@link MechanismBuilder}. {@code
 * between} with points is for all of them; only a joint may have its place in the world instead:
 * {@link #between(String, String)}, {@link #at} and {@link #axis}.
 */
public final class ConnectionElement extends BuiltElement<ConnectionElement> {
  ConnectionElement(String name, BuiltElement<?> parent) {
    super(name, Optional.of(parent));
  }

  @Override
  ConnectionElement self() {
    return this;
  }

  /**
   * Connects a point of a body with a point of another.
   *
   * @param body1 a body's name
   * @param point1 one of its points
   * @param body2 another body's name
   * @param point2 one of its points
   */
  public ConnectionElement between(String body1, String point1, String body2, String point2) {
    element("body1", "name", body1, "point", point1);
    element("body2", "name", body2, "point", point2);
    return this;
  }

  /** Gives both bodies, which are connected with points already, one of their vectors each. */
  public ConnectionElement vectors(String vector1, String vector2) {
    section("body1").set("vector", vector1);
    section("body2").set("vector", vector2);
    return this;
  }

  /** Gives both bodies, which are connected with points already, their second vector each. */
  public ConnectionElement secondVectors(String vector1, String vector2) {
    section("body1").set("vector2", vector1);
    section("body2").set("vector2", vector2);
    return this;
  }

  /** Connects two bodies by a joint whose place in the world is given. */
  public ConnectionElement between(String body1, String body2) {
    return set("body1", body1).set("body2", body2);
  }

  /** Gives a joint the place of its point in the world at assembly, in the model's unit. */
  public ConnectionElement at(double x, double y, double z) {
    return set("at", x, y, z);
  }

  /** Gives a joint the direction of its axis in the world at assembly. */
  public ConnectionElement axis(double x, double y, double z) {
    return set("axis", x, y, z);
  }

  /** Gives a joint the direction of its second axis in the world at assembly. */
  public ConnectionElement secondAxis(double x, double y, double z) {
    return set("axis2", x, y, z);
  }
}
