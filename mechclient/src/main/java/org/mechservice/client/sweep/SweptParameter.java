package org.mechservice.client.sweep;

import java.util.List;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * A parameter and its values in a sweep.
 *
 * @param name as in the model file
 * @param values expressions, read in the unit that the file gives the parameter; one or more
 */
public record SweptParameter(String name, List<String> values) {
  public SweptParameter {
    values = List.copyOf(values);
    if (values.isEmpty()) {
      throw new IllegalArgumentException(
          MessageCode.OPTION_UNUSABLE + " parameter \"" + name + "\" has no values");
    }
  }

  /**
   * Evenly spaced values with both ends.
   *
   * @param count how many, 2 or more
   */
  public static SweptParameter range(String name, double from, double to, int count) {
    if (count < 2) {
      throw new IllegalArgumentException(
          MessageCode.OPTION_UNUSABLE
              + " a range has 2 values or more, not "
              + count
              + "; for one write its value alone");
    }
    String[] values = new String[count];
    for (int i = 0; i < count; i++) {
      // Divided last, so that tenths come out as tenths; the last is the end whatever rounding
      // does.
      double value = i == count - 1 ? to : from + (to - from) * i / (count - 1);
      values[i] = Double.toString(value);
    }
    return new SweptParameter(name, List.of(values));
  }
}
