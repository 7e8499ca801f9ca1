package org.mechservice.solver.catalogue;

/** How much a message matters. */
public enum Severity {
  /** Worth knowing. */
  INFO,
  /** Probably not meant; the model is used, or the run goes on, all the same. */
  WARNING,
  /** The model cannot be used, or the run or request has failed. */
  ERROR
}
