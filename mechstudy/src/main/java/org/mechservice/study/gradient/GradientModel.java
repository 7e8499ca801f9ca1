package org.mechservice.study.gradient;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.mechservice.sim.gradient.DifferentiableFunction;
import org.mechservice.sim.gradient.ModelFunctions;
import org.mechservice.sim.gradient.ProgramCode;
import org.mechservice.sim.gradient.VariationalEquations;

/**
 * The equations of a model with their derivatives along all directions: inputs of the code by
 * differentiation of the program, parameters that are folded into it by differences of fourth order
 * at the same state, start values by themselves. Workspace of one thread.
 */
final class GradientModel {
  /** Values at −2h, −h, h, 2h. */
  private static final int SIDES = 4;

  final ModelFunctions functions;
  final VariationalEquations equations;
  final DifferentiableFunction columns;
  final List<Direction> directions;
  final int n;
  final int c;
  final int p;
  final int inputCount;

  /** Whether a column depends on y'. */
  final boolean columnsUseRates;

  private final double[] here;
  private final double[] margin;
  private final double[] marginBeside;
  private final double[] column;
  private final double[][] beside;
  private final Map<Part, Known> known = new EnumMap<>(Part.class);
  private final double[] seed;
  private final double[] out;
  private final double[] adjoint;
  private final double[] columnSeed;
  private final double[] columnOut;
  private final double[] columnSeeds;

  GradientModel(ModelFunctions functions, List<Direction> directions) {
    this.functions = functions;
    this.directions = directions;
    equations = functions.equations();
    columns = functions.columns();
    n = equations.states();
    c = columns.count();
    p = directions.size();
    inputCount = (int) directions.stream().filter(d -> d.input() >= 0).count();
    columnsUseRates = columns.usesFrom(n);
    here = new double[n];
    margin = new double[functions.switches().count()];
    marginBeside = new double[margin.length];
    column = new double[c];
    int most =
        Math.max(
            Math.max(n, c), Math.max(functions.triggers().count(), functions.switches().count()));
    beside = new double[SIDES][Math.max(most, functions.assignments().count())];
    seed = new double[n + 1 + inputCount];
    out = new double[2 * n];
    adjoint = new double[n + 1 + inputCount];
    columnSeed = new double[2 * n + 1 + inputCount];
    columnOut = new double[2 * c];
    columnSeeds = new double[2 * n * p];
  }

  private int[] units() {
    return directions.stream().mapToInt(Direction::input).toArray();
  }

  /** Prepares tangents along all directions. */
  void prepareTangents() {
    equations.directions(units());
    columnsPrepared = false;
  }

  private boolean columnsPrepared;

  /** Evaluates y'; not a number where it has none. */
  void derivative(double t, double[] y, double[] yDot) {
    if (equations.derivative(t, y, yDot) != ProgramCode.REGULAR) {
      Arrays.fill(yDot, 0, n, Double.NaN);
    }
  }

  /**
   * Evaluates y' and the derivatives of the tangents.
   *
   * @param seeds tangents, direction after direction; not modified
   * @param result y', then the derivatives, n numbers each
   */
  void tangents(double t, double[] y, double[] seeds, double[] result) {
    if (equations.tangents(t, y, seeds, result) != ProgramCode.REGULAR) {
      Arrays.fill(result, 0, (p + 1) * n, Double.NaN);
    }
    for (int k = 0; k < p; k++) {
      if (directions.get(k).isSettled()) {
        addSettled(k, t, y, result, (k + 1) * n);
      }
    }
  }

  /**
   * Adds the derivative of f by a folded parameter. Where a switch lies between the values of the
   * parameter, f has another form on one side of it, and the differences are taken on the other.
   */
  private void addSettled(int k, double t, double[] y, double[] to, int at) {
    Direction direction = directions.get(k);
    for (int side = 0; side < SIDES; side++) {
      direction.beside().get(side).equations().derivative(t, y, beside[side]);
    }
    boolean below = isSameForm(direction, 0, t, y) && isSameForm(direction, 1, t, y);
    boolean above = isSameForm(direction, 2, t, y) && isSameForm(direction, 3, t, y);
    if (below == above) {
      addDifference(direction.step(), to, at, n);
      return;
    }
    equations.derivative(t, y, here);
    double[] near = beside[above ? 2 : 1];
    double[] far = beside[above ? 3 : 0];
    double h = above ? direction.step() : -direction.step();
    for (int i = 0; i < n; i++) {
      to[at + i] += (4 * (near[i] - here[i]) - (far[i] - here[i])) / (2 * h);
    }
  }

  /** Returns whether no switch lies between the model and one beside it. */
  private boolean isSameForm(Direction direction, int side, double t, double[] y) {
    if (margin.length == 0) {
      return true;
    }
    functions.switches().value(t, y, margin);
    direction.beside().get(side).switches().value(t, y, marginBeside);
    for (int i = 0; i < margin.length; i++) {
      if (margin[i] > 0 != marginBeside[i] > 0) {
        return false;
      }
    }
    return true;
  }

  /** Adds differences of fourth order: (8 (f₁ − f₋₁) − (f₂ − f₋₂)) / 12h, error h⁴ f⁽⁵⁾ / 30. */
  private void addDifference(double h, double[] to, int at, int count) {
    for (int i = 0; i < count; i++) {
      double near = beside[2][i] - beside[1][i];
      double far = beside[3][i] - beside[0][i];
      to[at + i] += (8 * near - far) / (12 * h);
    }
  }

  /** Adds the derivative of another function of the model by a folded parameter. */
  private void addSettled(int k, Part part, double t, double[] y, double[] to, int at, int count) {
    Direction direction = directions.get(k);
    for (int side = 0; side < SIDES; side++) {
      part.of(direction.beside().get(side)).value(t, y, beside[side]);
    }
    addDifference(direction.step(), to, at, count);
  }

  /** A function of a model. */
  enum Part {
    COLUMNS,
    TRIGGERS,
    SWITCHES,
    ASSIGNMENTS;

    DifferentiableFunction of(ModelFunctions functions) {
      return switch (this) {
        case COLUMNS -> functions.columns();
        case TRIGGERS -> functions.triggers();
        case SWITCHES -> functions.switches();
        case ASSIGNMENTS -> functions.assignments();
      };
    }
  }

  /** Values of a function at the place where it was evaluated last. */
  private static final class Known {
    final double[] y;
    final double[] values;
    double t = Double.NaN;

    Known(int states, int count) {
      y = new double[states];
      values = new double[count];
    }
  }

  /**
   * Returns the values of a function of t and y; evaluated once for a place that is asked for
   * again.
   *
   * @param y state, may be longer; not modified
   * @return not to be modified; overwritten for another place
   */
  double[] values(Part part, double t, double[] y) {
    DifferentiableFunction function = part.of(functions);
    Known last = known.computeIfAbsent(part, its -> new Known(n, function.count()));
    if (t != last.t || !Arrays.equals(last.y, 0, n, y, 0, n)) {
      function.value(t, y, last.values);
      last.t = t;
      System.arraycopy(y, 0, last.y, 0, n);
    }
    return last.values;
  }

  /** Returns y'' along the motion. */
  double[] second(double t, double[] y, double[] yDot) {
    System.arraycopy(yDot, 0, seed, 0, n);
    seed[n] = 1;
    Arrays.fill(seed, n + 1, seed.length, 0);
    equations.tangent(t, y, seed, out);
    return Arrays.copyOfRange(out, n, 2 * n);
  }

  /** Returns the columns; an array that the next call overwrites. */
  double[] columns(double t, double[] both) {
    columns.value(t, both, column);
    return column;
  }

  /** Returns the rates of the columns along the motion. */
  double[] columnRates(double t, double[] both) {
    double[] yDot = Arrays.copyOfRange(both, n, 2 * n);
    double[] yDotDot = second(t, both, yDot);
    System.arraycopy(yDot, 0, columnSeed, 0, n);
    System.arraycopy(yDotDot, 0, columnSeed, n, n);
    columnSeed[2 * n] = 1;
    Arrays.fill(columnSeed, 2 * n + 1, columnSeed.length, 0);
    columns.tangent(t, both, columnSeed, columnOut);
    return Arrays.copyOfRange(columnOut, c, 2 * c);
  }

  /**
   * Evaluates the columns and their derivatives along all directions.
   *
   * @param both [y; y']
   * @param tangents of y and, from {@code rates} on, of y'; direction after direction
   * @param result columns, then their derivatives, c numbers for each direction
   */
  void columnTangents(double t, double[] both, double[] tangents, double[] rates, double[] result) {
    if (!columnsPrepared) {
      columns.directions(units());
      columnsPrepared = true;
    }
    for (int k = 0; k < p; k++) {
      System.arraycopy(tangents, k * n, columnSeeds, k * 2 * n, n);
      System.arraycopy(rates, k * n, columnSeeds, (2 * k + 1) * n, n);
    }
    columns.tangents(t, both, columnSeeds, result);
    for (int k = 0; k < p; k++) {
      if (directions.get(k).isSettled()) {
        addSettled(k, Part.COLUMNS, t, both, result, (k + 1) * c, c);
      }
    }
  }

  /**
   * Returns the derivatives of a function of t and y along a direction.
   *
   * @param dy rate of y
   * @param dt rate of t
   * @param direction which parameter changes; −1: none
   */
  double[] along(Part part, double t, double[] y, double[] dy, double dt, int direction) {
    DifferentiableFunction function = part.of(functions);
    int count = function.count();
    System.arraycopy(dy, 0, seed, 0, n);
    seed[n] = dt;
    Arrays.fill(seed, n + 1, seed.length, 0);
    if (direction >= 0 && directions.get(direction).input() >= 0) {
      seed[n + 1 + directions.get(direction).input()] = 1;
    }
    double[] values = new double[2 * count];
    function.tangent(t, y, seed, values);
    double[] rates = Arrays.copyOfRange(values, count, 2 * count);
    if (direction >= 0 && directions.get(direction).isSettled()) {
      addSettled(direction, part, t, y, rates, 0, count);
    }
    return rates;
  }

  /**
   * Adds the derivatives of weights · f.
   *
   * @param sign factor of what is added
   * @param byState n numbers from {@code at} on
   * @param byDirection p numbers from {@code from} on
   */
  void addAdjoint(
      double t,
      double[] y,
      double[] weights,
      double sign,
      double[] byState,
      int at,
      double[] byDirection,
      int from) {
    if (equations.adjoint(t, y, weights, adjoint) != ProgramCode.REGULAR) {
      Arrays.fill(adjoint, Double.NaN);
    }
    spread(adjoint, n, sign, byState, at, byDirection, from);
    for (int k = 0; k < p; k++) {
      if (directions.get(k).isSettled()) {
        double[] slope = new double[n];
        addSettled(k, t, y, slope, 0);
        byDirection[from + k] += sign * dot(weights, slope, n);
      }
    }
  }

  private void spread(
      double[] slopes,
      int length,
      double sign,
      double[] byState,
      int at,
      double[] byDirection,
      int from) {
    for (int i = 0; i < length; i++) {
      byState[at + i] += sign * slopes[i];
    }
    for (int k = 0; k < p; k++) {
      int input = directions.get(k).input();
      if (input >= 0) {
        byDirection[from + k] += sign * slopes[length + 1 + input];
      }
    }
  }

  static double dot(double[] a, double[] b, int length) {
    double sum = 0;
    for (int i = 0; i < length; i++) {
      sum += a[i] * b[i];
    }
    return sum;
  }

  /**
   * Adds the derivatives of a weighted column.
   *
   * @param both [y; y']
   * @param byBoth 2n numbers: by y and by y'
   * @param byDirection p numbers from {@code from} on
   */
  void addColumnAdjoint(
      double t,
      double[] both,
      int which,
      double weight,
      double[] byBoth,
      double sign,
      double[] byDirection,
      int from) {
    double[] weights = new double[c];
    weights[which] = weight;
    double[] slopes = new double[2 * n + 1 + inputCount];
    columns.adjoint(t, both, weights, slopes);
    spread(slopes, 2 * n, 1, byBoth, 0, new double[p], 0);
    for (int k = 0; k < p; k++) {
      Direction direction = directions.get(k);
      if (direction.input() >= 0) {
        byDirection[from + k] += sign * slopes[2 * n + 1 + direction.input()];
      } else if (direction.isSettled()) {
        double[] slope = new double[c];
        addSettled(k, Part.COLUMNS, t, both, slope, 0, c);
        byDirection[from + k] += sign * weight * slope[which];
      }
    }
  }

  /**
   * Adds the derivatives of weights · values of a function of t and y.
   *
   * @return derivative by the time, without the sign
   */
  double addAdjointOf(
      Part part,
      double t,
      double[] y,
      double[] weights,
      double sign,
      double[] byState,
      double[] byDirection) {
    DifferentiableFunction function = part.of(functions);
    double[] slopes = new double[n + 1 + inputCount];
    function.adjoint(t, y, weights, slopes);
    spread(slopes, n, sign, byState, 0, byDirection, 0);
    for (int k = 0; k < p; k++) {
      if (directions.get(k).isSettled()) {
        int count = function.count();
        double[] slope = new double[count];
        addSettled(k, part, t, y, slope, 0, count);
        byDirection[k] += sign * dot(weights, slope, count);
      }
    }
    return slopes[n];
  }
}
