package org.mechservice.solver.text;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Map;

/** Writes a run report as text: one aligned line per entry, in the report's order, with units. */
public final class ReportText {
  private static final Map<String, String> UNITS =
      Map.ofEntries(
          Map.entry("simulatedTime", "s"),
          Map.entry("wallTime", "s"),
          Map.entry("energyDrift", "J"),
          Map.entry("energyScale", "J"),
          Map.entry("t1c", "s"),
          Map.entry("t1s", "s"),
          Map.entry("t2c", "s"),
          Map.entry("t2s", "s"),
          Map.entry("tcc", "s"),
          Map.entry("tR", "s"),
          Map.entry("tL", "s"),
          Map.entry("modelJarBytes", "B"),
          Map.entry("modelClassBytes", "B"),
          Map.entry("runtimeJarBytes", "B"));

  /** Number of significant digits; the JSON form has all digits. */
  private static final int DIGITS = 4;

  private ReportText() {}

  /**
   * Returns the report as text, ending with a line feed.
   *
   * @param report entries as in {@link org.mechservice.solver.api.run.RunReport#asMap()}
   */
  public static String format(Map<String, Object> report) {
    int width = report.keySet().stream().mapToInt(key -> label(key).length()).max().orElse(0);
    StringBuilder text = new StringBuilder();
    report.forEach(
        (key, value) -> {
          String label = label(key);
          text.append(label).append(" ".repeat(width - label.length() + 2));
          text.append(
              value instanceof Double number
                  ? rounded(number)
                  : value.toString().replace("\n", "\n" + " ".repeat(width + 2)));
          String unit = UNITS.get(key);
          if (unit != null) {
            text.append(' ').append(unit);
          }
          text.append('\n');
        });
    return text.toString();
  }

  /**
   * Turns {@code rejectedSteps} into {@code rejected steps}; the paper's symbols such as {@code
   * t1c} stay.
   */
  private static String label(String key) {
    if (key.length() <= 3) {
      return key;
    }
    StringBuilder label = new StringBuilder();
    for (int i = 0; i < key.length(); i++) {
      char c = key.charAt(i);
      if (Character.isUpperCase(c) && Character.isLowerCase(key.charAt(i - 1))) {
        label.append(' ').append(Character.toLowerCase(c));
      } else {
        label.append(c);
      }
    }
    return label.toString();
  }

  private static String rounded(double value) {
    if (!Double.isFinite(value) || value == 0) {
      return Double.toString(value);
    }
    int leading = (int) Math.floor(StrictMath.log10(Math.abs(value)));
    return ShortestDecimal.format(
        new BigDecimal(value)
            .round(new MathContext(Math.max(DIGITS, Math.min(leading + 1, 17))))
            .doubleValue());
  }
}
