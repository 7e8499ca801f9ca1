package org.mechservice.solver.kinematics.pair;

import java.util.List;
import org.mechservice.solver.spatial.Vector3;

/**
 * Visitor of the kinds of functions of the relative pose, for other representations such as
 * generated code. ρ is B's point from A's point and R the rotation of B, both in A's axes.
 *
 * @param <T> representation of a function
 */
public interface PairForms<T> {
  /** ρ · axis. */
  T displacement(Vector3 axis);

  /** β less a constant. */
  T axisCosine(AxisPair axes, double atZero);

  /** 2 Σ sign_k above_k / (1 + Σ below_k). */
  T tilt(List<AxisPair> above, List<Double> sign, List<AxisPair> below);

  /**
   * sense · atan2(sine, cosine), rad.
   *
   * @param sense 1 or −1
   */
  T turn(AxisPair sine, AxisPair cosine, double sense);

  /**
   * displacement − pitch · turn, to the nearest whole turn.
   *
   * @param pitch m/rad
   */
  T screwGap(T displacement, T turn, double pitch);

  /** (|ρ|² − d²) / (2d). */
  T distance(double d);

  /** A component of the relative angular velocity, which has no value as a position. */
  T angularVelocity(int axis);

  /** The velocity of the touching point of a wheel or ball in a direction. */
  T rollingContact(RollingShape shape, RollingShape.Direction direction);

  /**
   * The velocity of B's point along a vector fixed in B, which has no value as a position.
   *
   * @param side unit vector in B's axes
   */
  T edgeVelocity(Vector3 side);
}
