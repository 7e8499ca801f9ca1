package org.mechservice.mechml.expression;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import java.time.Duration;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Random texts: they have a finite value or are refused with a place inside the text. */
class MutatedExpressionTest {
  private static final Duration PATIENCE = Duration.ofMinutes(5);
  private static final int TEXTS = 20_000;
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
          "pow(");

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void randomTextsHaveAFiniteValueOrAreRefusedInPlace(long seed) {
    Random random = new Random(seed);
    assertTimeoutPreemptively(
        PATIENCE,
        () -> {
          for (int i = 0; i < TEXTS; i++) {
            StringBuilder text = new StringBuilder();
            for (int k = random.nextInt(30); k >= 0; k--) {
              text.append(WORDS.get(random.nextInt(WORDS.size())));
            }
            evaluateOrRefuse(text.toString());
          }
        });
  }

  private static void evaluateOrRefuse(String text) {
    try {
      assertThat(Evaluation.of(ExpressionParser.parse(text), Scope.CONSTANTS)).as(text).isFinite();
    } catch (ExpressionException e) {
      assertThat(e.offset()).as(text).isBetween(0, text.length());
      assertThat(e.reason()).isNotBlank();
    }
  }
}
