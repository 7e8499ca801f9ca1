package org.mechservice.library.proof;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import org.mechservice.solver.expression.Table;

/**
 * A function that is zero, or as good as zero, but for a narrow window of its argument, or that
 * rises there from 0 to 1.
 *
 * @param kind its form
 * @param low begin of the window
 * @param high end of the window
 */
record Window(Kind kind, double low, double high) {
  enum Kind {
    STEP,
    SMOOTH_STEP,
    RAMP,
    TRIANGLE,
    ABSOLUTE,
    PARABOLA,
    SIGNUM,
    LINEAR_TABLE,
    AKIMA_TABLE,
    CUBIC_TABLE,
    LINEAR_MAP,
    GAUSS,
    LORENTZ,
    RISE;

    boolean isTable() {
      return this == LINEAR_TABLE || this == AKIMA_TABLE || this == CUBIC_TABLE;
    }

    /** Whether the second derivative is bounded, so that a drive can follow it. */
    boolean drives() {
      return this == SMOOTH_STEP || this == GAUSS || this == PARABOLA || this == RISE;
    }
  }

  private static final List<Kind> PULSES =
      Arrays.stream(Kind.values()).filter(kind -> kind != Kind.RISE).toList();

  static Kind any(Random random) {
    return PULSES.get(random.nextInt(PULSES.size()));
  }

  private double width() {
    return high - low;
  }

  private double centre() {
    return low + 0.5 * width();
  }

  /** Length of an edge. */
  private double edge() {
    return 0.2 * width();
  }

  private double scale() {
    return switch (kind) {
      case GAUSS -> width() / 6;
      case LORENTZ -> width() / 20;
      default -> 0.5 * width();
    };
  }

  /** Returns the function as an expression of an argument. */
  String text(String u) {
    String from = "(" + u + " - " + low + ")";
    String to = "(" + high + " - " + u + ")";
    String middle = "((" + u + " - " + centre() + ")/" + scale() + ")";
    return switch (kind) {
      case STEP -> "step" + from + "*step" + to;
      case SIGNUM -> "(signum" + from + " + signum" + to + ")/2";
      case SMOOTH_STEP ->
          "(smoothStep("
              + from
              + "/"
              + edge()
              + ") - smoothStep(("
              + u
              + " - "
              + (high - edge())
              + ")/"
              + edge()
              + "))";
      case RAMP ->
          "min(1, max(0, " + from + "/" + edge() + "))*min(1, max(0, " + to + "/" + edge() + "))";
      case TRIANGLE -> "max(0, min(" + from + ", " + to + "))/" + scale();
      case ABSOLUTE -> "max(0, 1 - abs" + middle + ")";
      case PARABOLA -> "max(0, 1 - " + middle + "^2)^3";
      case LINEAR_TABLE, AKIMA_TABLE, CUBIC_TABLE -> "narrow(" + u + ")";
      case LINEAR_MAP -> "narrow(" + u + ", t)";
      case GAUSS -> "exp(-" + middle + "^2)";
      case LORENTZ -> "1/(1 + " + middle + "^2)^2";
      case RISE -> "smoothStep(" + from + "/" + width() + ")";
    };
  }

  private double[] tableArguments() {
    return new double[] {
      low - 3 * width(),
      low - width(),
      low,
      low + edge(),
      high - edge(),
      high,
      high + width(),
      high + 3 * width()
    };
  }

  private static final double[] VALUES = {0, 0, 0, 1, 1, 0, 0, 0};

  private static String list(double[] values) {
    return DoubleStream.of(values).mapToObj(Double::toString).collect(Collectors.joining(";"));
  }

  /** Returns the tables that the expression needs. */
  String tables() {
    if (kind == Kind.LINEAR_MAP) {
      return "<map name='narrow' extrapolation='hold' x='"
          + list(tableArguments())
          + "' y='0;1' z='"
          + list(DoubleStream.of(VALUES).flatMap(z -> DoubleStream.of(z, z)).toArray())
          + "'/>";
    }
    return kind.isTable()
        ? "<table name='narrow' method='"
            + method().name().toLowerCase(java.util.Locale.ROOT)
            + "' extrapolation='hold' x='"
            + list(tableArguments())
            + "' y='"
            + list(VALUES)
            + "'/>"
        : "";
  }

  private Table.Method method() {
    return switch (kind) {
      case AKIMA_TABLE -> Table.Method.AKIMA;
      case CUBIC_TABLE -> Table.Method.CUBIC;
      default -> Table.Method.LINEAR;
    };
  }

  /** Returns the function; of tables that curve, the interpolation is the product's. */
  java.util.function.DoubleUnaryOperator values() {
    if (kind.isTable() || kind == Kind.LINEAR_MAP) {
      Table table =
          new Table(
              "narrow",
              DoubleStream.of(tableArguments()).boxed().toList(),
              DoubleStream.of(VALUES).boxed().toList(),
              method(),
              Table.Extrapolation.HOLD);
      return table.curve()::at;
    }
    return this::value;
  }

  private double value(double u) {
    double z = (u - centre()) / scale();
    return switch (kind) {
      case STEP, SIGNUM -> u >= low && u <= high ? 1 : 0;
      case SMOOTH_STEP ->
          smoothStep((u - low) / edge()) - smoothStep((u - (high - edge())) / edge());
      case RAMP -> clamp((u - low) / edge()) * clamp((high - u) / edge());
      case TRIANGLE -> Math.max(0, Math.min(u - low, high - u)) / scale();
      case ABSOLUTE -> Math.max(0, 1 - Math.abs(z));
      case PARABOLA -> Math.pow(Math.max(0, 1 - z * z), 3);
      case GAUSS -> Math.exp(-z * z);
      case LORENTZ -> 1 / ((1 + z * z) * (1 + z * z));
      default -> smoothStep((u - low) / width());
    };
  }

  /** Returns the slope of a function whose slope has no jump. */
  double slope(double u) {
    double z = (u - centre()) / scale();
    return switch (kind) {
      case SMOOTH_STEP ->
          (rise((u - low) / edge()) - rise((u - (high - edge())) / edge())) / edge();
      case PARABOLA -> -6 * z * Math.pow(Math.max(0, 1 - z * z), 2) / scale();
      case GAUSS -> -2 * z * Math.exp(-z * z) / scale();
      default -> throw new IllegalStateException("the slope of " + kind + " jumps");
    };
  }

  private static double rise(double x) {
    return x <= 0 || x >= 1 ? 0 : 6 * x * (1 - x);
  }

  private static double clamp(double x) {
    return Math.min(1, Math.max(0, x));
  }

  private static double smoothStep(double x) {
    double y = clamp(x);
    return y * y * (3 - 2 * y);
  }

  /** Returns the arguments between which the function is smooth enough for quadrature. */
  double[] places() {
    return switch (kind) {
      case GAUSS, LORENTZ -> {
        double reach = kind == Kind.GAUSS ? 7 : 1e7;
        yield DoubleStream.concat(
                DoubleStream.of(0),
                DoubleStream.iterate(0.5, z -> z < reach, z -> 1.5 * z)
                    .flatMap(z -> DoubleStream.of(z, -z)))
            .map(z -> centre() + z * scale())
            .toArray();
      }
      case LINEAR_TABLE, AKIMA_TABLE, CUBIC_TABLE, LINEAR_MAP -> tableArguments();
      default -> new double[] {low, low + edge(), centre(), high - edge(), high};
    };
  }
}
