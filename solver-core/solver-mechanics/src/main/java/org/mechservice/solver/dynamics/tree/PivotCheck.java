package org.mechservice.solver.dynamics.tree;

import org.mechservice.solver.api.capability.ExplicitModel;

/**
 * Judges the pivots of a joint-space inertia, one per velocity, against the rigid body beyond the
 * joint. Below 64 units of rounding a pivot counts as zero; up to 1e-12 it is worth a warning.
 */
public final class PivotCheck {
  private static final double SINGULAR = 64 * Math.ulp(1.0);
  private static final double WEAK = 1e-12;

  private int weakest;
  private double smallest;

  public PivotCheck() {
    start();
  }

  public void start() {
    weakest = ExplicitModel.REGULAR;
    smallest = 1;
  }

  /**
   * Takes note of a pivot.
   *
   * @param velocity which velocity it belongs to
   * @param scale what it would be if nothing beyond could move
   * @return whether it differs from zero
   */
  public boolean regular(int velocity, double pivot, double scale) {
    if (pivot > WEAK * scale) {
      return true;
    }
    double ratio = pivot / scale;
    if (!(ratio >= smallest)) {
      smallest = ratio;
      weakest = velocity;
    }
    return pivot > SINGULAR * scale;
  }

  /**
   * Returns the velocity whose pivot was small enough in the last evaluation to cost twelve digits
   * or more, or {@link ExplicitModel#REGULAR}.
   */
  public int weakVelocity() {
    return weakest;
  }

  /** Returns how much smaller that pivot was than it should be: the digits it costs; 1 if none. */
  public double condition() {
    return 1 / smallest;
  }
}
