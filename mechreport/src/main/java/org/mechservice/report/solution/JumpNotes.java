package org.mechservice.report.solution;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.mechservice.report.method.ModelPhases;

/** Sentences about events and jumps along a reference. */
final class JumpNotes {
  private JumpNotes() {}

  /**
   * Returns sentences; none where the state does not jump.
   *
   * @param courses phases that the codes of the reference and of its check passed through
   * @param end of the interval judged, s
   * @param clear number of output times that are clear of jumps
   * @param all number of output times
   */
  static List<String> of(List<ModelPhases> courses, double end, int clear, int all) {
    List<List<Double>> jumps = courses.stream().map(course -> until(end, course)).toList();
    if (jumps.isEmpty() || jumps.get(0).isEmpty()) {
      return List.of();
    }
    List<String> said = new ArrayList<>();
    said.add(jumps(jumps.get(0), courses.get(0).changing()));
    if (jumps.size() > 1) {
      said.add(agreement(jumps.get(0), jumps.get(1)));
    }
    said.add(compared(clear, all));
    return said;
  }

  private static List<Double> until(double end, ModelPhases course) {
    return course.jumps().stream().filter(jump -> jump <= end).toList();
  }

  private static String jumps(List<Double> jumps, List<String> changing) {
    String when =
        jumps.size() == 1
            ? format("at %.6g s", jumps.get(0))
            : format(
                "%d times, from %.6g s to %.6g s",
                jumps.size(), jumps.get(0), jumps.get(jumps.size() - 1));
    return "The state jumps "
        + when
        + ", by "
        + String.join(" and ", changing)
        + ". Each code finds the instant by shortening a step of its own until it ends there, and"
        + " goes on from the state that the model's rule gives. No integrator of the product and no"
        + " search of its takes part; the expressions and the rule are the model's, as its"
        + " equations are.";
  }

  private static String agreement(List<Double> a, List<Double> b) {
    if (a.size() != b.size()) {
      return format("One code met %d jumps, the other %d.", a.size(), b.size());
    }
    double apart = 0;
    for (int i = 0; i < a.size(); i++) {
      apart = Math.max(apart, Math.abs(a.get(i) - b.get(i)));
    }
    if (apart == 0) {
      return "The codes place the jumps at the same instants.";
    }
    return format("The codes place the jumps within %.1e s of each other.", apart);
  }

  private static String compared(int clear, int all) {
    return "At a jump the state has two values, and a method late by one rounding error would be"
        + " charged the whole jump. So errors are taken only a quarter of an output interval away"
        + " from every jump, or a quarter of the time between two jumps where that is shorter: "
        + format("%d of %d output times lie there. ", clear, all)
        + "A method that misses the instant by more is charged the jump.";
  }

  private static String format(String text, Object... values) {
    return String.format(Locale.ROOT, text, values);
  }
}
