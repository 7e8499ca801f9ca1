package org.mechservice.solver.ode.switching;

import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.backward.BackwardFormulas;
import org.mechservice.solver.ode.step.ErrorNorm;

/**
 * Whether steps of a backward formula would pass, from where an Adams method has been lately.
 *
 * <p>Where stability limits its steps, an Adams method knows nothing of longer ones: its
 * differences hold what is left of the fast motion, which the tolerance does not see. Over several
 * of its steps that is small against the motion to be followed. So the places are kept that it came
 * to every third step, and every sixth, and divided differences over them stand for derivatives: in
 * a step h a formula of order k errs by C_k (k + 1)! h^{k+1} y[t_0, …, t_{k+1}]; {@link
 * BackwardFormulas}. With what is left of the fast motion, up to the tolerance, steps of some two
 * of the distances between places can still pass, so the narrow places tell soon whether implicit
 * steps would be longer, and if they cannot, the wide ones do.
 */
final class StepForecast {
  private static final int NARROW = 3;
  private static final int WIDE = 6;

  private final SampledHistory narrow = new SampledHistory(NARROW);
  private final SampledHistory wide = new SampledHistory(WIDE);

  /**
   * @param interval length of the problem
   */
  void prepare(int dimension, double interval) {
    narrow.prepare(dimension, interval);
    wide.prepare(dimension, interval);
  }

  /** Forgets all places. */
  void begin() {
    narrow.begin();
    wide.begin();
  }

  /** Takes note of a step of the Adams method; returns whether that makes a new forecast. */
  boolean record(double t, double[] y) {
    wide.record(t, y);
    return narrow.record(t, y);
  }

  /** Returns the mean length of the latest steps; 0 before there are six. */
  double meanStep() {
    return narrow.meanStep();
  }

  /** Returns whether one of the formulas would pass with a step of size h. */
  boolean passes(double h, BackwardFormulas formulas, ErrorNorm norm) {
    return passes(narrow, h, formulas, norm) || passes(wide, h, formulas, norm);
  }

  private static boolean passes(
      SampledHistory places, double h, BackwardFormulas formulas, ErrorNorm norm) {
    double size = h / places.unit();
    double factor = size;
    for (int k = 1; k < places.count() - 1; k++) {
      factor *= (k + 1) * size;
      double[] derivative = places.difference(k + 1);
      if (formulas.errorConstant(k) * factor * norm.of(derivative) <= 1) {
        return true;
      }
    }
    return false;
  }

  /** Carries the places over. */
  void transfer(SavedState state) {
    narrow.transfer(state);
    wide.transfer(state);
  }
}
