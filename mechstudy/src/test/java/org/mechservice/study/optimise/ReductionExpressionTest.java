package org.mechservice.study.optimise;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.mechml.expression.ConstantEvaluation;
import org.mechservice.study.Reduction;

class ReductionExpressionTest {
  private static final Map<String, Double> PARAMETERS = Map.of("c", 4.0, "width", 0.5);

  private final List<Reduction> reductions = new ArrayList<>();

  private ReductionExpression parse(String text) {
    return ReductionExpression.parse(text, reductions, PARAMETERS.keySet());
  }

  @Test
  void reductionsAndParametersHaveTheirValues() {
    ReductionExpression sum = parse("rms(seat.a) + 0.1*max( seat.q[2] )/c");
    ReductionExpression again = parse("-at(seat.a, 2.5)^2 + rms(seat.a)");
    assertThat(reductions)
        .extracting(Reduction::toString)
        .containsExactly("rms(seat.a)", "max(seat.q[2])", "at(seat.a,2.5)");
    double[] reduced = {3, 20, 2};
    assertThat(sum.value(reduced, PARAMETERS)).isEqualTo(3.5);
    assertThat(again.value(reduced, PARAMETERS)).isEqualTo(-1);
    assertThat(sum).hasToString("rms(seat.a) + 0.1*max( seat.q[2] )/c");
  }

  /** Of one output the least and the largest over time, of two numbers the functions. */
  @Test
  void minAndMaxAreReductionsOfOneAndFunctionsOfTwo() {
    ReductionExpression formula = parse("max(max(x), (c)) - min(min(y), 1)");
    assertThat(reductions).extracting(Reduction::toString).containsExactly("max(x)", "min(y)");
    assertThat(formula.value(new double[] {7, -2}, PARAMETERS)).isEqualTo(9);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {"sin(1.1)", "exp(0.3)^1.7", "hypot(3, 4)/7", "log(2)*PI", "Math.cos(22)", "5*-2^-2"})
  void constantsHaveTheirValuesInModelFiles(String text) throws Exception {
    ReductionExpression formula = parse(text);
    assertThat(formula.isConstant()).isTrue();
    assertThat(formula.value(new double[0], Map.of())).isEqualTo(ConstantEvaluation.of(text));
  }

  @Test
  void parametersAndOutputsAreNotConstant() {
    assertThat(parse("2*c").isConstant()).isFalse();
    assertThat(parse("2*last(x)").isConstant()).isFalse();
  }

  @Test
  void valueIsNaNWhereAPartHasNone() {
    assertThat(parse("1/(c - 4)").value(new double[0], PARAMETERS)).isNaN();
    assertThat(parse("crossing(x, 0)").value(new double[] {Double.NaN}, PARAMETERS)).isNaN();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "seat.q + 1 | \"seat.q\" is no parameter; of an output write what is taken, such as last(",
        "2*rms(x + 1 | a closing bracket is missing",
        "top(x) | there is no reduction \"top\"",
        "series(x) | a series is not one number; write at(x, TIME)",
        "max(x) + | expected a number, a name or \"(\", found the end, at character 9",
        "max(x) max(y) | expected an operator or the end, found \"max(y)\"",
        "sin(1, 2) | sin takes 1 argument, not 2, at character 1",
        "max(x) <= 3 | \"<\" has no meaning here",
      })
  void whatCannotBeReadIsToldWithItsPlace(String text, String message) {
    assertThatThrownBy(() -> parse(text))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith("\"" + text + "\": ")
        .hasMessageContaining(message);
  }

  @Test
  void namesOfParametersGoBeforeTheNumbersOfFormulas() {
    ReductionExpression formula = ReductionExpression.parse("PI/2", reductions, Set.of("PI"));
    assertThat(formula.value(new double[0], Map.of("PI", 3.0))).isEqualTo(1.5);
    assertThat(formula.isConstant()).isFalse();
  }
}
