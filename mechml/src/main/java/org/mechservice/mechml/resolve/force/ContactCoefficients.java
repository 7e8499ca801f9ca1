package org.mechservice.mechml.resolve.force;

import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.call;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.isZero;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.larger;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.minus;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.power;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.product;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.quotient;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.root;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.smaller;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.square;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.sum;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.times;

import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.symbol.MathFunction;

/**
 * Coefficients of a contact: the push at the depth d, which is the law of {@code
 * solver.force.law.PushLaw}, N = max(0, E + c d′ pos′(d) + χ d′ E) with E = k pos(d)ⁿ, and
 * friction.
 *
 * @param stiffness k, N/mⁿ
 * @param damping c, N·s/m
 * @param dissipation χ, s/m
 * @param exponent n ≥ 1
 * @param smoothing ε of pos(d) = (d + √(d² + ε²)) / 2, m
 * @param friction coefficient μ; zero for none
 * @param slidingSpeed v₀ of friction without sticking, m/s
 * @param stickLength δ of friction that sticks, m; zero for friction without sticking
 * @param stickTime τ, s
 */
record ContactCoefficients(
    Expression stiffness,
    Expression damping,
    Expression dissipation,
    double exponent,
    Expression smoothing,
    Expression friction,
    Expression slidingSpeed,
    Expression stickLength,
    Expression stickTime) {
  /** Keeps the share of a push defined where it is zero, N. */
  private static final Expression TINY = Expression.of(1e-300);

  boolean rubs() {
    return !isZero(friction);
  }

  boolean sticks() {
    return rubs() && !isZero(stickLength);
  }

  /** The smooth positive part of a depth. */
  final class Positive {
    private final Expression depth;
    private final Expression root;

    /** pos(d), without cancellation: max(d, 0) + pos(−|d|), pos(−|d|) = ε² / (2 (|d| + root)). */
    final Expression value;

    /** pos′(d) = pos(d) / root. */
    final Expression slope;

    Positive(Expression depth) {
      this.depth = depth;
      Expression above = larger(Expression.ZERO, depth);
      if (isZero(smoothing)) {
        root = Expression.ZERO;
        value = above;
        slope = call(MathFunction.STEP, depth);
        return;
      }
      root = root(sum(square(depth), square(smoothing)));
      Expression size = call(MathFunction.ABS, depth);
      value = sum(above, quotient(times(0.5, square(smoothing)), sum(size, root)));
      slope = quotient(value, root);
    }

    /** Returns the elastic part of the push, N. */
    Expression elastic() {
      return product(stiffness, power(value, exponent));
    }

    /** Returns the push, never negative, N. */
    Expression push(Expression rate) {
      Expression elastic = elastic();
      Expression damper =
          sum(product(product(damping, rate), slope), product(product(dissipation, rate), elastic));
      return isZero(damper) ? elastic : bounded(elastic, sum(elastic, damper));
    }

    private Expression bounded(Expression elastic, Expression sum) {
      if (isZero(smoothing)) {
        return larger(Expression.ZERO, sum);
      }
      // beyond ±1 of the share r the rounded part is constant: its slope there is 0
      Expression half = times(0.5, elastic);
      Expression share = quotient(sum, sum(half, TINY));
      Expression r = larger(Expression.of(-1), smaller(Expression.of(1), share));
      Expression above = sum(r, Expression.of(1));
      Expression cube = product(square(above), above);
      Expression factor = Expression.of(7);
      for (int coefficient : new int[] {-42, 102, -122, 63}) {
        factor = sum(product(r, factor), Expression.of(coefficient));
      }
      Expression rounded = product(half, times(1.0 / 512, product(square(cube), factor)));
      return sum(rounded, larger(Expression.ZERO, minus(sum, half)));
    }

    /** Returns k ∫ posⁿ, J: from d = 0 for n = 1, else from d = −∞. */
    Expression potential() {
      Expression quarter = times(0.25, square(smoothing));
      if (exponent == 1) {
        Expression half = times(0.5, square(value));
        Expression log =
            isZero(smoothing)
                ? Expression.ZERO
                : call(MathFunction.LOG, quotient(times(2, value), smoothing));
        return product(stiffness, sum(half, product(quarter, sum(log, Expression.of(-0.5)))));
      }
      Expression rest =
          isZero(quarter)
              ? Expression.ZERO
              : product(times(1 / (exponent - 1), quarter), power(value, exponent - 1));
      return product(stiffness, sum(times(1 / (exponent + 1), power(value, exponent + 1)), rest));
    }

    /** Returns how far the bodies touch: 1 from first touch on, 0 when they are ε apart. */
    Expression touch() {
      return isZero(smoothing)
          ? slope
          : call(MathFunction.SMOOTH_STEP, sum(Expression.of(1), quotient(depth, smoothing)));
    }
  }
}
