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
 * @param time first time behind the jump, s
 * @param before value at the last time before it, rad or m, rad/s or m/s; may be infinite or no
 *     number
 * @param after value at {@code time}
 */
public record MotionJump(
    String joint,
    Origin origin,
    int velocity,
    boolean ofPosition,
    double time,
    double before,
    double after) {

  /** Returns by how much the coordinate or velocity jumps. */
  public double size() {
    return after - before;
  }
}
