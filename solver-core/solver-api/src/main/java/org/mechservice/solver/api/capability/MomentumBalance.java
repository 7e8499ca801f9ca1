package org.mechservice.solver.api.capability;

import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.api.run.RunNotes.Note;

/**
 * Momentum of the whole mechanism along a run, against the impulse of gravity, applied forces and
 * the ground's reactions. What differs is what the integration, and the closing of loops, have made
 * of it. Its columns are those of {@link ColumnGroup#MOMENTUM}, which judge the balance at each
 * row.
 */
public interface MomentumBalance extends ModelState {
  /** Forgets an earlier run. */
  void begin();

  /**
   * Adds the impulse of some time, by quadrature.
   *
   * @param seconds weight of the state: the time it stands for, s
   * @param t time of the state, s
   * @param y state [q; v], in which loops are closed; not modified
   */
  void add(double seconds, double t, double[] y);

  /**
   * Takes an event that has set the state for an impulse.
   *
   * @param tBefore last time before it, s
   * @param before state then; not modified
   * @param t first time after it, s
   * @param after state then, loops closed; not modified
   */
  void jump(double tBefore, double[] before, double t, double[] after);

  /**
   * Returns whether the drift at the last row is above a part of the scale so far, or no number.
   */
  boolean exceeds(double part);

  /** Returns how a run ends whose balance has drifted above a part of its scale. */
  Failure failure(double part, double t, double stepSize, int order);

  /** Returns drift and scale over all rows, for the report. */
  Note note();
}
