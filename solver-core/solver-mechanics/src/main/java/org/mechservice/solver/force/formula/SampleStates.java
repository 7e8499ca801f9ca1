package org.mechservice.solver.force.formula;

import java.util.List;
import java.util.Optional;
import org.mechservice.solver.api.capability.Defects.Defect;
import org.mechservice.solver.api.run.Failure;

/** Looks after a failure for the force that caused it, where the last steps tried to go. */
public final class SampleStates {
  /** Differences for Jacobians move states by about this part. */
  private static final double MOVE = 1e-7;

  private final String lines;
  private final Evaluation formulas;
  private final List<Failure.Step> steps;

  private SampleStates(String lines, Evaluation formulas, List<Failure.Step> steps) {
    this.lines = lines;
    this.formulas = formulas;
    this.steps = steps;
  }

  /** Evaluates the parts of forces' formulas. */
  @FunctionalInterface
  public interface Evaluation {
    /**
     * Returns the values of the parts in one state.
     *
     * @param t time, s
     * @param y state [q; v]; not modified
     */
    double[] at(double t, double[] y);
  }

  /**
   * Looks at the state a run stands at, along the tangent as far as those steps went that did not
   * get to an error, and then at neighbours such as differences are taken at. If all forces have
   * values there, it may be a force that changes faster than the smallest step can follow, or one
   * that jumps or has a vertical slope between neighbours, so that the equations of an implicit
   * step have no solution.
   *
   * @param lines of {@link ForceFormulas}
   * @param t time the run stands at, s
   * @param y state there; its components are moved and put back
   * @param yDot its derivative; not modified
   * @param steps tried last
   */
  public static Optional<Defect> search(
      String lines,
      Evaluation formulas,
      double t,
      double[] y,
      double[] yDot,
      List<Failure.Step> steps) {
    return new SampleStates(lines, formulas, steps).search(t, y, yDot);
  }

  private Optional<Defect> search(double t, double[] y, double[] yDot) {
    double[] here = formulas.at(t, y);
    Optional<Defect> found = FormulaFinding.of(t, lines, here);
    boolean unfinished = false;
    for (int i = steps.size() - 1; i >= 0 && found.isEmpty(); i--) {
      Failure.Step step = steps.get(i);
      if (step.time() < t) {
        break;
      }
      double[] ahead = formulas.at(t + step.stepSize(), along(y, yDot, step.stepSize()));
      if (Double.isNaN(step.error())) {
        unfinished = true;
        found = FormulaFinding.of(t + step.stepSize(), lines, ahead);
      } else if (i == steps.size() - 1) {
        return FormulaFinding.tooFast(t, lines, here, ahead);
      }
    }
    for (int l = 0; unfinished && l < 2 * y.length && found.isEmpty(); l++) {
      double kept = y[l / 2];
      double move = MOVE * Math.max(1, Math.abs(kept));
      y[l / 2] += l % 2 == 0 ? move : -move;
      double[] beside = formulas.at(t, y);
      found = FormulaFinding.of(t, lines, beside);
      if (found.isEmpty() && steps.get(steps.size() - 1).result().equals(Failure.Step.UNSOLVED)) {
        found = FormulaFinding.tooSteep(t, lines, here, beside);
      }
      y[l / 2] = kept;
    }
    return found;
  }

  private static double[] along(double[] y, double[] yDot, double h) {
    double[] ahead = y.clone();
    for (int l = 0; l < y.length; l++) {
      ahead[l] += h * yDot[l];
    }
    return ahead;
  }
}
