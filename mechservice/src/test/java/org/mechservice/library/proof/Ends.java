package org.mechservice.library.proof;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Right values at the end of a motion of a {@link PlainSystem}, with their spread and effect. */
final class Ends {
  /**
   * Largest change of an end, as part of the effect, for the same part of the start. Beyond it, and
   * that is at 1e-9 of the start 1e-5 of the effect, a scene is dropped.
   */
  private static final double MOST_SENSITIVE = 1e4;

  private Ends() {}

  /**
   * Returns what is expected of a motion.
   *
   * @param columns names of the states in results; empty: not compared
   * @param on the motion
   * @param off the motion without what a step could pass over
   * @param start its start: positions, then as many velocities
   * @param end its time
   * @param method how it runs
   */
  static Optional<List<Expected>> of(
      String[] columns,
      PlainSystem on,
      PlainSystem off,
      double[] start,
      double end,
      Method method) {
    int n = start.length;
    double[] right = PlainMotion.end(on, start, end);
    double[] without = PlainMotion.end(off, start, end);
    double[] size = new double[n];
    double[] allowed = new double[n];
    for (int i = 0; i < n; i++) {
      size[i] = Math.max(1e-3, Math.max(Math.abs(start[i]), Math.abs(right[i])));
      allowed[i] = method.allowed(size[i]);
    }
    double[][] change = PlainMotion.sensitivity(on, start, end, size);
    double[] effect = effects(right, without, end);
    List<Expected> expected = new ArrayList<>();
    for (int i = 0; i < n; i++) {
      if (columns[i].isEmpty()) {
        continue;
      }
      double spread = allowed[i];
      double sensitive = 0;
      for (int j = 0; j < n; j++) {
        spread += Math.abs(change[i][j]) * allowed[j];
        sensitive += Math.abs(change[i][j]) * size[j];
      }
      if (!(sensitive < MOST_SENSITIVE * effect[i])) {
        return Optional.empty();
      }
      expected.add(new Expected(columns[i], right[i], spread, effect[i]));
    }
    return Optional.of(expected);
  }

  /**
   * Returns the effect on each state, at least a tenth of the largest among the velocities, and for
   * positions that times the duration: an end that happens to be the same hides no effect.
   */
  private static double[] effects(double[] right, double[] without, double end) {
    int n = right.length;
    double largest = 0;
    for (int i = n / 2; i < n; i++) {
      largest = Math.max(largest, Math.abs(right[i] - without[i]));
    }
    double[] effect = new double[n];
    for (int i = 0; i < n; i++) {
      double least = 0.1 * largest * (i < n / 2 ? end : 1);
      effect[i] = Math.max(Math.abs(right[i] - without[i]), least);
    }
    return effect;
  }
}
