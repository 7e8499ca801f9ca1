package org.mechservice.library.proof;

/** What came of a scene. */
enum Verdict {
  /** All values are right. */
  RIGHT,
  /** A value is wrong, and a warning or a failure of the run says that something is. */
  TOLD,
  /** A value is wrong, and nothing is said. */
  SILENT
}
