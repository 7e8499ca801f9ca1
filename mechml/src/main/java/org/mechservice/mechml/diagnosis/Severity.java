package org.mechservice.mechml.diagnosis;

/** How much a diagnostic matters. */
public enum Severity {
  /** Worth knowing. */
  INFO,
  /** Probably not meant; the model is used all the same. */
  WARNING,
  /** The model cannot be used. */
  ERROR
}
