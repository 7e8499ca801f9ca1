package org.mechservice.solver.system;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.api.program.Trajectory;
import org.mechservice.solver.api.result.Variable;

/** The linear system in the table of a linearisation. */
public final class SystemTable {
  private SystemTable() {}

  /**
   * Returns the system of a table.
   *
   * @param given outputs of the model's author; if there are none, those of the table are the
   *     displacements of all coordinates
   */
  public static LinearSystem of(Trajectory table, List<Variable> given) {
    List<Variable> all = new ArrayList<>();
    List<Variable> inputs = new ArrayList<>();
    for (Variable column : table.columns()) {
      if (column.name().startsWith("x.")) {
        all.add(new Variable(column.name().substring(2), column.unit()));
      } else if (column.name().startsWith("u.")) {
        inputs.add(new Variable(column.name().substring(2), column.unit()));
      }
    }
    double[] row = table.column("row");
    List<Variable> outputs = new ArrayList<>(given);
    List<Variable> states = new ArrayList<>();
    for (double number : row) {
      int index = (int) number - 1;
      if (index < all.size()) {
        states.add(all.get(index));
      } else if (given.isEmpty()) {
        Variable place = all.get(index - all.size());
        String name = place.name().substring(0, place.name().length() - ".q".length());
        outputs.add(new Variable(name, place.unit()));
      }
    }
    double[][] matrices = new double[4][];
    int n = states.size();
    List<List<Variable>> columns = List.of(states, inputs);
    for (int k = 0; k < 4; k++) {
      List<Variable> across = columns.get(k % 2);
      int from = k < 2 ? 0 : n;
      int rows = k < 2 ? n : outputs.size();
      matrices[k] = new double[rows * across.size()];
      for (int j = 0; j < across.size(); j++) {
        double[] column = table.column((k % 2 == 0 ? "x." : "u.") + across.get(j).name());
        for (int i = 0; i < rows; i++) {
          matrices[k][i * across.size() + j] = column[from + i];
        }
      }
    }
    return new LinearSystem(
        states, inputs, outputs, matrices[0], matrices[1], matrices[2], matrices[3]);
  }
}
