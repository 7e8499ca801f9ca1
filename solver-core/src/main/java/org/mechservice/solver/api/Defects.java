package org.mechservice.solver.api;

import java.util.Optional;

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
   * Why a model cannot be evaluated.
   *
   * @param code entry of the error catalogue, such as {@code N-030}
   * @param part the joint, body, force or constraint it lies at
   * @param cause what is wrong, with numbers and units, in one sentence
   * @param advice what to do about it
   */
  record Defect(String code, String part, String cause, String advice) {}
}
