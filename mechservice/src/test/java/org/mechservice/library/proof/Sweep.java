package org.mechservice.library.proof;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;

/**
 * An argument as a function of a variable z, the time or a coordinate, over 0 to an end.
 *
 * @param kind its form
 * @param end end of z
 * @param rate ω of a sine, 1/L of a fraction
 */
record Sweep(Kind kind, double end, double rate) {
  enum Kind {
    PLAIN,
    SQUARE,
    CUBE,
    ROOT,
    EXPONENTIAL,
    SINE,
    COSINE,
    FRACTION
  }

  static Sweep any(Random random, double end, boolean plain) {
    Kind kind = plain ? Kind.PLAIN : Kind.values()[random.nextInt(Kind.values().length)];
    double rate = Spread.rounded(Spread.even(random, 1.5, 40) / end);
    return new Sweep(kind, end, rate);
  }

  double at(double z) {
    return switch (kind) {
      case PLAIN -> z;
      case SQUARE -> z * z;
      case CUBE -> z * z * z;
      case ROOT -> Math.sqrt(z + end);
      case EXPONENTIAL -> Math.exp(2 * z / end);
      case SINE -> Math.sin(rate * z);
      case COSINE -> Math.cos(rate * z);
      case FRACTION -> rate * z - Math.floor(rate * z);
    };
  }

  String text(String z) {
    return switch (kind) {
      case PLAIN -> z;
      case SQUARE -> z + "*" + z;
      case CUBE -> z + "^3";
      case ROOT -> "sqrt(" + z + " + " + end + ")";
      case EXPONENTIAL -> "exp(2*" + z + "/" + end + ")";
      case SINE -> "sin(" + rate + "*" + z + ")";
      case COSINE -> "cos(" + rate + "*" + z + ")";
      case FRACTION -> "(" + rate + "*" + z + " - floor(" + rate + "*" + z + "))";
    };
  }

  /** Returns all z within the interval at which the argument has a value, and where it turns. */
  double[] inverse(double[] values) {
    List<Double> found = new ArrayList<>();
    for (double u : values) {
      switch (kind) {
        case PLAIN -> found.add(u);
        case SQUARE -> found.add(Math.sqrt(Math.max(0, u)));
        case CUBE -> found.add(Math.cbrt(u));
        case ROOT -> found.add(u * u - end);
        case EXPONENTIAL -> found.add(0.5 * end * Math.log(Math.max(1e-300, u)));
        case SINE -> {
          double angle = Math.asin(Math.max(-1, Math.min(1, u)));
          for (int k = -1; k < rate * end / Math.PI + 2; k++) {
            found.add((k % 2 == 0 ? angle + k * Math.PI : -angle + k * Math.PI) / rate);
          }
        }
        case COSINE -> {
          double angle = Math.acos(Math.max(-1, Math.min(1, u)));
          for (int k = 0; k < rate * end / Math.PI + 2; k++) {
            found.add((angle + 2 * k * Math.PI) / rate);
            found.add((-angle + 2 * k * Math.PI) / rate);
          }
        }
        default -> {
          for (int k = 0; k < rate * end + 1; k++) {
            if (u >= 0 && u <= 1) {
              found.add((u + k) / rate);
            }
          }
        }
      }
    }
    // turning points of waves, jumps of fractions
    double between = kind == Kind.FRACTION ? 1 / rate : 0.5 * Math.PI / rate;
    if (kind == Kind.SINE || kind == Kind.COSINE || kind == Kind.FRACTION) {
      for (int k = 0; k * between <= end; k++) {
        found.add(k * between);
      }
    }
    return found.stream().mapToDouble(Double::doubleValue).toArray();
  }

  /** Returns the window that z passes between two places, or again and again. */
  Window window(Window.Kind of, double from, double width) {
    double one = at(from);
    double other = at(from + width);
    return new Window(of, Math.min(one, other), Math.max(one, other));
  }

  /** Returns the shortest way of z between two ends of a window that are not one. */
  double shortest(Window window) {
    double[] ends = {window.low(), window.high()};
    double[] at = Arrays.stream(inverse(ends)).filter(z -> z > 0 && z < end).sorted().toArray();
    double shortest = end;
    for (int i = 0; i + 1 < at.length; i++) {
      double between = at[i + 1] - at[i];
      if (between > 1e-9 * end) {
        shortest = Math.min(shortest, between);
      }
    }
    return shortest;
  }
}
