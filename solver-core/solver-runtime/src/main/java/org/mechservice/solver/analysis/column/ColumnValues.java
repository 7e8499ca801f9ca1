package org.mechservice.solver.analysis.column;

import java.util.List;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.RunNotes.Note;

/** One group of result columns, read from equations of motion that have been balanced. */
interface ColumnValues {
  /** Returns name and unit of each column. */
  List<Variable> columns();

  /**
   * Writes the values.
   *
   * @param t time, s
   * @param values as many as there are columns, from {@code at}; overwritten
   */
  void write(double t, double[] values, int at);

  /** Returns whether {@link #observe} watches the motion for notes. */
  default boolean observes() {
    return false;
  }

  /**
   * Watches the balanced state.
   *
   * @param t time, s
   */
  default void observe(double t) {}

  /** Returns the notes on what was observed. */
  default List<Note> notes() {
    return List.of();
  }
}
