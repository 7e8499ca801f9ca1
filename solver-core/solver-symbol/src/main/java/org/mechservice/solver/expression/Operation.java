package org.mechservice.solver.expression;

import org.mechservice.solver.symbol.Enclosure;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.WatchedStep;

/** Bounds of the arithmetic of a tape. */
enum Operation implements WatchedStep {
  ADD {
    @Override
    public void bound(double aLow, double aHigh, double bLow, double bHigh, Enclosure out) {
      out.ofSum(aLow, aHigh, bLow, bHigh);
    }
  },
  SUBTRACT {
    @Override
    public void bound(double aLow, double aHigh, double bLow, double bHigh, Enclosure out) {
      out.ofSum(aLow, aHigh, -bHigh, -bLow);
    }
  },
  MULTIPLY {
    @Override
    public void bound(double aLow, double aHigh, double bLow, double bHigh, Enclosure out) {
      out.ofProduct(aLow, aHigh, bLow, bHigh);
    }
  },
  DIVIDE {
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
    public void bound(double aLow, double aHigh, double bLow, double bHigh, Enclosure out) {
      out.set(-aHigh, -aLow);
    }
  },
  /** a², of which both factors are one. */
  SQUARE {
    @Override
    public void bound(double aLow, double aHigh, double bLow, double bHigh, Enclosure out) {
      out.square(aLow, aHigh);
      out.settle(Enclosure.ROUNDING);
    }
  };

  /** Returns the operation of a node that is no call of a function. */
  static Operation of(Scalar node) {
    return switch (node.operation()) {
      case ADD -> ADD;
      case SUBTRACT -> SUBTRACT;
      case MULTIPLY -> node.first() == node.second() ? SQUARE : MULTIPLY;
      case DIVIDE -> DIVIDE;
      case NEGATE -> NEGATE;
      default -> throw new IllegalArgumentException(node + " is no arithmetic");
    };
  }

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
