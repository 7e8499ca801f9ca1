package org.mechservice.solver.expression;

import org.mechservice.solver.spatial.Powers;

/**
 * An operation of a tape on one or two earlier values, f(a) or f(a, b), with first and second
 * partial derivatives. StrictMath is used wherever Math may differ between machines.
 */
enum Operation implements TapeStep {
  ADD {
    @Override
    public double value(double a, double b, LocalDerivatives d) {
      return a + b;
    }

    @Override
    public void differentiate(double a, double b, LocalDerivatives d) {
      d.linear(1, 1);
    }
  },
  MULTIPLY {
    @Override
    public double value(double a, double b, LocalDerivatives d) {
      return a * b;
    }

    @Override
    public void differentiate(double a, double b, LocalDerivatives d) {
      d.all(b, a, 0, 1, 0);
    }
  },
  DIVIDE {
    @Override
    public double value(double a, double b, LocalDerivatives d) {
      return a / b;
    }

    @Override
    public void differentiate(double a, double b, LocalDerivatives d) {
      double f = a / b;
      d.all(1 / b, -f / b, 0, -1 / (b * b), 2 * f / (b * b));
    }
  },
  NEGATE {
    @Override
    public double value(double a, double b, LocalDerivatives d) {
      return -a;
    }

    @Override
    public void differentiate(double a, double b, LocalDerivatives d) {
      d.single(-1, 0);
    }
  },
  /** a², the compiled form of a ^ 2. */
  SQUARE {
    @Override
    public double value(double a, double b, LocalDerivatives d) {
      return a * a;
    }

    @Override
    public void differentiate(double a, double b, LocalDerivatives d) {
      d.single(2 * a, 2);
    }
  },
  SQRT {
    @Override
    public double value(double a, double b, LocalDerivatives d) {
      return Math.sqrt(a);
    }

    @Override
    public void differentiate(double a, double b, LocalDerivatives d) {
      double f = Math.sqrt(a);
      d.single(0.5 / f, -0.25 / (a * f));
    }
  },
  ABS {
    @Override
    public double value(double a, double b, LocalDerivatives d) {
      return Math.abs(a);
    }

    @Override
    public void differentiate(double a, double b, LocalDerivatives d) {
      d.single(StrictMath.signum(a), 0);
    }
  },
  SIN {
    @Override
    public double value(double a, double b, LocalDerivatives d) {
      return d.sin(a);
    }

    @Override
    public void differentiate(double a, double b, LocalDerivatives d) {
      d.single(d.cos(a), -d.sin(a));
    }
  },
  COS {
    @Override
    public double value(double a, double b, LocalDerivatives d) {
      return d.cos(a);
    }

    @Override
    public void differentiate(double a, double b, LocalDerivatives d) {
      d.single(-d.sin(a), -d.cos(a));
    }
  },
  TAN {
    @Override
    public double value(double a, double b, LocalDerivatives d) {
      return d.sin(a) / d.cos(a);
    }

    @Override
    public void differentiate(double a, double b, LocalDerivatives d) {
      double f = d.sin(a) / d.cos(a);
      d.single(1 + f * f, 2 * f * (1 + f * f));
    }
  },
  ASIN {
    @Override
    public double value(double a, double b, LocalDerivatives d) {
      return StrictMath.asin(a);
    }

    @Override
    public void differentiate(double a, double b, LocalDerivatives d) {
      double s = 1 - a * a;
      d.single(1 / Math.sqrt(s), a / (s * Math.sqrt(s)));
    }
  },
  ACOS {
    @Override
    public double value(double a, double b, LocalDerivatives d) {
      return StrictMath.acos(a);
    }

    @Override
    public void differentiate(double a, double b, LocalDerivatives d) {
      double s = 1 - a * a;
      d.single(-1 / Math.sqrt(s), -a / (s * Math.sqrt(s)));
    }
  },
  ATAN {
    @Override
    public double value(double a, double b, LocalDerivatives d) {
      return StrictMath.atan(a);
    }

    @Override
    public void differentiate(double a, double b, LocalDerivatives d) {
      double s = 1 + a * a;
      d.single(1 / s, -2 * a / (s * s));
    }
  },
  /** Its derivatives count as 0 at the origin, where the angle is not defined. */
  ATAN2 {
    @Override
    public double value(double a, double b, LocalDerivatives d) {
      return StrictMath.atan2(a, b);
    }

    @Override
    public void differentiate(double a, double b, LocalDerivatives d) {
      double s = a * a + b * b;
      if (s == 0) {
        d.linear(0, 0);
        return;
      }
      d.all(b / s, -a / s, -2 * a * b / (s * s), (a * a - b * b) / (s * s), 2 * a * b / (s * s));
    }
  },
  EXP {
    @Override
    public double value(double a, double b, LocalDerivatives d) {
      return StrictMath.exp(a);
    }

    @Override
    public void differentiate(double a, double b, LocalDerivatives d) {
      double f = StrictMath.exp(a);
      d.single(f, f);
    }
  },
  LOG {
    @Override
    public double value(double a, double b, LocalDerivatives d) {
      return StrictMath.log(a);
    }

    @Override
    public void differentiate(double a, double b, LocalDerivatives d) {
      d.single(1 / a, -1 / (a * a));
    }
  },
  MIN {
    @Override
    public double value(double a, double b, LocalDerivatives d) {
      return Math.min(a, b);
    }

    @Override
    public void differentiate(double a, double b, LocalDerivatives d) {
      boolean first = a <= b;
      d.linear(first ? 1 : 0, first ? 0 : 1);
    }
  },
  MAX {
    @Override
    public double value(double a, double b, LocalDerivatives d) {
      return Math.max(a, b);
    }

    @Override
    public void differentiate(double a, double b, LocalDerivatives d) {
      boolean first = a >= b;
      d.linear(first ? 1 : 0, first ? 0 : 1);
    }
  },
  SINH {
    @Override
    public double value(double a, double b, LocalDerivatives d) {
      return StrictMath.sinh(a);
    }

    @Override
    public void differentiate(double a, double b, LocalDerivatives d) {
      d.single(StrictMath.cosh(a), StrictMath.sinh(a));
    }
  },
  COSH {
    @Override
    public double value(double a, double b, LocalDerivatives d) {
      return StrictMath.cosh(a);
    }

    @Override
    public void differentiate(double a, double b, LocalDerivatives d) {
      d.single(StrictMath.sinh(a), StrictMath.cosh(a));
    }
  },
  TANH {
    @Override
    public double value(double a, double b, LocalDerivatives d) {
      return StrictMath.tanh(a);
    }

    @Override
    public void differentiate(double a, double b, LocalDerivatives d) {
      double f = StrictMath.tanh(a);
      double c = StrictMath.cosh(a);
      // 1/cosh² keeps its digits where 1 − tanh² has none left
      double slope = 1 / (c * c);
      d.single(slope, -2 * f * slope);
    }
  },
  SIGNUM {
    @Override
    public double value(double a, double b, LocalDerivatives d) {
      return Math.signum(a);
    }

    @Override
    public void differentiate(double a, double b, LocalDerivatives d) {
      d.single(0, 0);
    }
  },
  /** Its derivatives count as 0 at the origin, where it is not differentiable. */
  HYPOT {
    @Override
    public double value(double a, double b, LocalDerivatives d) {
      return StrictMath.hypot(a, b);
    }

    @Override
    public void differentiate(double a, double b, LocalDerivatives d) {
      double h = StrictMath.hypot(a, b);
      if (h == 0) {
        d.linear(0, 0);
        return;
      }
      double u = a / h;
      double w = b / h;
      d.all(u, w, w * w / h, -u * w / h, u * u / h);
    }
  },
  FLOOR {
    @Override
    public double value(double a, double b, LocalDerivatives d) {
      return Math.floor(a);
    }

    @Override
    public void differentiate(double a, double b, LocalDerivatives d) {
      d.single(0, 0);
    }
  },
  STEP {
    @Override
    public double value(double a, double b, LocalDerivatives d) {
      return a < 0 ? 0 : a >= 0 ? 1 : a;
    }

    @Override
    public void differentiate(double a, double b, LocalDerivatives d) {
      d.single(0, 0);
    }
  },
  SMOOTH_STEP {
    @Override
    public double value(double a, double b, LocalDerivatives d) {
      return smoothStep(a);
    }

    @Override
    public void differentiate(double a, double b, LocalDerivatives d) {
      boolean between = a > 0 && a < 1;
      d.single(between ? 6 * a * (1 - a) : 0, between ? 6 - 12 * a : 0);
    }
  },
  /** a to the power of b; the derivative by b requires a positive a. */
  POWER {
    @Override
    public double value(double a, double b, LocalDerivatives d) {
      return Powers.power(a, b);
    }

    @Override
    public void differentiate(double a, double b, LocalDerivatives d) {
      double f = Powers.power(a, b);
      double n = b * (b - 1);
      // a zero factor gives zero, even if the other factor is infinite
      double slope = b == 0 ? 0 : b * Powers.power(a, b - 1);
      double bend = n == 0 ? 0 : n * Powers.power(a, b - 2);
      if (a == 0) {
        d.all(slope, 0, bend, 0, 0);
        return;
      }
      double log = StrictMath.log(a);
      d.all(slope, f * log, bend, Powers.power(a, b - 1) * (1 + b * log), f * log * log);
    }
  };

  private static double smoothStep(double a) {
    double s = Math.max(0, Math.min(1, a));
    return s * s * (3 - 2 * s);
  }
}
