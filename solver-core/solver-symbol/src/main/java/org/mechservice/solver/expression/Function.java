package org.mechservice.solver.expression;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * The functions of docs/mechml.md#values; angles in rad. This is the only table of them: the reader
 * takes names, arities and values of constant calls from it. Every switch over them is complete, so
 * the compiler reports each place that a new function needs.
 *
 * <p>{@link #at} evaluates constants by StrictMath. A run evaluates by {@link Operation} and by
 * generated code, whose sine, cosine and power come from faster kernels and may differ in the last
 * bit.
 */
public enum Function {
  SQRT("sqrt", 1),
  ABS("abs", 1),
  SIN("sin", 1),
  COS("cos", 1),
  TAN("tan", 1),
  ASIN("asin", 1),
  ACOS("acos", 1),
  ATAN("atan", 1),
  /**
   * {@code atan2(y, x)}: the angle of the point (x, y), −π … π; at the origin its slope counts as
   * 0.
   */
  ATAN2("atan2", 2),
  EXP("exp", 1),
  /** The natural logarithm. */
  LOG("log", 1),
  /** {@code pow(a, b)} = aᵇ; in formulas it is {@link Expression.Power}. */
  POW("pow", 2),
  /** The lesser of two; the derivative of the first if they are equal. */
  MIN("min", 2),
  /** The greater of two; the derivative of the first if they are equal. */
  MAX("max", 2),
  SINH("sinh", 1),
  COSH("cosh", 1),
  TANH("tanh", 1),
  /** −1, 0 or 1; its derivative counts as 0 everywhere. */
  SIGNUM("signum", 1),
  /** {@code hypot(x, y)} = √(x² + y²); at the origin its slope counts as 0. */
  HYPOT("hypot", 2),
  /** The greatest integer not above the argument; its derivative counts as 0 everywhere. */
  FLOOR("floor", 1),
  /** 0 below zero, 1 from zero on; its derivative counts as 0 everywhere. */
  STEP("step", 1),
  /** 0 below zero, 1 above one, 3x² − 2x³ between. */
  SMOOTH_STEP("smoothStep", 1);

  private final String symbol;
  private final int arity;

  Function(String symbol, int arity) {
    this.symbol = symbol;
    this.arity = arity;
  }

  /** Returns the function of a name, which has no prefix {@code Math.}. */
  public static Optional<Function> named(String symbol) {
    return Arrays.stream(values()).filter(f -> f.symbol.equals(symbol)).findFirst();
  }

  /** Returns the names of all functions. */
  public static List<String> symbols() {
    return Arrays.stream(values()).map(Function::symbol).toList();
  }

  /** Returns the name in expressions. */
  public String symbol() {
    return symbol;
  }

  /** Returns the number of arguments, 1 or 2. */
  public int arity() {
    return arity;
  }

  /**
   * Returns the value for constant arguments.
   *
   * @param x arguments, as many as the arity; not modified
   * @return NaN or infinite if the function is not defined
   */
  public double at(double[] x) {
    return switch (this) {
      case SQRT -> StrictMath.sqrt(x[0]);
      case ABS -> StrictMath.abs(x[0]);
      case SIN -> StrictMath.sin(x[0]);
      case COS -> StrictMath.cos(x[0]);
      case TAN -> StrictMath.tan(x[0]);
      case ASIN -> StrictMath.asin(x[0]);
      case ACOS -> StrictMath.acos(x[0]);
      case ATAN -> StrictMath.atan(x[0]);
      case ATAN2 -> StrictMath.atan2(x[0], x[1]);
      case EXP -> StrictMath.exp(x[0]);
      case LOG -> StrictMath.log(x[0]);
      case POW -> StrictMath.pow(x[0], x[1]);
      case MIN -> StrictMath.min(x[0], x[1]);
      case MAX -> StrictMath.max(x[0], x[1]);
      case SINH -> StrictMath.sinh(x[0]);
      case COSH -> StrictMath.cosh(x[0]);
      case TANH -> StrictMath.tanh(x[0]);
      case SIGNUM -> StrictMath.signum(x[0]);
      case HYPOT -> StrictMath.hypot(x[0], x[1]);
      case FLOOR -> StrictMath.floor(x[0]);
      case STEP -> x[0] < 0 ? 0 : 1;
      case SMOOTH_STEP -> smoothStep(x[0]);
    };
  }

  private static double smoothStep(double x) {
    double s = StrictMath.max(0, StrictMath.min(1, x));
    return s * s * (3 - 2 * s);
  }
}
