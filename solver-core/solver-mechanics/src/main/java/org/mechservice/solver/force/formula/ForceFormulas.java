package org.mechservice.solver.force.formula;

import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Table;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.PairForce;

/**
 * The formulas of a mechanism's forces decomposed for diagnosis: from the inside out every
 * subexpression that can be undefined although its operands are defined, or that can jump, with its
 * operands; then the whole formula.
 */
public final class ForceFormulas {
  /** Largest length of a formula's text; a longer one is cut, since it need only be recognised. */
  private static final int LONGEST_TEXT = 160;

  /** Largest total length of all lines, so that they fit into a class file. */
  private static final int MOST_TEXT = 20_000;

  private final FormulaText text;
  private final List<Expression> expressions = new ArrayList<>();
  private final StringBuilder lines = new StringBuilder();
  private boolean canFail;

  private ForceFormulas(Mechanism mechanism) {
    text = new FormulaText(mechanism);
    for (ForceElement force : mechanism.forces()) {
      if (force instanceof PairForce) {
        // its formulas are built from its coefficients, and no reader of the model has seen them
        continue;
      }
      force
          .formulas()
          .forEach(formula -> add(force.name(), formula.quantity(), formula.expression()));
    }
  }

  /**
   * Decomposes the formulas of a mechanism's forces.
   *
   * @return empty if all of them have a value and a derivative in every state of moderate size, or
   *     if there are too many
   */
  public static Optional<ForceFormulas> of(Mechanism mechanism) {
    ForceFormulas formulas = new ForceFormulas(mechanism);
    return formulas.canFail && formulas.lines.length() <= MOST_TEXT
        ? Optional.of(formulas)
        : Optional.empty();
  }

  /**
   * Returns the expressions to be evaluated: for each line the subexpression, then its operands in
   * the order of the line.
   */
  public List<Expression> expressions() {
    return List.copyOf(expressions);
  }

  /**
   * Returns a line for each subexpression: force, quantity, its formula, the subexpression and its
   * operands, separated by tabs.
   */
  public String lines() {
    return lines.toString();
  }

  private void add(String force, String quantity, Expression formula) {
    String head = force + "\t" + quantity + "\t" + shown(formula);
    parts(head, formula, Collections.newSetFromMap(new IdentityHashMap<>()));
    line(head, formula, List.of());
  }

  private void parts(String head, Expression formula, Set<Expression> seen) {
    if (!seen.add(formula) || lines.length() > MOST_TEXT) {
      return;
    }
    List<Expression> arguments = Expression.operands(formula);
    arguments.forEach(argument -> parts(head, argument, seen));
    if (mayFail(formula)) {
      canFail = true;
      List<Expression> moving =
          arguments.stream().filter(a -> !(a instanceof Expression.Constant)).toList();
      line(head, formula, moving);
    }
  }

  private void line(String head, Expression part, List<Expression> arguments) {
    lines.append(lines.isEmpty() ? "" : "\n").append(head).append('\t').append(shown(part));
    expressions.add(part);
    for (Expression argument : arguments) {
      lines.append('\t').append(shown(argument));
      expressions.add(argument);
    }
  }

  private String shown(Expression formula) {
    return text.beginning(formula, LONGEST_TEXT);
  }

  /** Returns whether a subexpression can be not finite for moderate operands, or can jump. */
  private static boolean mayFail(Expression part) {
    if (part instanceof Expression.Quotient quotient) {
      return !(quotient.divisor() instanceof Expression.Constant);
    } else if (part instanceof Expression.Power) {
      return true;
    } else if (part instanceof Expression.TableValue value) {
      return value.table().outside() == Table.Extrapolation.ERROR;
    } else if (part instanceof Expression.Call call) {
      return switch (call.function()) {
        case SQRT, LOG, ASIN, ACOS, TAN, EXP, POWER, SINH, COSH, SIGNUM, STEP, FLOOR -> true;
        default -> false;
      };
    }
    return false;
  }
}
