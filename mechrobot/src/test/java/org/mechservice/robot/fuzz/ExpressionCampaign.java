package org.mechservice.robot.fuzz;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Random;
import org.mechservice.mechml.expression.ConstantEvaluation;
import org.mechservice.mechml.expression.ExpressionException;
import org.mechservice.mechml.expression.ExpressionParser;
import org.mechservice.mechml.expression.Scope;

/** Texts and expressions of one seed, and what became of them. */
final class ExpressionCampaign {
  private static final List<String> WORDS =
      List.of(
          "1",
          "0",
          ".5",
          "1e3",
          "1e308",
          "2.",
          "+",
          "-",
          "*",
          "/",
          "^",
          "(",
          ")",
          ",",
          ".",
          "PI",
          "x",
          "'a b'",
          "'",
          "sqrt(",
          "atan2(",
          "Math.",
          "max(",
          "smoothStep(",
          " ",
          "\t",
          "e5",
          "#",
          "\u00e9",
          "\uD83D",
          "1e-400",
          "log(",
          "pow(",
          "System.exit(0)",
          "[",
          "]",
          "q[0]",
          ";");

  private final Random random;
  private int finite;
  private int refused;

  ExpressionCampaign(long seed) {
    random = new Random(seed);
  }

  /** Words in any order: they have a finite value or are refused with a place inside the text. */
  void texts(int count) {
    for (int i = 0; i < count; i++) {
      StringBuilder text = new StringBuilder();
      for (int k = random.nextInt(30); k >= 0; k--) {
        text.append(WORDS.get(random.nextInt(WORDS.size())));
      }
      evaluateOrRefuse(text.toString());
    }
  }

  private void evaluateOrRefuse(String text) {
    try {
      assertThat(value(text)).as(text).isFinite();
      finite++;
    } catch (ExpressionException e) {
      refused++;
      assertThat(e.offset()).as(text).isBetween(0, text.length());
      assertThat(e.reason()).isNotBlank();
    }
  }

  /**
   * Right expressions: they have the value worked out beside them, and are refused if they have
   * none.
   */
  void expressions(int count) {
    for (int i = 0; i < count; i++) {
      RandomExpression drawn = RandomExpression.draw(random, 6);
      try {
        double value = value(drawn.text());
        finite++;
        assertThat(Double.doubleToLongBits(value))
            .as("%s = %s, not %s", drawn.text(), drawn.value(), value)
            .isEqualTo(Double.doubleToLongBits(drawn.value()));
      } catch (ExpressionException e) {
        refused++;
        assertThat(e.offset()).as(drawn.text()).isBetween(0, drawn.text().length());
        assertThat(drawn.value()).as("%s: %s", drawn.text(), e.reason()).isNaN();
      }
    }
  }

  private static double value(String text) throws ExpressionException {
    return ConstantEvaluation.of(ExpressionParser.parse(text), Scope.CONSTANTS);
  }

  int finite() {
    return finite;
  }

  int refused() {
    return refused;
  }
}
