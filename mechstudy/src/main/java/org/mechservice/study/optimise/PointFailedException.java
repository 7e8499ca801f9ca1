package org.mechservice.study.optimise;

/** The quantities of a problem cannot be computed at one point. */
public final class PointFailedException extends Exception {
  private static final long serialVersionUID = 1L;

  /**
   * @param message why, with the code of the run's failure where it has one
   */
  public PointFailedException(String message) {
    super(message);
  }
}
