package org.mechservice.solver.expression;

import java.util.function.IntToDoubleFunction;
import org.mechservice.solver.expression.Table.Extrapolation;
import org.mechservice.solver.expression.Table.Method;
import org.mechservice.solver.spatial.NumberTable;
import org.mechservice.solver.symbol.Enclosure;
import org.mechservice.solver.symbol.GivenFunction;
import org.mechservice.solver.symbol.WatchedStep;

/**
 * The surface of a map: for each cell of the grid Σᵢⱼ cᵢⱼ dxⁱ dyʲ, i, j = 0 to 3, with dx and dy
 * from the cell's origin, and cells beyond the edges. Immutable.
 *
 * <p>In every direction a cell is what {@link TableCurve} is on a line. It is given by values,
 * slopes and twists ∂²z/∂x∂y at its corners. Slopes and twists of a spline are those of splines
 * along the lines of the grid, which commute; the twists of the other curve that has slopes are
 * those of H. Akima, A method of bivariate interpolation and smooth surface fitting based on local
 * procedures, Communications of the ACM 17 (1974) 18: the divided differences of the four cells
 * around a point with the weights of both directions.
 */
public final class MapSurface implements WatchedStep, GivenFunction {
  /** Numbers of a cell: 16 coefficients, then its origin. */
  private static final int NUMBERS = 18;

  private static final int ORIGIN_X = 16;
  private static final int ORIGIN_Y = 17;

  private final double[] x;
  private final double[] y;
  private final double[] originX;
  private final double[] originY;
  private final double[] cells;
  private final boolean bounded;
  private final boolean straight;
  private final boolean holds;

  MapSurface(TableMap map) {
    x = map.x().stream().mapToDouble(Double::doubleValue).toArray();
    y = map.y().stream().mapToDouble(Double::doubleValue).toArray();
    originX = origins(x);
    originY = origins(y);
    cells = new double[NUMBERS * originX.length * originY.length];
    bounded = map.outside() == Extrapolation.ERROR;
    straight = map.method() == Method.LINEAR;
    holds = map.outside() == Extrapolation.HOLD;
    double[][] z = new double[x.length][y.length];
    double[][] byX = new double[x.length][y.length];
    double[][] byY = new double[x.length][y.length];
    for (int i = 0; i < x.length; i++) {
      for (int j = 0; j < y.length; j++) {
        z[i][j] = map.z().get(i * y.length + j);
      }
      byY[i] = TableCurve.slopes(map.method(), y, z[i]);
    }
    for (int j = 0; j < y.length; j++) {
      setColumn(byX, j, TableCurve.slopes(map.method(), x, column(z, j)));
    }
    double[][] twist = map.method() == Method.AKIMA ? akimaTwists(z) : twists(map.method(), byX);
    fill(map, new double[][][] {z, byX}, new double[][][] {byY, twist});
  }

  private static double[] origins(double[] knots) {
    double[] origins = new double[knots.length + 1];
    origins[0] = knots[0];
    System.arraycopy(knots, 0, origins, 1, knots.length);
    return origins;
  }

  private static double[] column(double[][] rows, int j) {
    double[] column = new double[rows.length];
    for (int i = 0; i < column.length; i++) {
      column[i] = rows[i][j];
    }
    return column;
  }

  private static void setColumn(double[][] rows, int j, double[] column) {
    for (int i = 0; i < column.length; i++) {
      rows[i][j] = column[i];
    }
  }

  /** Slopes along y of the slopes along x. */
  private double[][] twists(Method method, double[][] byX) {
    double[][] twist = new double[x.length][];
    for (int i = 0; i < x.length; i++) {
      twist[i] = TableCurve.slopes(method, y, byX[i]);
    }
    return twist;
  }

  private double[][] akimaTwists(double[][] z) {
    double[][] chords = new double[x.length][];
    for (int i = 0; i < x.length; i++) {
      chords[i] = TableCurve.extended(TableCurve.chords(y, z[i]));
    }
    double[][] twist = new double[x.length][y.length];
    // second differences: [line of the grid along x beyond its ends][along y beyond its ends]
    double[][] second = new double[x.length + 3][y.length + 3];
    for (int b = 0; b < y.length + 3; b++) {
      setColumn(second, b, TableCurve.extended(TableCurve.chords(x, column(chords, b))));
    }
    for (int j = 0; j < y.length; j++) {
      double[] alongX = TableCurve.extended(TableCurve.chords(x, column(z, j)));
      for (int i = 0; i < x.length; i++) {
        double p = TableCurve.weightBefore(alongX, i);
        double q = TableCurve.weightBefore(chords[i], j);
        twist[i][j] =
            p * (q * second[i + 1][j + 1] + (1 - q) * second[i + 1][j + 2])
                + (1 - p) * (q * second[i + 2][j + 1] + (1 - q) * second[i + 2][j + 2]);
      }
    }
    return twist;
  }

  /**
   * @param onGrid values and slopes along x
   * @param alongY slopes of both along y
   */
  private void fill(TableMap map, double[][][] onGrid, double[][][] alongY) {
    double[] along = new double[4];
    double[][] values = new double[4][y.length];
    double[][] slopes = new double[4][y.length];
    for (int k = 0; k < originX.length; k++) {
      for (int j = 0; j < y.length; j++) {
        int at = j;
        cubic(map, x, k, i -> onGrid[0][i][at], i -> onGrid[1][i][at], along);
        setColumn(values, j, along);
        cubic(map, x, k, i -> alongY[0][i][at], i -> alongY[1][i][at], along);
        setColumn(slopes, j, along);
      }
      for (int l = 0; l < originY.length; l++) {
        int c = NUMBERS * (k * originY.length + l);
        for (int i = 0; i < 4; i++) {
          int power = i;
          cubic(map, y, l, j -> values[power][j], j -> slopes[power][j], along);
          System.arraycopy(along, 0, cells, c + 4 * i, 4);
        }
        cells[c + ORIGIN_X] = originX[k];
        cells[c + ORIGIN_Y] = originY[l];
      }
    }
  }

  /** Writes the polynomial of an interval: 0 before the first knot, n behind the last. */
  private static void cubic(
      TableMap map,
      double[] knots,
      int place,
      IntToDoubleFunction value,
      IntToDoubleFunction slope,
      double[] c) {
    int n = knots.length;
    boolean inside = place > 0 && place < n;
    int from = Math.max(0, place - 1);
    c[0] = value.applyAsDouble(from);
    c[1] = map.outside() == Extrapolation.HOLD ? 0 : slope.applyAsDouble(from);
    c[2] = 0;
    c[3] = 0;
    if (inside) {
      double h = knots[place] - knots[from];
      double chord = (value.applyAsDouble(place) - c[0]) / h;
      if (map.method() == Method.LINEAR) {
        c[1] = chord;
      } else {
        double start = slope.applyAsDouble(from);
        double end = slope.applyAsDouble(place);
        c[1] = start;
        c[2] = (3 * chord - 2 * start - end) / h;
        c[3] = (start + end - 2 * chord) / (h * h);
      }
    }
  }

  /** Returns whether there are no values beyond the grid. */
  public boolean isBounded() {
    return bounded;
  }

  /**
   * Returns the arguments of the points, ascending; a copy.
   *
   * @param argument 0 for x, 1 for y
   */
  public double[] knots(int argument) {
    return (argument == 0 ? x : y).clone();
  }

  /**
   * Returns the origins of cells along one argument, by how many knots are not above it; a copy.
   *
   * @param argument 0 for x, 1 for y
   */
  public double[] origins(int argument) {
    return (argument == 0 ? originX : originY).clone();
  }

  /**
   * Returns one coefficient of all cells: of cell (k, l) at k (m + 1) + l, where k knots along x
   * and l of the m knots along y are not above the arguments.
   *
   * @param i power of dx
   * @param j power of dy
   */
  public double[] coefficients(int i, int j) {
    double[] all = new double[cells.length / NUMBERS];
    for (int cell = 0; cell < all.length; cell++) {
      all[cell] = cells[NUMBERS * cell + 4 * i + j];
    }
    return all;
  }

  /** Returns whether its slope jumps at the lines of the grid. */
  public boolean hasCorners() {
    return straight;
  }

  /**
   * Returns the lines of the grid at which a slope jumps, ascending.
   *
   * @param axis 0: x, 1: y
   */
  public double[] corners(int axis) {
    return TableCurve.corners(axis == 0 ? x : y, straight, holds);
  }

  @Override
  public String name() {
    return "MAP";
  }

  @Override
  public boolean hasPieces() {
    return straight;
  }

  @Override
  public boolean isNarrow() {
    return !straight;
  }

  @Override
  public boolean isEven(double aLow, double aHigh, double bLow, double bHigh, double highest) {
    return crossings(aLow, aHigh, bLow, bHigh) <= 1;
  }

  /** Returns the number of a point's cell: k (m + 1) + l as in {@link #coefficients}. */
  @Override
  public double piece(double a, double b) {
    int k = (int) NumberTable.interval(x, 0, x.length, a);
    return k * originY.length + (int) NumberTable.interval(y, 0, y.length, b);
  }

  /** Returns the distance of a point from the nearest line of the grid, along one argument. */
  @Override
  public double distance(double a, double b) {
    return Math.min(TableCurve.distance(x, a), TableCurve.distance(y, b));
  }

  /** Returns how many lines of the grid, along one argument at most, two intervals cross. */
  private int crossings(double aFrom, double aTo, double bFrom, double bTo) {
    double alongX =
        NumberTable.interval(x, 0, x.length, aTo) - NumberTable.interval(x, 0, x.length, aFrom);
    double alongY =
        NumberTable.interval(y, 0, y.length, bTo) - NumberTable.interval(y, 0, y.length, bFrom);
    return (int) Math.max(alongX, alongY);
  }

  @Override
  public void bound(double aFrom, double aTo, double bFrom, double bTo, Enclosure bounds) {
    double low = Double.POSITIVE_INFINITY;
    double high = Double.NEGATIVE_INFINITY;
    int lastX = (int) NumberTable.interval(x, 0, x.length, aTo);
    int firstY = (int) NumberTable.interval(y, 0, y.length, bFrom);
    int lastY = (int) NumberTable.interval(y, 0, y.length, bTo);
    for (int k = (int) NumberTable.interval(x, 0, x.length, aFrom); k <= lastX; k++) {
      double a0 = (k == 0 ? aFrom : Math.max(aFrom, x[k - 1])) - originX[k];
      double a1 = (k == x.length ? aTo : Math.min(aTo, x[k])) - originX[k];
      for (int l = firstY; l <= lastY; l++) {
        double b0 = (l == 0 ? bFrom : Math.max(bFrom, y[l - 1])) - originY[l];
        double b1 = (l == y.length ? bTo : Math.min(bTo, y[l])) - originY[l];
        cellBounds(NUMBERS * (k * originY.length + l), a0, a1, b0, b1, bounds);
        low = Math.min(low, bounds.low());
        high = Math.max(high, bounds.high());
      }
    }
    bounds.set(low, high);
    bounds.settle(Enclosure.ROUNDING_OF_TABLE);
  }

  /** Bounds of a cell's polynomial by Horner's rule on intervals. */
  private void cellBounds(int c, double a0, double a1, double b0, double b1, Enclosure bounds) {
    double low = 0;
    double high = 0;
    for (int i = 3; i >= 0; i--) {
      double rowLow = 0;
      double rowHigh = 0;
      for (int j = 3; j >= 0; j--) {
        bounds.product(rowLow, rowHigh, b0, b1);
        rowLow = bounds.low() + cells[c + 4 * i + j];
        rowHigh = bounds.high() + cells[c + 4 * i + j];
      }
      bounds.product(low, high, a0, a1);
      low = bounds.low() + rowLow;
      high = bounds.high() + rowHigh;
    }
    bounds.set(low, high);
  }

  private boolean isOutside(double a, double b) {
    return !(a >= x[0] && a <= x[x.length - 1] && b >= y[0] && b <= y[y.length - 1]);
  }

  @Override
  public double place(double a, double b) {
    return piece(a, b);
  }

  @Override
  public double value(double a, double b, double place) {
    if (bounded && isOutside(a, b)) {
      return Double.NaN;
    }
    int c = NUMBERS * (int) place;
    double dx = a - cells[c + ORIGIN_X];
    double dy = b - cells[c + ORIGIN_Y];
    return along(c, dy)
        + dx * (along(c + 4, dy) + dx * (along(c + 8, dy) + dx * along(c + 12, dy)));
  }

  private double along(int c, double d) {
    return cells[c] + d * (cells[c + 1] + d * (cells[c + 2] + d * cells[c + 3]));
  }

  @Override
  public GivenFunction slope(int argument) {
    return new Slope(this, 1 - argument, argument);
  }

  @Override
  public GivenFunction origin() {
    return this;
  }

  /** A derivative, {@code byX} times by x and {@code byY} times by y. */
  private record Slope(MapSurface origin, int byX, int byY) implements GivenFunction {
    @Override
    public double place(double a, double b) {
      return origin.piece(a, b);
    }

    @Override
    public double value(double a, double b, double place) {
      return origin.slopeAt(a, b, (int) place, byX, byY);
    }

    @Override
    public GivenFunction slope(int argument) {
      return new Slope(origin, byX + 1 - argument, byY + argument);
    }
  }

  private double slopeAt(double a, double b, int cell, int byX, int byY) {
    int c = NUMBERS * cell;
    double dx = a - cells[c + ORIGIN_X];
    double dy = b - cells[c + ORIGIN_Y];
    return TableCurve.slope(
        byX,
        dx,
        slopeAlong(c, dy, byY),
        slopeAlong(c + 4, dy, byY),
        slopeAlong(c + 8, dy, byY),
        slopeAlong(c + 12, dy, byY));
  }

  private double slopeAlong(int c, double d, int order) {
    return TableCurve.slope(order, d, cells[c], cells[c + 1], cells[c + 2], cells[c + 3]);
  }
}
