package org.mechservice.mechml.diagnosis;

/** Severity of a diagnostic. */
public enum Severity {
  /** Information. */
  INFO,
  /** A probable mistake; the model can be used. */
  WARNING,
  /** The model cannot be used. */
  ERROR
}
