package org.mechservice.robot;

import java.util.Map;
import java.util.stream.Collectors;
import org.mechservice.solver.text.ShortestDecimal;

/** Pieces of MechML expressions. */
final class MechmlText {
  private MechmlText() {}

  /** Returns a number; zero has no sign. */
  static String number(double value) {
    return ShortestDecimal.format(value + 0.0);
  }

  /** Returns a name with the quotes that expressions need for unusual ones. */
  static String name(String name) {
    return name.matches("[A-Za-z_][A-Za-z0-9_]*") ? name : "'" + name + "'";
  }

  /**
   * Returns a sum of coordinates.
   *
   * @param terms factors by joint
   * @param part {@code .q} or {@code .v}
   */
  static String sum(Map<String, Double> terms, String part) {
    String sum =
        terms.entrySet().stream()
            .map(
                term ->
                    (term.getValue() == 1 ? "" : "(" + number(term.getValue()) + ")*")
                        + name(term.getKey())
                        + part)
            .collect(Collectors.joining(" + "));
    return sum.isEmpty() ? "0" : sum;
  }
}
