package org.mechservice.mechml.unit;

import java.util.Map;
import java.util.StringJoiner;

/**
 * A dimension as powers of the base quantities. Angles have a dimension of their own, so that
 * degrees cannot be used as metres.
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
  public static final Dimension TORQUE = new Dimension(1, 2, -2, 0);

  private static final Map<Dimension, String> NAMES =
      Map.ofEntries(
          Map.entry(NONE, "a pure number"),
          Map.entry(MASS, "a mass"),
          Map.entry(LENGTH, "a length"),
          Map.entry(TIME, "a time"),
          Map.entry(ANGLE, "an angle"),
          Map.entry(INERTIA, "a moment of inertia"),
          Map.entry(new Dimension(0, 1, -1, 0), "a speed"),
          Map.entry(new Dimension(0, 0, -1, 1), "an angular speed"),
          Map.entry(ACCELERATION, "an acceleration"),
          Map.entry(FORCE, "a force"),
          Map.entry(TORQUE, "a torque"),
          Map.entry(new Dimension(1, 0, -2, 0), "a force per length"),
          Map.entry(new Dimension(1, 0, -1, 0), "a force per speed"),
          Map.entry(new Dimension(1, 2, -2, -1), "a torque per angle"),
          Map.entry(new Dimension(1, 2, -1, -1), "a torque per angular speed"),
          Map.entry(new Dimension(0, 1, 0, -1), "a length per angle"));

  private static final Map<Dimension, String> SYMBOLS =
      Map.ofEntries(
          Map.entry(new Dimension(0, 1, -1, 0), "m/s"),
          Map.entry(new Dimension(0, 0, -1, 1), "rad/s"),
          Map.entry(ACCELERATION, "m/s^2"),
          Map.entry(FORCE, "N"),
          Map.entry(TORQUE, "N·m"),
          Map.entry(new Dimension(1, 0, -2, 0), "N/m"),
          Map.entry(new Dimension(1, 0, -1, 0), "N·s/m"),
          Map.entry(new Dimension(1, 2, -2, -1), "N·m/rad"),
          Map.entry(new Dimension(1, 2, -1, -1), "N·m·s/rad"),
          Map.entry(new Dimension(0, 1, 0, -1), "m/rad"));

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

  /** Returns the SI unit of the dimension, such as {@code N·m/rad}; {@code 1} for pure numbers. */
  public String siSymbol() {
    return SYMBOLS.getOrDefault(this, composedSymbol());
  }

  private String composedSymbol() {
    StringJoiner product = new StringJoiner("·").setEmptyValue("1");
    addPower(product, "kg", mass);
    addPower(product, "m", length);
    addPower(product, "s", time);
    addPower(product, "rad", angle);
    return product.toString();
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
