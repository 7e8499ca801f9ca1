package org.mechservice.solver.kinematics.pair;

import java.util.Arrays;
import java.util.List;
import org.mechservice.solver.spatial.Vector3;

/**
 * A smooth function of the pose of body B relative to body A, such as a joint's coordinate or
 * constraint. With δ = [δθ; δρ] the small rotation and displacement of B in A's axes, its change is
 * gradientᵀ δ; the gradient changes by C δ, C being the curvature.
 *
 * <p>The gradient is also the moment and force on B, at B's point in A's axes, of a unit multiplier
 * of the function; A feels the opposite.
 */
public abstract class PairFunction {
  private final String label;

  /** [by δθ; by δρ], 6 numbers, written by {@link #evaluate}. */
  public final double[] gradient = new double[6];

  private final double[] curvature = new double[36];
  private final double[] rate = new double[6];

  /**
   * @param label name of the measured quantity, for messages
   */
  PairFunction(String label) {
    this.label = label;
  }

  /**
   * Returns the displacement of B's point from A's along a vector fixed in A.
   *
   * @param axis unit vector in A's axes
   */
  public static PairFunction displacement(String label, Vector3 axis) {
    return new Displacement(label, axis);
  }

  /**
   * Returns the two displacements of B's point from a line through A's point, normal to the line.
   *
   * @param direction unit vector along the line, in A's axes
   */
  public static List<PairFunction> offLine(Vector3 direction) {
    Vector3 first = JointFunctions.normalTo(direction);
    return List.of(
        new Displacement("displacement across the line, first normal", first),
        new Displacement("displacement across the line, second normal", direction.cross(first)));
  }

  /** Returns (|ρ|² − d²) / (2d), m, which is zero if the distance of the points is d. */
  public static PairFunction distance(double d) {
    return new Distance(d);
  }

  /**
   * Returns the functions of a wheel or ball that rolls on a plane: its height, then the velocities
   * of its touching point along the plane.
   */
  public static List<PairFunction> rolling(RollingShape shape) {
    return Arrays.stream(RollingShape.Direction.values())
        .<PairFunction>map(direction -> new RollingContact(shape, direction))
        .toList();
  }

  /**
   * Returns the velocity of B's point along a vector fixed in B.
   *
   * @param side unit vector in B's axes
   */
  public static PairFunction edgeVelocity(Vector3 side) {
    return new EdgeVelocity("slip across the edge", side);
  }

  /**
   * Returns whether this is a function of the pose. Otherwise only its rate has a meaning,
   * gradientᵀ times the velocities; its value is zero, and its gradient is not the derivative of a
   * function (non-holonomic).
   */
  public boolean isHolonomic() {
    return true;
  }

  /** Returns the name of the measured quantity. */
  public final String label() {
    return label;
  }

  /** Returns another representation of the function. */
  public abstract <T> T as(PairForms<T> forms);

  /** Evaluates {@link #gradient} at a pose and returns the value, rad or m. */
  public abstract double evaluate(RelativeMotion r);

  /** Returns whether the function measures a displacement, in m; otherwise an angle, in rad. */
  public abstract boolean isLength();

  /**
   * As {@link #evaluate}, for poses far from those of the joint. Value and gradient equal those of
   * {@link #evaluate} to first order where the function is zero. In every other pose they are
   * finite, also at half a turn, and the gradient has the size it has there: the value is the
   * displacement or the rotation by which the pose must change, and the gradient maps small motions
   * to changes of it along the shortest way. Value times gradient, summed over the functions of a
   * joint, is the gradient of half the sum of the squares; so Gauss-Newton steps with it lead
   * downhill.
   *
   * @return the value, rad or m
   */
  public double evaluateFar(RelativeMotion r) {
    return evaluate(r);
  }

  /** Returns whether the curvature is zero in every pose. */
  boolean isStraight() {
    return false;
  }

  /**
   * Adds the curvature at the pose last evaluated.
   *
   * @param c 6 × 6 row by row, by [δθ; δρ]; added to
   */
  public abstract void addCurvature(RelativeMotion r, double factor, double[] c);

  /** Returns the difference of a value from a wanted one; for angles, to the nearest whole turn. */
  public double difference(double value, double wanted) {
    return value - wanted;
  }

  /** Returns the rate of change, after {@link #evaluate}. */
  public final double rate(RelativeMotion r) {
    double sum = 0;
    for (int i = 0; i < 3; i++) {
      sum += gradient[i] * r.angularVelocity[i] + gradient[3 + i] * r.velocity[i];
    }
    return sum;
  }

  /** Returns the second derivative by time, after {@link #evaluate}. */
  public final double acceleration(RelativeMotion r) {
    double sum = 0;
    for (int i = 0; i < 3; i++) {
      sum += gradient[i] * r.angularAcceleration[i] + gradient[3 + i] * r.acceleration[i];
      rate[i] = r.angularVelocity[i];
      rate[3 + i] = r.velocity[i];
    }
    if (isStraight()) {
      return sum;
    }
    Arrays.fill(curvature, 0);
    addCurvature(r, 1, curvature);
    for (int i = 0; i < 6; i++) {
      for (int j = 0; j < 6; j++) {
        sum += rate[i] * curvature[6 * i + j] * rate[j];
      }
    }
    return sum;
  }
}
