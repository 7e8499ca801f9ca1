package org.mechservice.mechml.resolve.joint;

import java.util.List;
import java.util.Optional;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.Negation;
import org.mechservice.solver.expression.Expression.Product;
import org.mechservice.solver.expression.Expression.Quotient;
import org.mechservice.solver.expression.Expression.Sum;
import org.mechservice.solver.expression.Expression.TableValue;
import org.mechservice.solver.symbol.MathFunction;

/**
 * Rotations over time as paths of unit quaternions e0, e1, e2, e3: from three angles, or from four
 * numbers that are divided by their norm. The derivatives of the path then have no part along it.
 */
final class TurningPath {
  private static final Expression HALF = Expression.of(0.5);

  private TurningPath() {}

  /**
   * Returns the rotation by three turns, each about an axis of the frame that the turns before it
   * have turned: R = R₁(φ₁) R₂(φ₂) R₃(φ₃). With e₀ = cos φ/2 and eᵢ = sin φ/2 for each turn the
   * path is the product of three unit quaternions, hence a unit quaternion, without a singularity.
   *
   * @param axes letters x, y, z in the order of the turns
   * @param angles in rad
   */
  static List<Expression> ofAngles(String axes, List<Expression> angles) {
    List<Expression> path = turn(axes.charAt(0), angles.get(0));
    for (int i = 1; i < 3; i++) {
      path = product(path, turn(axes.charAt(i), angles.get(i)));
    }
    return path;
  }

  private static List<Expression> turn(char axis, Expression angle) {
    Expression half = new Product(HALF, angle);
    Expression sine = Expression.call(MathFunction.SIN, List.of(half));
    return List.of(
        Expression.call(MathFunction.COS, List.of(half)),
        axis == 'x' ? sine : Expression.ZERO,
        axis == 'y' ? sine : Expression.ZERO,
        axis == 'z' ? sine : Expression.ZERO);
  }

  /** Returns the product of two quaternions, without the terms that are zero. */
  private static List<Expression> product(List<Expression> a, List<Expression> b) {
    return List.of(
        sum(times(a, 0, b, 0), minus(a, 1, b, 1), minus(a, 2, b, 2), minus(a, 3, b, 3)),
        sum(times(a, 0, b, 1), times(a, 1, b, 0), times(a, 2, b, 3), minus(a, 3, b, 2)),
        sum(times(a, 0, b, 2), times(a, 2, b, 0), times(a, 3, b, 1), minus(a, 1, b, 3)),
        sum(times(a, 0, b, 3), times(a, 3, b, 0), times(a, 1, b, 2), minus(a, 2, b, 1)));
  }

  private static Expression times(List<Expression> a, int i, List<Expression> b, int j) {
    boolean zero = a.get(i) == Expression.ZERO || b.get(j) == Expression.ZERO;
    return zero ? Expression.ZERO : new Product(a.get(i), b.get(j));
  }

  private static Expression minus(List<Expression> a, int i, List<Expression> b, int j) {
    Expression product = times(a, i, b, j);
    return product == Expression.ZERO ? product : new Negation(product);
  }

  private static Expression sum(Expression... terms) {
    Expression sum = Expression.ZERO;
    for (Expression term : terms) {
      if (term != Expression.ZERO) {
        sum = sum == Expression.ZERO ? term : new Sum(sum, term);
      }
    }
    return sum;
  }

  /** Returns four numbers over their norm; not finite where all are zero. */
  static List<Expression> normalised(List<Expression> numbers) {
    Expression square = sum(numbers.stream().map(n -> new Product(n, n)).toArray(Product[]::new));
    Expression norm = Expression.call(MathFunction.SQRT, List.of(square));
    return numbers.stream().<Expression>map(n -> new Quotient(n, norm)).toList();
  }

  /**
   * Returns the norm of four numbers that a path {@linkplain #normalised divides} by it, if some of
   * them are tables; empty if there are none, and for another motion.
   *
   * @param motion coordinates of a joint
   */
  static Optional<Expression> normOfTables(List<Expression> motion) {
    return Optional.of(motion)
        .filter(coordinates -> coordinates.size() >= 4)
        .map(coordinates -> coordinates.get(0))
        .filter(Quotient.class::isInstance)
        .map(first -> ((Quotient) first).divisor())
        .filter(TurningPath::hasTable);
  }

  private static boolean hasTable(Expression part) {
    return part instanceof TableValue
        || Expression.operands(part).stream().anyMatch(TurningPath::hasTable);
  }
}
