package org.mechservice.solver.api.run;

/** How a run ended. */
public sealed interface Outcome {
  /** The end of the interval was reached. */
  record Completed() implements Outcome {}

  /** Somebody asked the run to stop; the rows up to then are valid. */
  record Stopped() implements Outcome {}

  /**
   * The run could not go on; the rows up to then are valid.
   *
   * @param failure why
   */
  record Failed(Failure failure) implements Outcome {}
}
