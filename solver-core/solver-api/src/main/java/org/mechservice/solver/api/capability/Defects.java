package org.mechservice.solver.api.capability;

import java.util.List;
import java.util.Optional;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.catalogue.MessageCode;

/** A model that can say why it has no derivative or residual in a state. */
public interface Defects {
  /** Returned by an evaluation that failed for the reason {@link #lastDefect} gives. */
  int DEFECT = -2;

  /**
   * Returns why the last evaluation failed.
   *
   * @throws IllegalStateException if it did not
   */
  Defect lastDefect();

  /**
   * Returns what in the model may keep an integration from going on from the last accepted state: a
   * singular position of its loops, or a loop that does not close at the state last tried.
   */
  default Optional<Defect> obstacle() {
    return Optional.empty();
  }

  /**
   * Returns which force is given by a formula without a finite value where a run stands that has
   * failed, or where it tried to go: no evaluation looks for the root of a negative number, a
   * division by zero or an overflow.
   *
   * @param t time the run stands at, s
   * @param y state [q; v] there, perhaps with multipliers behind; may be changed and put back
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
   * @param part the joint, body, force or constraint it lies at
   * @param cause what is wrong, with numbers and units, in one sentence
   * @param advice what to do about it
   */
  record Defect(MessageCode code, String part, String cause, String advice) {}
}
