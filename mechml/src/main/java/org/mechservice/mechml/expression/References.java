package org.mechservice.mechml.expression;

import java.util.ArrayList;
import java.util.List;

/** The names an expression uses. */
public final class References {
  private final List<ParsedExpression.Reference> found = new ArrayList<>();

  private References() {}

  /** Returns the references in an expression, from left to right. */
  public static List<ParsedExpression.Reference> in(ParsedExpression expression) {
    References references = new References();
    references.collect(expression);
    return references.found;
  }

  private void collect(ParsedExpression expression) {
    if (expression instanceof ParsedExpression.Reference reference) {
      found.add(reference);
    } else if (expression instanceof ParsedExpression.Sum sum) {
      sum.parts().forEach(part -> collect(part.operand()));
    } else if (expression instanceof ParsedExpression.Product product) {
      product.parts().forEach(part -> collect(part.operand()));
    } else if (expression instanceof ParsedExpression.Negation negation) {
      collect(negation.operand());
    } else if (expression instanceof ParsedExpression.Power power) {
      collect(power.base());
      collect(power.exponent());
    } else if (expression instanceof ParsedExpression.Call call) {
      call.arguments().forEach(this::collect);
    } else if (expression instanceof ParsedExpression.TableCall call) {
      call.arguments().forEach(this::collect);
    }
  }
}
