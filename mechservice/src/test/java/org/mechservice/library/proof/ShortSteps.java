package org.mechservice.library.proof;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.library.MechModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.api.program.RunFailedException;
import org.mechservice.solver.api.program.Trajectory;

/**
 * Right ends by the model itself in steps so short that nothing can be passed over, where a second
 * set of equations would be as long as the product's.
 */
final class ShortSteps {
  private ShortSteps() {}

  /**
   * Returns what is expected; empty if the model refuses to run.
   *
   * @param text the model in short steps
   * @param columns columns that are compared: positions, then as many velocities
   * @param without their values without what a step could pass over
   */
  static Optional<List<Expected>> of(
      String text, String[] columns, double[] without, double end, Method method) {
    try {
      Trajectory rows = MechModel.of("m.xml", text).simulate();
      int last = rows.rows() - 1;
      int n = columns.length;
      double largest = 0;
      double[] right = new double[n];
      double[] allowed = new double[n];
      for (int i = 0; i < n; i++) {
        double[] column = rows.column(columns[i]);
        right[i] = column[last];
        allowed[i] = method.allowed(Math.max(Math.abs(right[i]), Math.abs(column[0])));
        if (i >= n / 2) {
          largest = Math.max(largest, Math.abs(right[i] - without[i]));
        }
      }
      List<Expected> expected = new ArrayList<>();
      for (int i = 0; i < n; i++) {
        boolean place = i < n / 2;
        double least = 0.1 * largest * (place ? Math.min(1, end) : 1);
        double change = Math.max(Math.abs(right[i] - without[i]), least);
        double other = allowed[place ? i + n / 2 : i - n / 2];
        expected.add(
            new Expected(columns[i], right[i], allowed[i] + other * (place ? 1 : 10), change)
                .known(3e-6));
      }
      return Optional.of(expected);
    } catch (MechmlException e) {
      throw new IllegalStateException(e);
    } catch (RunFailedException e) {
      // such as a sphere in a bend that is narrower than itself: refused, so there is no motion
      return Optional.empty();
    }
  }
}
