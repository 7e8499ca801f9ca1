package org.mechservice.solver.api.run;

/** The outcome of a run. */
public sealed interface Outcome {
  /** The end of the interval was reached. */
  record Completed() implements Outcome {}

  /** The run was stopped on request; the rows up to then are valid. */
  record Stopped() implements Outcome {}

  /**
   * The run could not continue; the rows up to then are valid.
   *
   * @param failure the reason
   */
  record Failed(Failure failure) implements Outcome {}
}
