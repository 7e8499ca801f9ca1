package org.mechservice.report.measure;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import org.mechservice.report.solution.Reference;
import org.mechservice.report.solution.StateDistance;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.capability.ResultColumns;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.result.Variable;

/** Residuals of the closed loops of a model at given states, and the forces that close them. */
public final class LoopForces {
  /** The first evaluation is slow because the program is not compiled yet. */
  private static final int TRIALS = 3;

  private final ResultColumns columns;
  private final double[] values;
  private final int residual;
  private final int residualRate;
  private final int[] multipliers;

  /** Row of the reference at each time that is looked at, and the multipliers there. */
  private int[] rows = {};

  private double[][] expected = {};

  private LoopForces(ResultColumns columns, List<String> names) {
    this.columns = columns;
    values = new double[names.size()];
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

  /**
   * Chooses the times of a reference at which runs are compared with it: all, fewer and at last the
   * end alone where the equations of the loops take long, because they are many and redundant.
   *
   * @param runs that are compared
   * @param seconds for all of them
   * @param budget is told of times that are left out
   * @return empty if not even the end can be looked at in every run
   */
  public Optional<LoopForces> within(
      Reference reference, int runs, double seconds, ReportBudget budget) {
    int all = reference.times().length;
    double one = Double.POSITIVE_INFINITY;
    for (int trial = 0; trial < TRIALS; trial++) {
      long started = System.nanoTime();
      values(reference, all - 1);
      one = Math.min(one, (System.nanoTime() - started) * 1e-9);
    }
    int count = (int) Math.min(all, seconds / (one * (runs + 1)));
    if (count < all) {
      String computed =
          count == 0
              ? "not computed"
              : String.format(Locale.ROOT, "computed for %d of %d times", count, all);
      budget.saves(
          "How far loops are open, and the forces that close them, were "
              + computed
              + ", since one time takes "
              + ReportBudget.inWords(one)
              + ".");
    }
    if (count == 0) {
      return Optional.empty();
    }
    rows = IntStream.rangeClosed(1, count).map(i -> (int) ((long) i * all / count) - 1).toArray();
    expected = IntStream.of(rows).mapToObj(row -> values(reference, row)).toArray(double[][]::new);
    return Optional.of(this);
  }

  private double[] values(Reference reference, int row) {
    double[] found = new double[values.length];
    columns.values(
        ColumnGroup.CONSTRAINTS, reference.times()[row], reference.states()[row], found, 0);
    return found;
  }

  /**
   * Returns how far loops are open at most, m, and how far the multipliers lie from those of the
   * reference, as {@link StateDistance} measures it, both at the times looked at.
   *
   * @param state of the run at a row of the reference
   */
  double[] openAndApart(Reference reference, IntFunction<double[]> state) {
    double open = 0;
    double apart = 0;
    for (int k = 0; k < rows.length; k++) {
      columns.values(
          ColumnGroup.CONSTRAINTS, reference.times()[rows[k]], state.apply(rows[k]), values, 0);
      open = Math.max(open, values[residual]);
      for (int i : multipliers) {
        double far = Math.abs(values[i] - expected[k][i]) / (1 + Math.abs(expected[k][i]));
        apart = far >= 0 ? Math.max(apart, far) : Double.POSITIVE_INFINITY;
      }
    }
    return new double[] {open, apart};
  }
}
