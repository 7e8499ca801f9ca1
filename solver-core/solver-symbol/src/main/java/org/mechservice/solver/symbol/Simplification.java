package org.mechservice.solver.symbol;

import static org.mechservice.solver.symbol.ScalarOperation.ADD;
import static org.mechservice.solver.symbol.ScalarOperation.COSINE;
import static org.mechservice.solver.symbol.ScalarOperation.DIVIDE;
import static org.mechservice.solver.symbol.ScalarOperation.MULTIPLY;
import static org.mechservice.solver.symbol.ScalarOperation.NEGATE;
import static org.mechservice.solver.symbol.ScalarOperation.SINE;
import static org.mechservice.solver.symbol.ScalarOperation.SQUARE_ROOT;
import static org.mechservice.solver.symbol.ScalarOperation.SUBTRACT;

import java.util.List;
import java.util.Optional;
import org.mechservice.solver.spatial.SinCos;

/**
 * Simplifies an operation before it becomes a node: constants are folded, 0 and 1 disappear, x − x
 * cancels, and signs move outwards until a sum or difference absorbs them.
 *
 * <p>Operations are not put into another order: c + (d + x) and c (d x) stay as they are, although
 * c and d are known, and so does (a − b) + b. A formula then gives the same bits whether its
 * numbers and its parts are known when code is written or are read when it runs.
 *
 * <p>Values are assumed to be finite: 0 · x is 0. Operations on constants without a finite result
 * are not folded, so that the run finds the fault at its origin and can name the joint or force.
 */
final class Simplification {
  /**
   * Largest number of inputs and constants in a formula whose sine is computed before everything
   * else.
   */
  private static final int LONGEST_ANGLE = 8;

  private Simplification() {}

  static Scalar sum(Scalar a, Scalar b) {
    Expressions expressions = a.expressions();
    if (a.isConstant() && b.isConstant()) {
      return folded(a.value() + b.value(), ADD, a, b);
    }
    if (a.isZero()) {
      return b;
    }
    if (b.isZero()) {
      return a;
    }
    if (b.is(NEGATE)) {
      return difference(a, negation(b));
    }
    if (a.is(NEGATE)) {
      return difference(b, negation(a));
    }
    if (b.isConstant()) {
      return sum(b, a);
    }
    if (a.isConstant()) {
      Scalar opposite = expressions.constant(-a.value());
      if (expressions.contains(SUBTRACT, opposite, b)) {
        return negation(expressions.binary(SUBTRACT, opposite, b));
      }
    }
    return commutative(ADD, a, b);
  }

  static Scalar difference(Scalar a, Scalar b) {
    Expressions expressions = a.expressions();
    if (a == b) {
      return expressions.zero();
    }
    if (a.isConstant() && b.isConstant()) {
      return folded(a.value() - b.value(), SUBTRACT, a, b);
    }
    if (b.isZero()) {
      return a;
    }
    if (a.isZero()) {
      return negation(b);
    }
    if (b.is(NEGATE)) {
      return sum(a, negation(b));
    }
    if (a.is(NEGATE)) {
      return negation(sum(negation(a), b));
    }
    if (a.isConstant()) {
      Scalar opposite = expressions.constant(-a.value());
      if (expressions.contains(ADD, opposite, b)) {
        return negation(expressions.binary(ADD, opposite, b));
      }
    }
    if (b.isConstant()) {
      return sum(expressions.constant(-b.value()), a);
    }
    if (expressions.contains(SUBTRACT, b, a)) {
      return negation(expressions.binary(SUBTRACT, b, a));
    }
    return expressions.binary(SUBTRACT, a, b);
  }

  static Scalar product(Scalar a, Scalar b) {
    Expressions expressions = a.expressions();
    if (a.isConstant() && b.isConstant()) {
      return folded(a.value() * b.value(), MULTIPLY, a, b);
    }
    if (a.isZero() || b.isZero()) {
      return expressions.zero();
    }
    if (isNegative(a) || isNegative(b)) {
      boolean odd = isNegative(a) != isNegative(b);
      Scalar magnitude = product(isNegative(a) ? negation(a) : a, isNegative(b) ? negation(b) : b);
      return odd ? negation(magnitude) : magnitude;
    }
    if (a.isConstant(1)) {
      return b;
    }
    if (b.isConstant(1)) {
      return a;
    }
    if (b.isConstant()) {
      return product(b, a);
    }
    if (a.isConstant()) {
      Scalar opposite = expressions.constant(-a.value());
      if (expressions.contains(MULTIPLY, opposite, b)) {
        return negation(expressions.binary(MULTIPLY, opposite, b));
      }
    }
    return commutative(MULTIPLY, a, b);
  }

  /** Returns a product that is 0 if a factor is, even if the other is not finite; it is steep. */
  static Scalar guardedProduct(Scalar a, Scalar b) {
    Scalar product = function(MathFunction.PRODUCT, List.of(a, b));
    boolean simpler = !product.is(ScalarOperation.FUNCTION);
    return simpler || product.function() != MathFunction.PRODUCT ? product : product.markedSteep();
  }

  static Scalar quotient(Scalar a, Scalar b) {
    Expressions expressions = a.expressions();
    if (a.isConstant() && b.isConstant()) {
      return folded(a.value() / b.value(), DIVIDE, a, b);
    }
    if (b.isZero()) {
      return expressions.binary(DIVIDE, a, b);
    }
    if (a == b) {
      return expressions.one();
    }
    if (a.isZero() || b.isConstant(1)) {
      return a;
    }
    if (isNegative(a)) {
      return negation(quotient(negation(a), b));
    }
    if (isNegative(b)) {
      return negation(quotient(a, negation(b)));
    }
    return expressions.binary(DIVIDE, a, b);
  }

  /**
   * Returns the result of an operation on two constants as a constant, or the operation itself if
   * the result is not finite.
   */
  private static Scalar folded(double value, ScalarOperation operation, Scalar a, Scalar b) {
    return Double.isFinite(value)
        ? a.expressions().constant(value)
        : a.expressions().binary(operation, a, b);
  }

  static Scalar negation(Scalar a) {
    if (a.isConstant()) {
      return a.expressions().constant(-a.value());
    }
    return a.is(NEGATE) ? a.first() : a.expressions().unary(NEGATE, a);
  }

  static Scalar squareRoot(Scalar a) {
    return a.isConstant() && a.value() >= 0
        ? a.expressions().constant(Math.sqrt(a.value()))
        : a.expressions().unary(SQUARE_ROOT, a);
  }

  /**
   * Returns a function call, or the formula that it is; a call with constant arguments is folded if
   * its value is finite, and a choice is decided if its bounds are constants, or if a positive
   * number would have to be at most zero.
   */
  static Scalar function(MathFunction function, List<Scalar> arguments) {
    double[] x = new double[arguments.size()];
    boolean known = true;
    for (int i = 0; i < x.length; i++) {
      known &= arguments.get(i).isConstant();
      x[i] = arguments.get(i).value();
    }
    if (known && Double.isFinite(function.value(x))) {
      return arguments.get(0).expressions().constant(function.value(x));
    }
    Optional<Scalar> formula = function.formula(arguments);
    if (formula.isPresent()) {
      return formula.get();
    }
    if (function == MathFunction.CHOOSE) {
      boolean decided = arguments.get(0).isConstant() && arguments.get(1).isConstant();
      if (arguments.get(0).isPositive() && arguments.get(1).isZero()) {
        return arguments.get(3);
      }
      if (decided || arguments.get(2) == arguments.get(3)) {
        return arguments.get(x[0] <= x[1] ? 2 : 3);
      }
    }
    if (function == MathFunction.PRODUCT
        && (arguments.get(0).isConstant() || arguments.get(1).isConstant())) {
      return product(arguments.get(0), arguments.get(1));
    }
    return arguments.get(0).expressions().call(function, arguments);
  }

  static Scalar sine(Scalar angle) {
    if (angle.isConstant()) {
      return angle.expressions().constant(SinCos.sine(angle.value()));
    }
    if (angle.is(NEGATE)) {
      return negation(sine(angle.first()));
    }
    return isSimple(angle)
        ? angle.expressions().unary(SINE, angle)
        : angle.expressions().call(MathFunction.SIN, List.of(angle));
  }

  static Scalar cosine(Scalar angle) {
    if (angle.isConstant()) {
      return angle.expressions().constant(SinCos.cosine(angle.value()));
    }
    if (angle.is(NEGATE)) {
      return cosine(angle.first());
    }
    return isSimple(angle)
        ? angle.expressions().unary(COSINE, angle)
        : angle.expressions().call(MathFunction.COS, List.of(angle));
  }

  /**
   * Returns whether an angle is a short formula of inputs; sines of such angles are computed first.
   */
  private static boolean isSimple(Scalar angle) {
    return length(angle) <= LONGEST_ANGLE;
  }

  /**
   * Returns the number of inputs and constants in a formula; a large number if it calls a function.
   */
  private static int length(Scalar node) {
    return switch (node.operation()) {
      case CONSTANT, INPUT -> 1;
      case SINE, COSINE, SQUARE_ROOT, FUNCTION -> LONGEST_ANGLE + 1;
      default -> {
        int sum = 0;
        for (Scalar operand : node.operands()) {
          sum += sum <= LONGEST_ANGLE ? length(operand) : 0;
        }
        yield sum;
      }
    };
  }

  private static boolean isNegative(Scalar a) {
    return a.is(NEGATE) || a.isConstant(-1);
  }

  /**
   * Returns an operation with ordered operands, so that x·y and y·x are one node: constants come
   * first, otherwise the older operand.
   */
  private static Scalar commutative(ScalarOperation operation, Scalar a, Scalar b) {
    boolean swap = b.isConstant() ? !a.isConstant() : !a.isConstant() && b.id() < a.id();
    return swap ? a.expressions().binary(operation, b, a) : a.expressions().binary(operation, a, b);
  }
}
