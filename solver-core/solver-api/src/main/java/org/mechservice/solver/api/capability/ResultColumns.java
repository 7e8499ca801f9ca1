package org.mechservice.solver.api.capability;

import java.util.List;
import java.util.Optional;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.RunNotes.Note;

/**
 * A model that was built with further groups of result columns: residuals and multipliers of
 * constraints, joint reactions, values of forces, outputs of the user.
 */
public interface ResultColumns {
  /** No columns. */
  ResultColumns NONE =
      new ResultColumns() {
        @Override
        public List<Variable> columns(ColumnGroup group) {
          return List.of();
        }

        @Override
        public void values(ColumnGroup group, double t, double[] y, double[] values, int at) {}
      };

  /** Returns the columns of a group, in order; empty if the model has none or lacks the group. */
  List<Variable> columns(ColumnGroup group);

  /**
   * Evaluates the columns of a group.
   *
   * @param t time, s
   * @param y state [q; v]; not modified
   * @param values one number per column of {@link #columns}, from {@code at}; overwritten
   * @param at index of the first
   */
  void values(ColumnGroup group, double t, double[] y, double[] values, int at);

  /**
   * Watches a state of the motion for what notes tell: constraints that push only, and pull there.
   * Rows call it; a state in between may be given as well.
   *
   * @param t time, s
   * @param y state [q; v]; not modified
   */
  default void observe(double t, double[] y) {}

  /** Returns the notes on the states observed so far. */
  default List<Note> notes() {
    return List.of();
  }

  /** Returns the balance of momentum that a run must update, if its columns are among these. */
  default Optional<MomentumBalance> momentum() {
    return Optional.empty();
  }
}
