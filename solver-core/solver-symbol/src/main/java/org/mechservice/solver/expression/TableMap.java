package org.mechservice.solver.expression;

import java.util.List;
import org.mechservice.solver.symbol.GivenFunction;

/**
 * A function of two arguments given on a grid: z at ascending x and y.
 *
 * @param name name in the model file
 * @param x first arguments, strictly ascending, at least two
 * @param y second arguments, strictly ascending, at least two
 * @param z values, row by row: all of the first x, then all of the second
 * @param method surface between the points
 * @param outside values beyond the grid, for each argument apart
 */
public record TableMap(
    String name,
    List<Double> x,
    List<Double> y,
    List<Double> z,
    Table.Method method,
    Table.Extrapolation outside)
    implements PointFunction {
  public TableMap {
    x = List.copyOf(x);
    y = List.copyOf(y);
    z = List.copyOf(z);
    Table.checkAscending(name, x);
    Table.checkAscending(name, y);
    if (z.size() != x.size() * y.size()) {
      throw new IllegalArgumentException(
          "map " + name + " has " + z.size() + " values on " + x.size() + " x " + y.size());
    }
  }

  @Override
  public List<List<Double>> grid() {
    return List.of(x, y);
  }

  @Override
  public GivenFunction function() {
    return surface();
  }

  /** Returns its surface. */
  public MapSurface surface() {
    return new MapSurface(this);
  }

  /** {@inheritDoc} Tables of one model differ by name. */
  @Override
  public int hashCode() {
    return name.hashCode();
  }
}
