package org.mechservice.mechml.expression;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleBinaryOperator;
import java.util.function.DoubleUnaryOperator;

/**
 * The functions expressions know; angles in rad. StrictMath throughout: the same bits on every
 * machine.
 */
public enum Function {
  SQRT("sqrt", StrictMath::sqrt),
  ABS("abs", StrictMath::abs),
  SIN("sin", StrictMath::sin),
  COS("cos", StrictMath::cos),
  TAN("tan", StrictMath::tan),
  ASIN("asin", StrictMath::asin),
  ACOS("acos", StrictMath::acos),
  ATAN("atan", StrictMath::atan),
  ATAN2("atan2", StrictMath::atan2),
  EXP("exp", StrictMath::exp),
  LOG("log", StrictMath::log),
  POW("pow", StrictMath::pow),
  MIN("min", StrictMath::min),
  MAX("max", StrictMath::max),
  SINH("sinh", StrictMath::sinh),
  COSH("cosh", StrictMath::cosh),
  TANH("tanh", StrictMath::tanh),
  SIGNUM("signum", StrictMath::signum),
  HYPOT("hypot", StrictMath::hypot),
  FLOOR("floor", StrictMath::floor),
  /** 0 below zero, 1 from zero on. */
  STEP("step", x -> x < 0 ? 0 : 1),
  /** 0 below zero, 1 above one, 3x² − 2x³ between. */
  SMOOTH_STEP("smoothStep", Function::smoothStep);

  private final String symbol;
  private final int arity;

  @SuppressWarnings("ImmutableEnumChecker") // a static method, no state
  private final DoubleBinaryOperator rule;

  Function(String symbol, DoubleUnaryOperator rule) {
    this.symbol = symbol;
    this.arity = 1;
    this.rule = (x, unused) -> rule.applyAsDouble(x);
  }

  Function(String symbol, DoubleBinaryOperator rule) {
    this.symbol = symbol;
    this.arity = 2;
    this.rule = rule;
  }

  private static double smoothStep(double x) {
    double s = StrictMath.max(0, StrictMath.min(1, x));
    return s * s * (3 - 2 * s);
  }

  /** Returns the function of a name, without {@code Math.} before it. */
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

  /** Returns how many arguments it takes, 1 or 2. */
  public int arity() {
    return arity;
  }

  /** Returns the value; not a number or infinite where the function is not defined. */
  public double at(double[] arguments) {
    return rule.applyAsDouble(arguments[0], arguments[arity - 1]);
  }
}
