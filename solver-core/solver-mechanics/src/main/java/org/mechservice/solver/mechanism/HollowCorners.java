package org.mechservice.solver.mechanism;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.Call;
import org.mechservice.solver.expression.Expression.Constant;
import org.mechservice.solver.expression.Expression.Negation;
import org.mechservice.solver.expression.Expression.Product;
import org.mechservice.solver.expression.Expression.Quotient;
import org.mechservice.solver.expression.Expression.Sum;
import org.mechservice.solver.symbol.MathFunction;

/**
 * The corners of a curve that a sphere above it can touch on both sides at once: those of {@code
 * max} and {@code abs} if the curve rises with them, and those of {@code min} if it falls.
 */
final class HollowCorners {
  private static final int UNKNOWN = 0;

  private final List<Expression> found = new ArrayList<>();
  private final IdentityHashMap<Expression, Integer> signs = new IdentityHashMap<>();

  private HollowCorners() {}

  /** Returns, for each corner, what has one sign on one side of it and another on the other. */
  static List<Expression> of(Expression curve) {
    HollowCorners corners = new HollowCorners();
    corners.find(curve, 1);
    return corners.found;
  }

  /**
   * Finds the corners in a part of the curve.
   *
   * @param sign of the derivative of the curve by the part, or {@link #UNKNOWN}
   */
  private void find(Expression part, int sign) {
    if (signs.putIfAbsent(part, sign) != null) {
      return;
    }
    if (part instanceof Call call && isHollow(call.function(), sign)) {
      List<Expression> sides = call.arguments();
      found.add(
          sides.size() == 1 ? sides.get(0) : new Sum(sides.get(0), new Negation(sides.get(1))));
    }
    List<Expression> operands = Expression.operands(part);
    for (int i = 0; i < operands.size(); i++) {
      find(operands.get(i), sign * signOf(part, operands, i));
    }
  }

  private static boolean isHollow(MathFunction function, int sign) {
    return switch (function) {
      case MAX, ABS -> sign >= 0;
      case MIN -> sign <= 0;
      default -> false;
    };
  }

  /** Returns the sign of the derivative of a part by one of its operands, as far as it is known. */
  private static int signOf(Expression part, List<Expression> operands, int operand) {
    if (part instanceof Sum
        || (part instanceof Call call
            && (call.function() == MathFunction.MAX || call.function() == MathFunction.MIN))) {
      return 1;
    } else if (part instanceof Negation) {
      return -1;
    } else if (part instanceof Product || (part instanceof Quotient && operand == 0)) {
      return operands.get(1 - operand) instanceof Constant factor
          ? (int) Math.signum(factor.value())
          : UNKNOWN;
    }
    return UNKNOWN;
  }
}
