package org.mechservice.client.sweep;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * All combinations of the values of some parameters. Points are numbered from 0; the last parameter
 * changes from each to the next.
 *
 * @param parameters one or more, of different names
 */
public record SweepGrid(List<SweptParameter> parameters) {
  /** Largest number of points; more are a probable mistake. */
  public static final int MOST_POINTS = 1_000_000;

  public SweepGrid {
    parameters = List.copyOf(parameters);
    long points = 1;
    for (SweptParameter parameter : parameters) {
      points *= parameter.values().size();
      if (points > MOST_POINTS) {
        throw new IllegalArgumentException(
            MessageCode.OPTION_UNUSABLE
                + " the grid has more than "
                + MOST_POINTS
                + " points; take fewer values");
      }
    }
    if (parameters.stream().map(SweptParameter::name).distinct().count() < parameters.size()) {
      throw new IllegalArgumentException(
          MessageCode.OPTION_UNUSABLE + " a parameter is swept twice");
    }
  }

  /** Returns the number of points. */
  public int size() {
    return parameters.stream()
        .mapToInt(parameter -> parameter.values().size())
        .reduce(1, (a, b) -> a * b);
  }

  /** Returns the values at a point by the parameters' names, in their order. */
  public Map<String, String> point(int index) {
    String[] chosen = new String[parameters.size()];
    int rest = index;
    for (int i = parameters.size() - 1; i >= 0; i--) {
      List<String> values = parameters.get(i).values();
      chosen[i] = values.get(rest % values.size());
      rest /= values.size();
    }
    Map<String, String> point = new LinkedHashMap<>();
    for (int i = 0; i < chosen.length; i++) {
      point.put(parameters.get(i).name(), chosen[i]);
    }
    return point;
  }
}
