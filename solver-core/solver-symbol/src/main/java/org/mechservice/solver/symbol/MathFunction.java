package org.mechservice.solver.symbol;

import org.mechservice.solver.spatial.CubicCurve;
import org.mechservice.solver.spatial.NumberTable;
import org.mechservice.solver.spatial.Piecewise;
import org.mechservice.solver.spatial.Powers;

/**
 * Static methods that generated code calls. They are those of StrictMath wherever Math may differ
 * between machines, so the results have the same bits everywhere. The functions that a user can
 * write are another table, that of expressions, which become functions of this one.
 */
public enum MathFunction {
  ABS("java/lang/Math", "abs", 1),
  /** For angles that are too long for the kernel that computes sine and cosine together. */
  SIN("java/lang/StrictMath", "sin", 1),
  COS("java/lang/StrictMath", "cos", 1),
  ASIN("java/lang/StrictMath", "asin", 1),
  ACOS("java/lang/StrictMath", "acos", 1),
  ATAN("java/lang/StrictMath", "atan", 1),
  ATAN2("java/lang/StrictMath", "atan2", 2),
  EXP("java/lang/StrictMath", "exp", 1),
  LOG("java/lang/StrictMath", "log", 1),
  SINH("java/lang/StrictMath", "sinh", 1),
  COSH("java/lang/StrictMath", "cosh", 1),
  TANH("java/lang/StrictMath", "tanh", 1),
  HYPOT("java/lang/StrictMath", "hypot", 2),
  MIN("java/lang/Math", "min", 2),
  MAX("java/lang/Math", "max", 2),
  SIGNUM("java/lang/Math", "signum", 1),
  FLOOR("java/lang/Math", "floor", 1),
  POWER("org/mechservice/solver/spatial/Powers", "power", 2),
  /** {@code choose(a, b, x, y)}: x where a ≤ b, else y. */
  CHOOSE("org/mechservice/solver/spatial/Piecewise", "choose", 4),
  /** {@code product(a, b)}: a b, but 0 if one factor is 0, even if the other is infinite or NaN. */
  PRODUCT("org/mechservice/solver/spatial/Piecewise", "product", 2),
  /** {@code pick(a, b, x, y)}: x where a ≤ b, else y; found by a search, so without derivatives. */
  PICK("org/mechservice/solver/spatial/Piecewise", "pick", 4),
  /** {@code held(x)}: x, without a derivative. */
  HELD("org/mechservice/solver/spatial/Piecewise", "held", 1),
  /**
   * {@code interval(row, x)}: how many numbers of an ascending {@link NumberRow} are not above x, 0
   * if x is NaN.
   */
  INTERVAL("org/mechservice/solver/spatial/NumberTable", "interval", 1),
  /** {@code element(row, k)}: number k of a {@link NumberRow}, counted from 0. */
  ELEMENT("org/mechservice/solver/spatial/NumberTable", "element", 1),
  /**
   * {@code closest(row, x, z)}: abscissa of the point closest to (x, z) of the curve that a {@link
   * NumberRow} holds; found by a search, so without derivatives.
   */
  CLOSEST("org/mechservice/solver/spatial/CubicCurve", "closest", 2);

  private final String owner;
  private final String method;
  private final int arity;

  MathFunction(String owner, String method, int arity) {
    this.owner = owner;
    this.method = method;
    this.arity = arity;
  }

  /** Returns the internal name of the class that has it. */
  public String owner() {
    return owner;
  }

  /** Returns the name of its static method. */
  public String method() {
    return method;
  }

  /** Returns how many numbers it takes, without those of a row. */
  public int arity() {
    return arity;
  }

  /**
   * Returns whether it reads a row of numbers that is fixed when code is generated. Its method
   * takes the array that holds the row, the place and the number of its elements, and then the
   * argument.
   */
  public boolean readsRow() {
    return this == INTERVAL || this == ELEMENT || this == CLOSEST;
  }

  /** Returns its value if it reads a row; {@code x} holds the other arguments. */
  double value(double[] row, double[] x) {
    return switch (this) {
      case INTERVAL -> NumberTable.interval(row, 0, row.length, x[0]);
      case ELEMENT -> NumberTable.element(row, 0, row.length, x[0]);
      case CLOSEST -> CubicCurve.closest(row, 0, row.length, x[0], x[1]);
      default -> throw new IllegalStateException(this + " reads no row");
    };
  }

  /** Returns its value; {@code x} holds the arguments. */
  double value(double[] x) {
    return switch (this) {
      case ABS -> Math.abs(x[0]);
      case SIN -> StrictMath.sin(x[0]);
      case COS -> StrictMath.cos(x[0]);
      case ASIN -> StrictMath.asin(x[0]);
      case ACOS -> StrictMath.acos(x[0]);
      case ATAN -> StrictMath.atan(x[0]);
      case ATAN2 -> StrictMath.atan2(x[0], x[1]);
      case EXP -> StrictMath.exp(x[0]);
      case LOG -> StrictMath.log(x[0]);
      case SINH -> StrictMath.sinh(x[0]);
      case COSH -> StrictMath.cosh(x[0]);
      case TANH -> StrictMath.tanh(x[0]);
      case HYPOT -> StrictMath.hypot(x[0], x[1]);
      case MIN -> Math.min(x[0], x[1]);
      case MAX -> Math.max(x[0], x[1]);
      case SIGNUM -> Math.signum(x[0]);
      case FLOOR -> Math.floor(x[0]);
      case POWER -> Powers.power(x[0], x[1]);
      case CHOOSE -> Piecewise.choose(x[0], x[1], x[2], x[3]);
      case PRODUCT -> Piecewise.product(x[0], x[1]);
      case PICK -> Piecewise.pick(x[0], x[1], x[2], x[3]);
      case HELD -> Piecewise.held(x[0]);
      case INTERVAL, ELEMENT, CLOSEST -> throw new IllegalStateException(this + " reads a row");
    };
  }
}
