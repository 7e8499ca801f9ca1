package org.mechservice.mechml.expression;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.OptionalInt;
import java.util.Random;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.RepetitionInfo;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ExpressionTest {
  private static double value(String text) throws ExpressionException {
    return ConstantEvaluation.of(ExpressionParser.parse(text), Scope.CONSTANTS);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "-.064                  | -0.064",
        "+0.064                 | 0.064",
        ".74                    | 0.74",
        "5.                     | 5",
        "1e-05                  | 1e-5",
        "0.877918562E-2         | 0.00877918562",
        "-.064+0.064            | 0",
        "Math.sqrt(0.25)        | 0.5",
        "PI                     | 3.141592653589793",
        "Math.PI                | 3.141592653589793",
        "  1  +  2  * 3         | 7",
        "(1+2)*3                | 9",
        "7-2-3                  | 2",
        "24/4/3                 | 2",
        "2*-3                   | -6",
        "--3                    | 3",
        "-2^2                   | -4",
        "2^3^2                  | 512",
        "2^-2                   | 0.25",
        "6/2*3                  | 9"
      })
  void rulesOfArithmeticHold(String text, double expected) throws ExpressionException {
    assertThat(value(text)).isEqualTo(expected);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "sqrt(4)         | 2",
        "abs(-3)         | 3",
        "sin(PI/6)       | 0.5",
        "cos(PI/3)       | 0.5",
        "tan(PI/4)       | 1",
        "asin(1)         | 1.5707963267948966",
        "acos(-1)        | 3.141592653589793",
        "atan(1)         | 0.7853981633974483",
        "atan2(-1, -1)   | -2.356194490192345",
        "exp(1)          | 2.718281828459045",
        "log(exp(2))     | 2",
        "pow(2, 10)      | 1024",
        "min(1, 2)       | 1",
        "max(1, 2)       | 2",
        "sinh(0)         | 0",
        "cosh(0)         | 1",
        "tanh(100)       | 1",
        "signum(-7)      | -1",
        "hypot(3, 4)     | 5",
        "floor(-1.5)     | -2",
        "step(-0.1)      | 0",
        "step(0)         | 1",
        "smoothStep(-1)  | 0",
        "smoothStep(0.5) | 0.5",
        "smoothStep(2)   | 1"
      })
  void functionsAreThoseOfMathematics(String text, double expected) throws ExpressionException {
    // One ulp of the argument, amplified by at most the slope, and two of the value.
    assertThat(value(text)).isCloseTo(expected, within(Math.max(4e-16, 2 * Math.ulp(expected))));
    assertThat(value("Math." + text)).isEqualTo(value(text));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "1/0         | 1 | division by zero",
        "0/0         | 1 | division by zero",
        "1+2/(3-3)   | 3 | division by zero",
        "sqrt(-1)    | 0 | sqrt(-1.0) is not a real number",
        "log(0)      | 0 | log(0.0) is not finite",
        "1e308*10    | 5 | the product is not finite",
        "1e308+1e308 | 5 | the sum is not finite",
        "0^-1        | 1 | 0.0 ^ -1.0 is not finite",
        "(-1)^0.5    | 4 | -1.0 ^ 0.5 is not a real number",
        "1e999       | 0 | 1e999 is too large",
        "1e-999      | 0 | 1e-999 is too small",
        "2*x         | 2 | \"x\" is not a known name here",
        "sin(time)   | 4 | \"time\" is not a known name here; write time as t",
        "sin + 1     | 0 | sin lacks its arguments",
        "j1.q        | 0 | \"j1.q\" is not a known name here",
        "'bar 1'.q   | 0 | \"bar 1.q\" is not a known name here",
        "pi          | 0 | \"pi\" is not a known name here; did you mean \"PI\"?"
      })
  void whatHasNoValueSaysWhereAndWhy(String text, int offset, String message) {
    assertThatThrownBy(() -> value(text))
        .isInstanceOfSatisfying(
            ExpressionException.class, e -> assertThat(e.offset()).isEqualTo(offset))
        .hasMessage(message);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "1 2          | 2 | expected an operator or the end, found \"2\"",
        "1+           | 2 | expected a number, a name or \"(\", found the end",
        "(1           | 2 | expected an operator or \")\", found the end",
        "1)           | 1 | expected an operator or the end, found \")\"",
        "0,5          | 1 | expected an operator or the end, found \",\"; write decimals with a"
            + " point and separate lists by \";\"",
        "1e           | 1 | expected an operator or the end, found \"e\"",
        "0x10         | 1 | expected an operator or the end, found \"x10\"",
        "1.2.3        | 3 | expected an operator or the end, found \".3\"",
        "a.           | 2 | expected a name, found the end",
        "1 # 2        | 2 | \"#\" has no meaning here",
        "max(1;2)     | 5 | \";\" has no meaning here; a list is not permitted here, and arguments"
            + " are separated by \",\"",
        "1>2          | 1 | \">\" has no meaning here; write a case distinction with step,"
            + " smoothStep, min or max",
        "30\u00b0     | 2 | \"\u00b0\" has no meaning here; write angleUnits or unit to use"
            + " degrees",
        "sgn(4)       | 0 | there is no function \"sgn\"; here it is \"signum\"",
        "arctan(4)    | 0 | there is no function \"arctan\"; here it is \"atan\"",
        "sin()        | 4 | expected a number, a name or \"(\", found \")\"",
        "sin(1, 2)    | 0 | sin takes 1 argument, not 2",
        "atan2(1)     | 0 | atan2 takes 2 arguments, not 1",
        "sqrrt(4)     | 0 | there is no function \"sqrrt\"; did you mean \"sqrt\"?",
        "java.lang.System.exit(0) | 0 | there is no function \"java.lang.System.exit\""
      })
  void whatIsNoExpressionSaysWhereAndWhy(String text, int offset, String message) {
    assertThatThrownBy(() -> ExpressionParser.parse(text))
        .isInstanceOfSatisfying(
            ExpressionException.class, e -> assertThat(e.offset()).isEqualTo(offset))
        .hasMessage(message);
  }

  @Test
  void referencesKeepTheirNames() throws ExpressionException {
    assertThat(ExpressionParser.parse("'left knee'.q"))
        .isEqualTo(
            new ParsedExpression.Reference(List.of("left knee", "q"), OptionalInt.empty(), 0));
  }

  @Test
  void scopesGiveNamesTheirValue() throws ExpressionException {
    ParsedExpression expression = ExpressionParser.parse("2*m + knee.q");
    assertThat(ConstantEvaluation.of(expression, name -> name.text().equals("m") ? 10 : 1))
        .isEqualTo(21);
  }

  @Test
  void longSumsNeedNoStack() throws ExpressionException {
    assertThat(value("1" + "+1".repeat(49_999))).isEqualTo(50_000);
    assertThat(value("1" + "*1".repeat(49_999))).isEqualTo(1);
    assertThat(value("-".repeat(99_998) + "1")).isEqualTo(1);
  }

  @Test
  void nestingHasABound() throws ExpressionException {
    assertThat(value("(".repeat(99) + "1" + ")".repeat(99))).isEqualTo(1);
    for (String opening : new String[] {"(", "sin(", "2^", "-(", "1+("}) {
      assertThatThrownBy(() -> ExpressionParser.parse(opening.repeat(20_000)))
          .isInstanceOf(ExpressionException.class)
          .hasMessage("more than 100 nested parts");
    }
  }

  /** Against numbers composed the same way in Java. */
  @RepeatedTest(50)
  void randomExpressionsHaveTheValueTheirTreeHas(RepetitionInfo repetition)
      throws ExpressionException {
    Random random = new Random(repetition.getCurrentRepetition());
    StringBuilder text = new StringBuilder();
    double expected = compose(random, text, 5);
    assertThat(value(text.toString())).as(text.toString()).isEqualTo(expected);
  }

  /** Writes an expression in brackets and returns its value; divisors stay away from zero. */
  private static double compose(Random random, StringBuilder text, int depth) {
    if (depth == 0) {
      double number = random.nextInt(1, 1000) / 8.0;
      text.append(number);
      return number;
    }
    text.append('(');
    double left = compose(random, text, depth - 1);
    String operator = "+-*/".substring(random.nextInt(4)).substring(0, 1);
    text.append(operator).append(operator.equals("/") ? "(1+abs(" : "(");
    double right = compose(random, text, depth - 1);
    text.append(operator.equals("/") ? ")))" : "))");
    return switch (operator) {
      case "+" -> left + right;
      case "-" -> left - right;
      case "*" -> left * right;
      default -> left / (1 + Math.abs(right));
    };
  }
}
