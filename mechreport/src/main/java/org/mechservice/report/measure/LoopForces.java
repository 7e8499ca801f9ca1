package org.mechservice.report.measure;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.mechservice.report.solution.StateDistance;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.capability.ResultColumns;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.result.Variable;

/**
 * What states say of the closed loops of a model: how far they are open, and the forces that close
 * them.
 */
public final class LoopForces {
  private final ResultColumns columns;
  private final double[] values;
  private final double[] expected;
  private final int residual;
  private final int residualRate;
  private final int[] multipliers;

  private LoopForces(ResultColumns columns, List<String> names) {
    this.columns = columns;
    values = new double[names.size()];
    expected = new double[names.size()];
    residual = names.indexOf("constraint.position");
    residualRate = names.indexOf("constraint.velocity");
    multipliers =
        IntStream.range(0, names.size()).filter(i -> names.get(i).contains(".lambda")).toArray();
  }

  /**
   * Returns what a model built with {@link ColumnGroup#CONSTRAINTS} knows of its loops; empty if it
   * has none.
   */
  public static Optional<LoopForces> of(Model model) {
    ResultColumns columns = ModelParts.of(model).columns();
    List<String> names =
        columns.columns(ColumnGroup.CONSTRAINTS).stream().map(Variable::name).toList();
    LoopForces loops = new LoopForces(columns, names);
    return loops.residual < 0 ? Optional.empty() : Optional.of(loops);
  }

  /** Returns by how much the loops are open, m. */
  public double residual(double t, double[] y) {
    columns.values(ColumnGroup.CONSTRAINTS, t, y, values, 0);
    return values[residual];
  }

  /** Returns how fast the loops open, m/s. */
  public double residualRate(double t, double[] y) {
    columns.values(ColumnGroup.CONSTRAINTS, t, y, values, 0);
    return values[residualRate];
  }

  /** Returns how far the multipliers of two states lie apart, as {@link StateDistance} does. */
  double distance(double t, double[] y, double[] reference) {
    columns.values(ColumnGroup.CONSTRAINTS, t, y, values, 0);
    columns.values(ColumnGroup.CONSTRAINTS, t, reference, expected, 0);
    double largest = 0;
    for (int i : multipliers) {
      double apart = Math.abs(values[i] - expected[i]) / (1 + Math.abs(expected[i]));
      largest = apart >= 0 ? Math.max(largest, apart) : Double.POSITIVE_INFINITY;
    }
    return largest;
  }
}
