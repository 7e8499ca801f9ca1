package org.mechservice.mechml.resolve.force;

import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.call;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.isZero;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.quotient;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.sum;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.ScalarFormulas;
import org.mechservice.solver.force.law.PushLaw;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.Scalar;

/**
 * Coefficients of a contact: the push at the depth d, which is a {@link PushLaw}, and friction.
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
  boolean rubs() {
    return !isZero(friction);
  }

  boolean sticks() {
    return rubs() && !isZero(stickLength);
  }

  /** The push at a place of contact. */
  final class Push {
    private final Expression depth;
    private final Expressions e = new Expressions();
    private final List<Expression> inputs = new ArrayList<>();
    private final PushLaw law;
    private final Scalar x;
    private final Scalar rate;
    private final ScalarFormulas formulas;

    /**
     * @param depth d, m
     * @param depthRate d′, m/s
     */
    Push(Expression depth, Expression depthRate) {
      this.depth = depth;
      x = scalar(depth);
      rate = scalar(depthRate);
      law =
          new PushLaw(
              scalar(stiffness),
              e.constant(exponent),
              scalar(damping),
              scalar(dissipation),
              scalar(smoothing));
      formulas = new ScalarFormulas(inputs);
    }

    private Scalar scalar(Expression value) {
      if (value instanceof Expression.Constant constant) {
        return e.constant(constant.value());
      }
      inputs.add(value);
      return e.input(inputs.size() - 1);
    }

    /** Returns the elastic part of the push, N. */
    Expression elastic() {
      return formulas.of(law.elastic(x));
    }

    /** Returns the push, never negative, N. */
    Expression force() {
      return formulas.of(law.force(x, rate));
    }

    /** Returns the potential energy, J. */
    Expression potential() {
      return formulas.of(law.potential(x));
    }

    /** Returns how far the bodies touch: 1 from first touch on, 0 when they are ε apart. */
    Expression touch() {
      return isZero(smoothing)
          ? call(MathFunction.STEP, depth)
          : call(MathFunction.SMOOTH_STEP, sum(Expression.of(1), quotient(depth, smoothing)));
    }
  }
}
