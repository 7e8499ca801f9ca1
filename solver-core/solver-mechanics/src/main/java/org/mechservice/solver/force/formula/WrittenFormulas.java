package org.mechservice.solver.force.formula;

import java.util.List;
import java.util.Optional;
import org.mechservice.solver.api.capability.Defects;
import org.mechservice.solver.api.run.Failure;

/** Generated code that evaluates the subexpressions of its forces' formulas. */
public interface WrittenFormulas extends Defects {
  /** Returns the lines of {@link ForceFormulas}. */
  String formulas();

  /** Returns the number of values. */
  int formulaCount();

  /**
   * Evaluates the subexpressions.
   *
   * @param t time, s
   * @param y state [q; v]; not modified
   * @param values overwritten
   */
  void formulaValues(double t, double[] y, double[] values);

  /** {@inheritDoc} Throws an exception, because formula evaluations do not set a defect. */
  @Override
  default Defect lastDefect() {
    throw new IllegalStateException("no evaluation has failed");
  }

  @Override
  default Optional<Defect> withoutValue(
      double t, double[] y, double[] yDot, List<Failure.Step> tried) {
    return SampleStates.search(
        formulas(),
        (time, state) -> {
          double[] values = new double[formulaCount()];
          formulaValues(time, state, values);
          return values;
        },
        t,
        y,
        yDot,
        tried);
  }
}
