package org.mechservice.solver.api.capability;

import java.io.IOException;
import java.util.List;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;

/** A model whose rows are not states: the modes of small motions, or their equations. */
public interface ResultTable extends Model, Defects {
  /** Returns the columns of the table; the first is time. */
  List<Variable> columns();

  /**
   * Computes the table at one instant.
   *
   * @param t time, s
   * @param sink receives the rows, with as many numbers as there are columns
   * @return {@link ExplicitModel#REGULAR}, or {@link Defects#DEFECT} if there is none
   * @throws IOException if the sink could not store a row
   */
  int tabulate(double t, ResultSink sink) throws IOException;
}
