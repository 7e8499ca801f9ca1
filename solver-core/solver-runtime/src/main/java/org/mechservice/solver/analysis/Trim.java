package org.mechservice.solver.analysis;

import java.net.URLDecoder;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.StringJoiner;
import org.mechservice.solver.mechanism.FurtherState;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * A trim problem by its names: what may change, and what has to have given values.
 *
 * @param unknowns coordinates {@code joint.q} and velocities {@code joint.v}, with the number of
 *     the velocity {@code [i]} where a joint has several, further states and inputs by their names
 * @param conditions what has to have a value
 */
public record Trim(List<String> unknowns, List<Condition> conditions) {
  private static final String UNKNOWN = "u:";
  private static final String CONDITION = "c:";

  /**
   * A condition.
   *
   * @param name acceleration {@code joint.a}, derivative {@code state.rate} of a further state, or
   *     output
   * @param value its value, SI, or in the unit of the state or output
   */
  public record Condition(String name, double value) {}

  public Trim {
    unknowns = List.copyOf(unknowns);
    conditions = List.copyOf(conditions);
  }

  /** Returns the problem of a mechanism with further states that rests: nothing accelerates. */
  static Trim ofRest(Mechanism mechanism) {
    CoordinateNames names = new CoordinateNames(mechanism);
    List<String> unknowns = new ArrayList<>();
    List<Condition> conditions = new ArrayList<>();
    for (int j = 0; j < names.count(); j++) {
      unknowns.add(names.of(j, "q"));
      conditions.add(new Condition(names.of(j, "a"), 0));
    }
    for (FurtherState state : mechanism.furtherStates()) {
      if (state.role() == FurtherState.Role.INTEGRATED) {
        unknowns.add(state.name());
        conditions.add(new Condition(state.name() + ".rate", 0));
      }
    }
    return new Trim(unknowns, conditions);
  }

  /** Returns the problem of words as {@link #text} writes them. */
  static Trim of(List<String> words) {
    List<String> unknowns = new ArrayList<>();
    List<Condition> conditions = new ArrayList<>();
    for (String word : words) {
      String text = URLDecoder.decode(word.substring(UNKNOWN.length()), StandardCharsets.UTF_8);
      int equals = text.lastIndexOf('=');
      if (word.startsWith(UNKNOWN)) {
        unknowns.add(text);
      } else {
        double value = Double.parseDouble(text.substring(equals + 1));
        conditions.add(new Condition(text.substring(0, equals), value));
      }
    }
    return new Trim(unknowns, conditions);
  }

  /**
   * Returns a problem as words without blanks, separated by blanks.
   *
   * @param conditions values by name
   */
  public static String text(List<String> unknowns, Map<String, Double> conditions) {
    StringJoiner words = new StringJoiner(" ");
    unknowns.forEach(name -> words.add(UNKNOWN + encoded(name)));
    conditions.forEach((name, value) -> words.add(CONDITION + encoded(name + "=" + value)));
    return words.toString();
  }

  private static String encoded(String text) {
    return URLEncoder.encode(text, StandardCharsets.UTF_8);
  }
}
