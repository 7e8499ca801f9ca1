package org.mechservice.mechml.unit;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.mechml.diagnosis.Quoted;

/**
 * Reads units such as {@code mm}, {@code kg*m^2}, {@code m/s^2}: symbols joined by {@code *} and
 * {@code /}, each with a whole power from −9 to 9. A slash divides by the next symbol only.
 */
public final class UnitParser {
  private static final Pattern FACTOR =
      Pattern.compile("\\s*+([*·/]?)\\s*+([A-Za-z]++|1)(?:\\^(-?[0-9])|([²³]))?\\s*+");

  /** Longest text accepted; the powers of longer ones could leave the range of doubles. */
  private static final int LONGEST = 40;

  private UnitParser() {}

  /**
   * Reads a unit.
   *
   * @throws UnitException if the text is not a unit; its message says why
   */
  public static Unit parse(String text) throws UnitException {
    Matcher factor = FACTOR.matcher(text);
    Unit unit = Unit.ONE;
    int position = 0;
    while (position < text.length() || position == 0) {
      boolean wellFormed =
          text.length() <= LONGEST
              && factor.region(position, text.length()).lookingAt()
              && factor.group(1).isEmpty() == (position == 0);
      if (!wellFormed) {
        throw new UnitException(
            Quoted.of(text) + " is not a unit; write symbols joined by * and /, as in kg*m^2");
      }
      unit = unit.times(factor(text, factor));
      position = factor.end();
    }
    return unit;
  }

  private static Unit factor(String text, Matcher factor) throws UnitException {
    String symbol = String.valueOf(factor.group(2));
    Unit base = symbol.equals("1") ? Unit.ONE : symbol(text, symbol);
    int power = power(factor);
    return base.power("/".equals(factor.group(1)) ? -power : power);
  }

  private static int power(Matcher factor) {
    String digit = factor.group(3);
    String raised = factor.group(4);
    if (digit != null) {
      return Integer.parseInt(digit);
    }
    return raised == null ? 1 : raised.equals("²") ? 2 : 3;
  }

  private static Unit symbol(String text, String symbol) throws UnitException {
    return UnitSymbols.unit(symbol)
        .orElseThrow(
            () ->
                new UnitException(
                    Quoted.of(text)
                        + " is not a unit"
                        + NearestName.of(symbol, UnitSymbols.all())
                            .map(n -> "; did you mean " + Quoted.of(n) + "?")
                            .orElse("; known are " + String.join(", ", UnitSymbols.all()))));
  }
}
