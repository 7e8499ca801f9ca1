package org.mechservice.solver.symbol;

/** Where a function of one or two arguments is made of pieces that meet in a corner or a jump. */
public enum Corners {
  /** Nowhere. */
  NONE,
  /** Its argument changes its sign; 0 belongs to the positive side. */
  SIDES,
  /** Its argument is 0, which is a piece of its own. */
  ZERO,
  /** Its argument passes 0 or 1; the function is constant below 0 and above 1. */
  BORDERS,
  /** Its argument is a whole number. */
  WHOLE_NUMBERS,
  /** Its two arguments are equal. */
  EQUAL;

  /** Returns the arguments where it is so, if they are few, else nothing. */
  public double[] places() {
    return switch (this) {
      case SIDES, ZERO -> new double[] {0};
      case BORDERS -> new double[] {0, 1};
      case NONE, WHOLE_NUMBERS, EQUAL -> new double[0];
    };
  }

  /** Returns the number of the piece that the function takes; neighbours have neighbouring ones. */
  public double piece(double a, double b) {
    return switch (this) {
      case NONE -> 0;
      case SIDES -> a < 0 ? 0 : 1;
      case ZERO -> Math.signum(a);
      case BORDERS -> a < 0 ? 0 : a <= 1 ? 1 : 2;
      case WHOLE_NUMBERS -> Math.floor(a);
      case EQUAL -> a < b ? 0 : 1;
    };
  }

  /** Returns how far the arguments are from where the piece ends. */
  public double distance(double a, double b) {
    return switch (this) {
      case NONE -> Double.POSITIVE_INFINITY;
      case SIDES, ZERO -> Math.abs(a);
      case BORDERS -> Math.min(Math.abs(a), Math.abs(a - 1));
      case WHOLE_NUMBERS -> Math.abs(a - Math.rint(a));
      case EQUAL -> Math.abs(a - b);
    };
  }
}
