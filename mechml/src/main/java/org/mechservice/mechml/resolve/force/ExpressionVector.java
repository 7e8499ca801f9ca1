package org.mechservice.mechml.resolve.force;

import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.minus;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.product;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.sum;

import java.util.List;
import org.mechservice.solver.expression.Expression;

/** A vector of three expressions. */
record ExpressionVector(Expression x, Expression y, Expression z) {
  static final ExpressionVector ZERO =
      new ExpressionVector(Expression.ZERO, Expression.ZERO, Expression.ZERO);
  static final ExpressionVector Z =
      new ExpressionVector(Expression.ZERO, Expression.ZERO, Expression.of(1));

  static ExpressionVector of(List<Expression> components) {
    return new ExpressionVector(components.get(0), components.get(1), components.get(2));
  }

  List<Expression> components() {
    return List.of(x, y, z);
  }

  ExpressionVector plus(ExpressionVector b) {
    return new ExpressionVector(sum(x, b.x), sum(y, b.y), sum(z, b.z));
  }

  ExpressionVector less(ExpressionVector b) {
    return new ExpressionVector(minus(x, b.x), minus(y, b.y), minus(z, b.z));
  }

  ExpressionVector times(Expression factor) {
    return new ExpressionVector(product(factor, x), product(factor, y), product(factor, z));
  }

  Expression dot(ExpressionVector b) {
    return sum(sum(product(x, b.x), product(y, b.y)), product(z, b.z));
  }

  ExpressionVector cross(ExpressionVector b) {
    return new ExpressionVector(
        minus(product(y, b.z), product(z, b.y)),
        minus(product(z, b.x), product(x, b.z)),
        minus(product(x, b.y), product(y, b.x)));
  }

  /** Returns the part normal to a unit vector. */
  ExpressionVector normalTo(ExpressionVector n) {
    return less(n.times(dot(n)));
  }
}
