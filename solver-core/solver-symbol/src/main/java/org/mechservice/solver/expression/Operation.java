package org.mechservice.solver.expression;

import org.mechservice.solver.symbol.Enclosure;

/** The arithmetic of a tape. */
enum Operation implements TapeStep {
  ADD {
    @Override
    public double value(double a, double b) {
      return a + b;
    }

    @Override
    public void bound(double aLow, double aHigh, double bLow, double bHigh, Enclosure out) {
      out.set(aLow + bLow, aHigh + bHigh);
      out.settle(Enclosure.ROUNDING);
    }
  },
  MULTIPLY {
    @Override
    public double value(double a, double b) {
      return a * b;
    }

    @Override
    public void bound(double aLow, double aHigh, double bLow, double bHigh, Enclosure out) {
      out.product(aLow, aHigh, bLow, bHigh);
      out.settle(Enclosure.ROUNDING);
    }
  },
  DIVIDE {
    @Override
    public double value(double a, double b) {
      return a / b;
    }

    @Override
    public void bound(double aLow, double aHigh, double bLow, double bHigh, Enclosure out) {
      out.quotient(aLow, aHigh, bLow, bHigh);
      out.settle(Enclosure.ROUNDING);
    }

    @Override
    public boolean isNarrow() {
      return true;
    }

    @Override
    public boolean isEven(double aLow, double aHigh, double bLow, double bHigh, double highest) {
      return Enclosure.changesLittle(bLow, bHigh);
    }
  },
  NEGATE {
    @Override
    public double value(double a, double b) {
      return -a;
    }

    @Override
    public void bound(double aLow, double aHigh, double bLow, double bHigh, Enclosure out) {
      out.set(-aHigh, -aLow);
    }
  },
  /** a², the compiled form of a ^ 2. */
  SQUARE {
    @Override
    public double value(double a, double b) {
      return a * a;
    }

    @Override
    public void bound(double aLow, double aHigh, double bLow, double bHigh, Enclosure out) {
      out.square(aLow, aHigh);
      out.settle(Enclosure.ROUNDING);
    }
  };

  @Override
  public boolean hasPieces() {
    return false;
  }

  @Override
  public double piece(double a, double b) {
    return 0;
  }

  @Override
  public double distance(double a, double b) {
    return Double.POSITIVE_INFINITY;
  }

  @Override
  public boolean isNarrow() {
    return false;
  }

  @Override
  public boolean isEven(double aLow, double aHigh, double bLow, double bHigh, double highest) {
    return true;
  }
}
