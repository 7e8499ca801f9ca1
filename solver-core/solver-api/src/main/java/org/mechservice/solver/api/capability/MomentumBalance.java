package org.mechservice.solver.api.capability;

import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.api.run.RunNotes.Note;

/**
 * Balance of the total momentum during a run and the impulse of gravity, applied forces and ground
 * reactions. Their difference is the error of the integration and of the closing of loops. Its
 * columns are those of {@link ColumnGroup#MOMENTUM}, which evaluate the balance at each row.
 */
public interface MomentumBalance extends ModelState {
  /** Resets the balance for a new run. */
  void begin();

  /**
   * Adds the impulse of an interval by quadrature.
   *
   * @param seconds quadrature weight of the state, s
   * @param t time of the state, s
   * @param y state [q; v], in which loops are closed; not modified
   */
  void add(double seconds, double t, double[] y);

  /**
   * Adds the change of the state by an event as an impulse.
   *
   * @param tBefore last time before it, s
   * @param before state then; not modified
   * @param t first time after it, s
   * @param after state then, loops closed; not modified
   */
  void jump(double tBefore, double[] before, double t, double[] after);

  /** Returns whether the drift at the last row is above a fraction of the scale so far, or NaN. */
  boolean exceeds(double part);

  /** Returns the failure of a run whose balance has drifted above a fraction of its scale. */
  Failure failure(double part, double t, double stepSize, int order);

  /** Returns drift and scale over all rows, for the report. */
  Note note();
}
