package org.mechservice.solver.step;

/**
 * The layout of the wrench that a multiplier of a loop equation exerts, while it is carried from a
 * link to its parent.
 */
public final class CarriedWrench {
  /** K as the link feels it, 6: moment, force, in its computing frame. */
  public static final int BEFORE = 0;

  /**
   * The force of the multiplier on the joint itself along each degree of freedom, then kappa, its
   * whole component along it: 3.
   */
  public static final int ALONG = BEFORE + 6;

  /** K as the parent feels it, 6. */
  public static final int AFTER = ALONG + 3;

  /** How many numbers there are. */
  public static final int SIZE = AFTER + 6;

  private CarriedWrench() {}
}
