package org.mechservice.mechml.unit;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** The units with a symbol. */
public final class UnitSymbols {
  /** International avoirdupois pound, kg, exact by definition. */
  private static final double POUND = 0.45359237;

  /** Standard acceleration of free fall, m/s², exact by definition; makes lbf from lb. */
  private static final double STANDARD_GRAVITY = 9.80665;

  /** International foot, m, exact by definition. */
  private static final double FOOT = 0.3048;

  private static final Map<String, Unit> UNITS = new LinkedHashMap<>();

  static {
    UNITS.put("kg", new Unit(1, 1, Dimension.MASS));
    UNITS.put("g", new Unit(1, 1000, Dimension.MASS));
    UNITS.put("t", new Unit(1000, 1, Dimension.MASS));
    UNITS.put("lb", new Unit(POUND, 1, Dimension.MASS));
    UNITS.put("slug", new Unit(POUND * STANDARD_GRAVITY, FOOT, Dimension.MASS));
    UNITS.put("m", new Unit(1, 1, Dimension.LENGTH));
    UNITS.put("cm", new Unit(1, 100, Dimension.LENGTH));
    UNITS.put("mm", new Unit(1, 1000, Dimension.LENGTH));
    UNITS.put("in", new Unit(254, 10_000, Dimension.LENGTH));
    UNITS.put("ft", new Unit(3048, 10_000, Dimension.LENGTH));
    UNITS.put("rad", new Unit(1, 1, Dimension.ANGLE));
    UNITS.put("deg", new Unit(Math.PI, 180, Dimension.ANGLE));
    UNITS.put("s", new Unit(1, 1, Dimension.TIME));
    UNITS.put("ms", new Unit(1, 1000, Dimension.TIME));
    UNITS.put("min", new Unit(60, 1, Dimension.TIME));
    UNITS.put("h", new Unit(3600, 1, Dimension.TIME));
    UNITS.put("N", new Unit(1, 1, Dimension.FORCE));
    UNITS.put("kN", new Unit(1000, 1, Dimension.FORCE));
    UNITS.put("lbf", new Unit(POUND * STANDARD_GRAVITY, 1, Dimension.FORCE));
  }

  private UnitSymbols() {}

  /** Returns the unit of a symbol. */
  public static Optional<Unit> unit(String symbol) {
    return Optional.ofNullable(UNITS.get(symbol));
  }

  /** Returns all symbols. */
  public static Set<String> all() {
    return UNITS.keySet();
  }
}
