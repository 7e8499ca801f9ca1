package org.mechservice.solver.force.formula;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.Negation;
import org.mechservice.solver.expression.Expression.Product;
import org.mechservice.solver.expression.Expression.Quotient;
import org.mechservice.solver.expression.Expression.Sum;
import org.mechservice.solver.expression.Expression.Time;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.symbol.MathFunction;

/** Formulas as text. */
final class FormulaTextTest {
  private static final Expression T = new Time();

  private final FormulaText text =
      new FormulaText(
          new Mechanism(
              "m",
              new Root("ground", Vector3.ZERO, Rotation.IDENTITY),
              Vector3.ZERO,
              List.of(),
              List.of()));

  @Test
  void bracketsStandWhereTheyAreNeeded() {
    Expression sum = new Sum(T, new Negation(Expression.of(2)));
    assertThat(text.of(sum)).isEqualTo("t - 2");
    assertThat(text.of(new Product(sum, T))).isEqualTo("(t - 2)*t");
    assertThat(text.of(new Quotient(T, new Product(T, T)))).isEqualTo("t/(t*t)");
    assertThat(text.of(new Expression.Power(new Negation(T), Expression.of(3))))
        .isEqualTo("(-t)^3");
    assertThat(text.of(Expression.call(MathFunction.MAX, List.of(Expression.ZERO, T))))
        .isEqualTo("max(0, t)");
  }

  @Test
  void aFormulaIsCutWhereItIsLong() {
    Expression sum = new Sum(T, new Sum(T, T));
    assertThat(text.beginning(sum, 9)).isEqualTo("t + t + t");
    assertThat(text.beginning(sum, 5)).isEqualTo("t + t...");
  }

  /** Twice its part sixty times: a text of 2⁶⁰ letters. */
  @Test
  void theRestOfALongFormulaIsNotWritten() {
    Expression formula = T;
    for (int i = 0; i < 60; i++) {
      formula = new Sum(formula, formula);
    }
    assertThat(text.beginning(formula, 8)).isEqualTo("t + t + ...");
  }
}
