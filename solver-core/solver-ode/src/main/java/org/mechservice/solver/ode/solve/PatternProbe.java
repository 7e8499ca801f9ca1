package org.mechservice.solver.ode.solve;

import java.util.Random;
import java.util.stream.IntStream;
import org.mechservice.solver.ode.SparseSystem;

/** Finds which components each equation has in it by moving them one at a time. */
final class PatternProbe {
  /** A component is moved by this part of its size, or of one. */
  private static final double MOVE = 1e-3;

  /** The second state to look at is another by up to this part of each component. */
  private static final double APART = 1e-2;

  private static final long SEED = 1;

  private PatternProbe() {}

  /**
   * Returns the couplings seen near a state, from 2 n + 2 evaluations.
   *
   * @throws IllegalArgumentException if f is not finite there
   */
  static SparseSystem near(OdeFunction function, double t, double[] y) {
    int n = y.length;
    double[] other = y.clone();
    Random random = new Random(SEED);
    for (int j = 0; j < n; j++) {
      other[j] += APART * random.nextDouble() * Math.max(1, Math.abs(y[j]));
    }
    double[][] points = {y.clone(), other};
    double[][] values = {valueAt(function, t, points[0]), valueAt(function, t, points[1])};
    int[][] rows = new int[n][];
    for (int j = 0; j < n; j++) {
      boolean[] coupled = new boolean[n];
      for (int point = 0; point < points.length; point++) {
        double own = points[point][j];
        points[point][j] += MOVE * Math.max(1, Math.abs(own));
        double[] moved = new double[n];
        function.evaluate(t, points[point], moved);
        points[point][j] = own;
        for (int i = 0; i < n; i++) {
          coupled[i] |= moved[i] != values[point][i];
        }
      }
      rows[j] = IntStream.range(0, n).filter(i -> coupled[i]).toArray();
    }
    return SparseSystem.byColumns(j -> rows[j]);
  }

  private static double[] valueAt(OdeFunction function, double t, double[] y) {
    double[] value = new double[y.length];
    function.evaluate(t, y, value);
    for (int i = 0; i < value.length; i++) {
      if (!Double.isFinite(value[i])) {
        throw new IllegalArgumentException(
            "f["
                + i
                + "] is "
                + value[i]
                + " near the state at which the pattern is to be found;"
                + " give another state, or the pattern");
      }
    }
    return value;
  }
}
