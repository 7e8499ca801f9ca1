package org.mechservice.library;

import java.util.Optional;
import java.util.function.Consumer;

/**
 * A body of a {@link MechanismBuilder}. Lengths and masses are in the units of the model, all
 * coordinates in the body's axes. A body has a {@link #mass}, its {@link #center} and its {@link
 * #inertia}, or solids, which give all three.
 *
 * <p>Where a number depends on parameters, {@link #element} takes it as an expression: {@code
 * element("point", "name", "tip", "x", "length", "y", "0", "z", "0")}.
 */
public final class BodyElement extends BuiltElement<BodyElement> {
  BodyElement(BuiltElement<?> parent) {
    super("body", Optional.of(parent));
  }

  @Override
  BodyElement self() {
    return this;
  }

  private OtherElement add(String element, Consumer<OtherElement> values) {
    return add(new OtherElement(element, this), values);
  }

  /** Adds a point. */
  public BodyElement point(String name, double x, double y, double z) {
    add("point", point -> point.set("name", name).set("x", x).set("y", y).set("z", z));
    return this;
  }

  /** Adds a vector; its length has no meaning. */
  public BodyElement vector(String name, double vx, double vy, double vz) {
    add("vector", it -> it.set("name", name).set("vx", vx).set("vy", vy).set("vz", vz));
    return this;
  }

  /** Gives the body a mass. */
  public BodyElement mass(double value) {
    add("mass", mass -> mass.set("value", value));
    return this;
  }

  /** Gives the body a mass in a unit of its own. */
  public BodyElement mass(double value, String unit) {
    add("mass", mass -> mass.set("value", value, unit));
    return this;
  }

  /** Gives the body its centre of mass. */
  public BodyElement center(double x, double y, double z) {
    add("cog", center -> center.set("x", x).set("y", y).set("z", z));
    return this;
  }

  /** Gives the body its moments of inertia about the centre of mass. */
  public BodyElement inertia(double ixx, double iyy, double izz) {
    add("inertiaTensor", it -> it.set("Ixx", ixx).set("Iyy", iyy).set("Izz", izz));
    return this;
  }

  /**
   * Gives the body its inertia about the centre of mass; the last three are elements of the matrix,
   * not products of inertia.
   */
  public BodyElement inertia(
      double ixx, double iyy, double izz, double ixy, double ixz, double iyz) {
    add(
        "inertiaTensor",
        it ->
            it.set("Ixx", ixx)
                .set("Iyy", iyy)
                .set("Izz", izz)
                .set("Ixy", ixy)
                .set("Ixz", ixz)
                .set("Iyz", iyz));
    return this;
  }

  /** Adds a box with its edges along the axes; {@code density} or {@code mass} is to be set. */
  public OtherElement box(double x, double y, double z) {
    return add("box", box -> box.set("x", x).set("y", y).set("z", z));
  }

  /**
   * Adds a cylinder; {@code density} or {@code mass} is to be set.
   *
   * @param from a point's name, or {@code x;y;z}
   * @param to of the other end
   */
  public OtherElement cylinder(double radius, String from, String to) {
    return add("cylinder", it -> it.set("radius", radius).set("from", from).set("to", to));
  }

  /**
   * Adds a pointed cone; {@code density} or {@code mass} is to be set, and {@code top} makes it a
   * frustum.
   *
   * @param from the centre of its base: a point's name, or {@code x;y;z}
   * @param to its tip
   */
  public OtherElement cone(double radius, String from, String to) {
    return add("cone", it -> it.set("radius", radius).set("from", from).set("to", to));
  }

  /** Adds a sphere about the origin, or about its {@code point} if that is set. */
  public OtherElement sphere(double radius) {
    return add("sphere", ball -> ball.set("radius", radius));
  }
}
