package org.mechservice.solver.mechanism;

/**
 * A time at which a prescribed coordinate, or its velocity, jumps.
 *
 * @param joint name of the driven joint
 * @param origin where the joint was written down
 * @param velocity index of the coordinate among the driven ones of the tree, joints in file order;
 *     −1 if the joint is cut
 * @param ofPosition whether the coordinate itself jumps, which no mechanism can follow; if not, its
 *     velocity does
 * @param time of the jump, s, to one rounding unit
 * @param before value {@link #ahead} of it, rad or m, rad/s or m/s; may be infinite or no number
 * @param after value {@link #behind} it
 * @param roundedAway whether rounding leaves the velocity no value there, so that those before and
 *     after are from farther away; no mechanism can follow that
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

  /** Rounding units between the jump and a time surely beyond it. */
  private static final double MARGIN = 4;

  /** Returns the last time surely before the jump, s. */
  public double ahead() {
    return time - MARGIN * Math.ulp(time);
  }

  /** Returns the first time surely behind it, s. */
  public double behind() {
    return time + MARGIN * Math.ulp(time);
  }

  /** Returns by how much the coordinate or velocity jumps. */
  public double size() {
    return after - before;
  }
}
