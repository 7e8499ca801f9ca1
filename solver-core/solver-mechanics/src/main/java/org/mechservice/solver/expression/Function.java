package org.mechservice.solver.expression;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** The functions of MECHML §2; angles in rad. */
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
  /** The lesser of two; where they are equal, slope of the first. */
  MIN("min", 2),
  /** The greater of two; where they are equal, slope of the first. */
  MAX("max", 2),
  SINH("sinh", 1),
  COSH("cosh", 1),
  TANH("tanh", 1),
  /** −1, 0 or 1; its slope counts as 0 everywhere. */
  SIGNUM("signum", 1),
  /** {@code hypot(x, y)} = √(x² + y²); at the origin its slope counts as 0. */
  HYPOT("hypot", 2),
  /** The greatest whole number not above; its slope counts as 0 everywhere. */
  FLOOR("floor", 1),
  /** 0 below zero, 1 from zero on; its slope counts as 0 everywhere. */
  STEP("step", 1),
  /** 0 below zero, 1 above one, 3x² − 2x³ between. */
  SMOOTH_STEP("smoothStep", 1);

  private final String symbol;
  private final int arity;

  Function(String symbol, int arity) {
    this.symbol = symbol;
    this.arity = arity;
  }

  /** Returns the function of a name. */
  public static Optional<Function> named(String symbol) {
    return Arrays.stream(values()).filter(f -> f.symbol.equals(symbol)).findFirst();
  }

  /** Returns the names of all functions, {@code pow} excepted, which is a node of its own. */
  public static List<String> symbols() {
    return Arrays.stream(values()).map(Function::symbol).toList();
  }

  /** Returns the name in expressions. */
  public String symbol() {
    return symbol;
  }

  /** Returns how many arguments it takes, 1 or 2. */
  public int arity() {
    return arity;
  }
}
