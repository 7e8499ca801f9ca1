package org.mechservice.solver.expression;

import java.util.List;
import org.mechservice.solver.symbol.GivenFunction;

/**
 * A function of one argument given by points: y at ascending x.
 *
 * @param name name in the model file
 * @param x arguments, strictly ascending, at least two
 * @param y values, as many
 * @param slopes slopes at the points of a curve of cubics; empty if the method chooses them
 * @param method curve between the points
 * @param outside values beyond the first and the last point
 */
public record Table(
    String name,
    List<Double> x,
    List<Double> y,
    List<Double> slopes,
    Method method,
    Extrapolation outside)
    implements PointFunction {
  /** Curves between points. */
  public enum Method {
    /** Straight lines; the slope jumps at the points. */
    LINEAR,
    /**
     * Cubics whose slopes follow the neighbouring points only, with little overshoot beside a jump
     * (Akima 1970); the curvature jumps at the points.
     */
    AKIMA,
    /**
     * Cubics that rise and fall with the points: no value lies beyond those of its two neighbours
     * (Steffen 1990); the curvature jumps at the points. For tables of one argument.
     */
    MONOTONE,
    /** A cubic spline, whose curvature is continuous, with the ends not-a-knot (de Boor 2001). */
    CUBIC
  }

  /** Values beyond the ends. */
  public enum Extrapolation {
    /** The value at the end. */
    HOLD,
    /** The tangent at the end. */
    LINEAR,
    /** None: an evaluation there is not finite. */
    ERROR
  }

  public Table {
    x = List.copyOf(x);
    y = List.copyOf(y);
    slopes = List.copyOf(slopes);
    checkAscending(name, x);
    if (!slopes.isEmpty() && (slopes.size() != x.size() || method == Method.LINEAR)) {
      throw new IllegalArgumentException(
          "table " + name + " has " + slopes.size() + " slopes by method " + method);
    }
    if (y.size() != x.size()) {
      throw new IllegalArgumentException(
          "table " + name + " has " + x.size() + " arguments and " + y.size() + " values");
    }
  }

  /** A table whose method chooses the slopes at the points. */
  public Table(String name, List<Double> x, List<Double> y, Method method, Extrapolation outside) {
    this(name, x, y, List.of(), method, outside);
  }

  /** A table of cubics with given slopes at the points; the curvature jumps there. */
  public static Table hermite(
      String name, List<Double> x, List<Double> y, List<Double> slopes, Extrapolation outside) {
    return new Table(name, x, y, slopes, Method.AKIMA, outside);
  }

  static void checkAscending(String name, List<Double> arguments) {
    if (arguments.size() < 2) {
      throw new IllegalArgumentException(name + " has " + arguments.size() + " arguments");
    }
    for (int i = 1; i < arguments.size(); i++) {
      if (!(arguments.get(i) > arguments.get(i - 1))) {
        throw new IllegalArgumentException("the arguments of " + name + " do not ascend");
      }
    }
  }

  @Override
  public List<List<Double>> grid() {
    return List.of(x);
  }

  @Override
  public GivenFunction function() {
    return curve();
  }

  /** Returns its curve. */
  public TableCurve curve() {
    return new TableCurve(this);
  }

  /** {@inheritDoc} Tables of one model differ by name. */
  @Override
  public int hashCode() {
    return name.hashCode();
  }
}
