package org.mechservice.solver.dynamics.tree;

import org.mechservice.solver.api.capability.ExplicitModel;

/**
 * Compares the pivots of a joint-space inertia, one per velocity, with the inertia of the rigid
 * body beyond the joint. A pivot below 64 rounding units of that inertia counts as zero; a pivot
 * below 1e-12 of it causes a warning.
 */
public final class PivotCheck {
  private static final double SINGULAR = 64 * Math.ulp(1.0);

  /** Part of the rigid body's inertia below which a pivot causes a warning. */
  public static final double WEAK = 1e-12;

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
   * Checks a pivot.
   *
   * @param velocity velocity of the pivot
   * @param scale value of the pivot if all joints beyond were locked
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
   * Returns the velocity whose pivot lost twelve digits or more in the last evaluation, or {@link
   * ExplicitModel#REGULAR}.
   */
  public int weakVelocity() {
    return weakest;
  }

  /** Returns the scale of that pivot divided by the pivot; 1 if there is none. */
  public double condition() {
    return 1 / smallest;
  }
}
