package org.mechservice.solver.catalogue;

/** Severity of a message. */
public enum Severity {
  /** Information. */
  INFO,
  /** Probable mistake; the model is used, or the run continues, nevertheless. */
  WARNING,
  /** The model cannot be used, or the run or request has failed. */
  ERROR
}
