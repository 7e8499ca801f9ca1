package org.mechservice.solver.oracle;

/** A function of time by its value and its first two derivatives. */
public record Taylor(double x, double d, double dd) {
  static final Taylor ZERO = of(0);
  static final Taylor ONE = of(1);

  static Taylor of(double constant) {
    return new Taylor(constant, 0, 0);
  }

  Taylor plus(Taylor b) {
    return new Taylor(x + b.x, d + b.d, dd + b.dd);
  }

  Taylor minus(Taylor b) {
    return new Taylor(x - b.x, d - b.d, dd - b.dd);
  }

  Taylor times(Taylor b) {
    return new Taylor(x * b.x, d * b.x + x * b.d, dd * b.x + 2 * d * b.d + x * b.dd);
  }

  Taylor times(double factor) {
    return new Taylor(factor * x, factor * d, factor * dd);
  }

  /** Returns f(this) for an f with the given derivatives at x. */
  private Taylor chain(double f, double f1, double f2) {
    return new Taylor(f, f1 * d, f1 * dd + f2 * d * d);
  }

  Taylor inverse() {
    return chain(1 / x, -1 / (x * x), 2 / (x * x * x));
  }

  Taylor sqrt() {
    double root = Math.sqrt(x);
    return chain(root, 0.5 / root, -0.25 / (root * x));
  }

  Taylor sin() {
    return chain(StrictMath.sin(x), StrictMath.cos(x), -StrictMath.sin(x));
  }

  Taylor cos() {
    return chain(StrictMath.cos(x), -StrictMath.sin(x), -StrictMath.cos(x));
  }

  /** Returns the angle whose sine and cosine are in the ratio of s to c. */
  static Taylor angle(Taylor s, Taylor c) {
    Taylor square = s.times(s).plus(c.times(c));
    // φ' = (c s' − s c') / (s² + c²)
    Taylor rate =
        new Taylor(c.x * s.d - s.x * c.d, c.x * s.dd - s.x * c.dd, 0)
            .times(new Taylor(square.x, square.d, 0).inverse());
    return new Taylor(StrictMath.atan2(s.x, c.x), rate.x, rate.d);
  }
}
