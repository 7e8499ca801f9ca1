package org.mechservice.solver.force.formula;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.mechservice.solver.api.capability.Defects.Defect;
import org.mechservice.solver.api.run.Failure;

/** Finds, after a failure, the force that caused it, near the last attempted steps. */
public final class SampleStates {
  /** Relative change of a component, as in difference quotients for Jacobians. */
  private static final double MOVE = 1e-7;

  /** Lengths of steps over the shortest that failed, within which nothing smooth changes much. */
  private static final double BESIDE = 100;

  /** Relative distance in time of a state just behind a jump. */
  private static final double JUST_AFTER = 1e-9;

  private final String lines;
  private final Evaluation formulas;
  private final List<Failure.Step> steps;

  private SampleStates(String lines, Evaluation formulas, List<Failure.Step> steps) {
    this.lines = lines;
    this.formulas = formulas;
    this.steps = steps;
  }

  /** Evaluates the subexpressions of forces' formulas. */
  @FunctionalInterface
  public interface Evaluation {
    /**
     * Returns the values of the subexpressions at one state.
     *
     * @param t time, s
     * @param y state [q; v]; not modified
     */
    double[] at(double t, double[] y);
  }

  /**
   * Checks the last state of a run, states along the tangent at the lengths of the attempted steps,
   * and neighbouring states such as difference quotients use. If all forces have values there, it
   * looks for a force that changes faster than the shortest step can follow, and for one that jumps
   * or is vertical between neighbouring states, so that the equations of an implicit step have no
   * solution. If no step was tried from the last state, as after a jump, it looks just behind it.
   *
   * @param lines of {@link ForceFormulas}
   * @param t time that the run has reached, s
   * @param y state there; its components are changed and restored
   * @param yDot its derivative; not modified
   * @param steps lengths of the last attempted steps
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
    boolean tried = false;
    for (int i = steps.size() - 1; i >= 0 && found.isEmpty(); i--) {
      Failure.Step step = steps.get(i);
      if (step.time() < t) {
        break;
      }
      tried = true;
      double[] ahead = formulas.at(t + step.stepSize(), along(y, yDot, step.stepSize()));
      if (Double.isNaN(step.error())) {
        unfinished = true;
        found = FormulaFinding.of(t + step.stepSize(), lines, ahead);
      } else if (i == steps.size() - 1) {
        return FormulaFinding.tooFast(t, lines, here, ahead);
      }
    }
    if (found.isEmpty() && !unfinished) {
      found = acrossRejected(t, y, yDot, here);
    }
    if (!tried && found.isEmpty()) {
      double after = t + JUST_AFTER * Math.max(1, Math.abs(t));
      found = FormulaFinding.of(after, lines, formulas.at(after, y));
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

  /**
   * Looks as far ahead as the shortest steps that failed the error test: a solution that slides
   * along a jump ends beside it, after a step that passed.
   */
  private Optional<Defect> acrossRejected(double t, double[] y, double[] yDot, double[] here) {
    double[] lengths =
        steps.stream()
            .filter(step -> step.error() > 1)
            .mapToDouble(Failure.Step::stepSize)
            .boxed()
            .sorted(Comparator.comparingDouble(Math::abs))
            .mapToDouble(Double::doubleValue)
            .toArray();
    Optional<Defect> found = Optional.empty();
    for (int i = 0; i < lengths.length && found.isEmpty(); i++) {
      if (Math.abs(lengths[i]) <= BESIDE * Math.abs(lengths[0])) {
        double[] ahead = formulas.at(t + lengths[i], along(y, yDot, lengths[i]));
        found = FormulaFinding.jump(t, lines, here, ahead);
      }
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
