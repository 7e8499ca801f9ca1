package org.mechservice.solver.api.capability;

import java.util.List;
import java.util.Optional;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.catalogue.MessageCode;

/** A model that gives the reason why it has no derivative or residual at a state. */
public interface Defects {
  /** Result of an evaluation that failed; {@link #lastDefect} gives the reason. */
  int DEFECT = -2;

  /**
   * Returns why the last evaluation failed.
   *
   * @throws IllegalStateException if it did not
   */
  Defect lastDefect();

  /**
   * Returns the reason in the model why an integration cannot continue from the last accepted
   * state: a singular position of its loops, or a loop that does not close at the last attempted
   * state.
   */
  default Optional<Defect> obstacle() {
    return Optional.empty();
  }

  /**
   * Returns the force whose formula has no finite value near the last state of a failed run.
   * Evaluations do not check for the root of a negative number, a division by zero or an overflow.
   *
   * @param t time that the run has reached, s
   * @param y state [q; v] there, possibly followed by multipliers; may be changed and restored
   * @param yDot its derivative; not used if no step was tried; not modified
   * @param tried the last steps
   */
  default Optional<Defect> withoutValue(
      double t, double[] y, double[] yDot, List<Failure.Step> tried) {
    return Optional.empty();
  }

  /**
   * Why a model cannot be evaluated.
   *
   * @param code entry of the error catalogue, such as {@code N-030}
   * @param part the joint, body, force or constraint concerned
   * @param cause the cause in one sentence, with numbers and units
   * @param advice the remedy
   */
  record Defect(MessageCode code, String part, String cause, String advice) {}
}
