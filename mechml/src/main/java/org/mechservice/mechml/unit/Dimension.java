package org.mechservice.mechml.unit;

import java.util.Map;
import java.util.StringJoiner;

/**
 * A dimension as powers of the base quantities. Angles have a dimension of their own, so that
 * degrees do not pass for metres.
 *
 * @param mass power of mass
 * @param length power of length
 * @param time power of time
 * @param angle power of angle
 */
public record Dimension(int mass, int length, int time, int angle) {
  public static final Dimension NONE = new Dimension(0, 0, 0, 0);
  public static final Dimension MASS = new Dimension(1, 0, 0, 0);
  public static final Dimension LENGTH = new Dimension(0, 1, 0, 0);
  public static final Dimension TIME = new Dimension(0, 0, 1, 0);
  public static final Dimension ANGLE = new Dimension(0, 0, 0, 1);
  public static final Dimension INERTIA = new Dimension(1, 2, 0, 0);
  public static final Dimension ACCELERATION = new Dimension(0, 1, -2, 0);
  public static final Dimension FORCE = new Dimension(1, 1, -2, 0);

  private static final Map<Dimension, String> NAMES =
      Map.of(
          NONE, "a pure number",
          MASS, "a mass",
          LENGTH, "a length",
          TIME, "a time",
          ANGLE, "an angle",
          INERTIA, "a moment of inertia",
          ACCELERATION, "an acceleration",
          FORCE, "a force");

  /** Returns the dimension of a product. */
  public Dimension times(Dimension other) {
    return new Dimension(
        mass + other.mass, length + other.length, time + other.time, angle + other.angle);
  }

  /** Returns the dimension of a power. */
  public Dimension power(int n) {
    return new Dimension(n * mass, n * length, n * time, n * angle);
  }

  /** Returns the dimension in words, such as "a length", or as powers if it has no name. */
  @Override
  public String toString() {
    return NAMES.getOrDefault(this, powers());
  }

  private String powers() {
    StringJoiner product = new StringJoiner("*");
    addPower(product, "mass", mass);
    addPower(product, "length", length);
    addPower(product, "time", time);
    addPower(product, "angle", angle);
    return product.toString();
  }

  private static void addPower(StringJoiner product, String base, int power) {
    if (power != 0) {
      product.add(power == 1 ? base : base + "^" + power);
    }
  }
}
