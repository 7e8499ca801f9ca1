package org.mechservice.solver.expression;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import org.mechservice.solver.symbol.Differentiation;
import org.mechservice.solver.symbol.Scalar;

/** The rate of a formula, as a formula of its leaves and of their rates. */
public final class FormulaRate {
  private FormulaRate() {}

  /**
   * Returns the rate of a formula.
   *
   * @param formula without tables and maps
   * @param rateOf returns the rate of a leaf; 0 if it does not change
   */
  public static Expression of(Expression formula, UnaryOperator<Expression> rateOf) {
    FormulaPrograms scalars = new FormulaPrograms(List.of(formula));
    Scalar value = scalars.results().get(0);
    List<Expression> leaves = new ArrayList<>();
    Map<Scalar, Scalar> rates = new HashMap<>();
    for (Expression leaf : scalars.leaves()) {
      Scalar input = scalars.leaf(leaf);
      leaves.add(leaf);
      leaves.add(rateOf.apply(leaf));
      leaves.add(Expression.ZERO);
      leaves.add(Expression.ZERO);
      rates.put(input, value.expressions().input(input.index() + FormulaPrograms.RATE));
    }
    Scalar rate = new Differentiation(value.expressions(), rates).of(value);
    return new ScalarFormulas(leaves).of(rate);
  }
}
