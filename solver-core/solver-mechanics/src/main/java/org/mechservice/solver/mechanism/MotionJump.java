package org.mechservice.solver.mechanism;

import org.mechservice.solver.text.Origin;

/**
 * A time at which a prescribed coordinate, or its velocity, jumps.
 *
 * @param joint name of the driven joint
 * @param origin position of the joint in the model file
 * @param velocity index of the coordinate among the driven ones of the tree, joints in file order;
 *     −1 if the joint is cut
 * @param ofPosition whether the coordinate jumps, which no mechanism can follow; otherwise its
 *     velocity jumps
 * @param time of the jump, s, to one unit in the last place
 * @param before value at {@link #ahead}, rad or m, rad/s or m/s; may be infinite or NaN
 * @param after value at {@link #behind}
 * @param roundedAway whether rounding destroys the velocity near the jump, so that {@code before}
 *     and {@code after} are taken farther away; no mechanism can follow such a motion
 */
public record MotionJump(
    String joint,
    Origin origin,
    int velocity,
    boolean ofPosition,
    double time,
    double before,
    double after,
    boolean roundedAway) {

  /** Units in the last place between the jump and a time certainly before or after it. */
  private static final double MARGIN = 4;

  /** Returns the last time certainly before the jump, s. */
  public double ahead() {
    return time - MARGIN * Math.ulp(time);
  }

  /** Returns the first time certainly after the jump, s. */
  public double behind() {
    return time + MARGIN * Math.ulp(time);
  }

  /** Returns the size of the jump. */
  public double size() {
    return after - before;
  }
}
