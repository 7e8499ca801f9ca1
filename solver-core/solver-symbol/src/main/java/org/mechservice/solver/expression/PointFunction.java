package org.mechservice.solver.expression;

import java.util.List;
import org.mechservice.solver.symbol.GivenFunction;

/** A function of one or two arguments that a model gives by points. */
public sealed interface PointFunction permits Table, TableMap {
  /** Returns its name in the model file. */
  String name();

  /** Returns the arguments of its points, strictly ascending: one list for each argument. */
  List<List<Double>> grid();

  /** Returns the values beyond the points. */
  Table.Extrapolation outside();

  /** Returns it as one node of a graph. */
  GivenFunction function();

  /** Returns the number of its arguments, 1 or 2. */
  default int argumentCount() {
    return grid().size();
  }

  /**
   * Returns its value; NaN where it has none.
   *
   * @param arguments as many as it has
   */
  default double at(List<Double> arguments) {
    return function().at(arguments.get(0), arguments.get(arguments.size() - 1));
  }
}
