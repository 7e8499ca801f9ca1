package org.mechservice.solver.kinematics.pair;

import static org.mechservice.solver.spatial.Blocks.apply;
import static org.mechservice.solver.spatial.Blocks.cross;
import static org.mechservice.solver.spatial.Blocks.dot;

import org.mechservice.solver.spatial.Vector3;

/**
 * The velocity, in one direction, of the point of a wheel or ball that touches a plane of body A
 * with normal n. With the axle e = R e_B, c = n · e and s = √(1 − c²), the touching point lies at a
 * = −radius u − tube n from the centre, where u = (n − c e) / s, and the wheel's track has the
 * direction e × n / s. The velocity along t is t · (ρ' + ω × a), so that the gradient is [a × t;
 * t]. Along n it is the derivative of the height
 *
 * <pre>h = n · ρ − radius s − tube,</pre>
 *
 * <p>along the tangents it is not the derivative of a function of the pose. A wheel that lies flat
 * (s = 0) touches the plane everywhere and has no such equations.
 */
final class RollingContact extends PairFunction {
  private final RollingShape shape;
  private final RollingShape.Direction direction;
  private final double[] normal;
  private final double[] axleInB;
  private final boolean isWheel;

  /** e, e × n, u and the touching point a, in A's axes. */
  private final double[] axle = new double[3];

  private final double[] track = new double[3];
  private final double[] up = new double[3];
  private final double[] arm = new double[3];

  /** A direction in the plane. */
  private final double[] anyDiameter;

  /** t. */
  private final double[] along = new double[3];

  private double c;
  private double s = 1;

  /** Derivatives of u, a and t by small rotations, 3 × 3. */
  private final double[] ofUp = new double[9];

  private final double[] ofAlong = new double[9];
  private final double[] ofTrack = new double[9];

  RollingContact(RollingShape shape, RollingShape.Direction direction) {
    super(direction.label);
    this.shape = shape;
    this.direction = direction;
    Vector3 n = shape.normal();
    normal = components(n);
    anyDiameter = components(JointFunctions.normalTo(n));
    isWheel = !shape.isBall();
    axleInB = components(shape.axle());
    Vector3 first = shape.tangent();
    Vector3 fixed =
        switch (direction) {
          case OFF -> n;
          case ALONG -> first;
          case ACROSS -> n.cross(first);
        };
    System.arraycopy(components(fixed), 0, along, 0, 3);
    System.arraycopy(along, 0, gradient, 3, 3);
  }

  private static double[] components(Vector3 v) {
    return new double[] {v.x(), v.y(), v.z()};
  }

  @Override
  public <T> T as(PairForms<T> forms) {
    return forms.rollingContact(shape, direction);
  }

  @Override
  public boolean isHolonomic() {
    return direction == RollingShape.Direction.OFF;
  }

  @Override
  public boolean isLength() {
    return true;
  }

  @Override
  public double evaluate(RelativeMotion r) {
    if (isWheel) {
      placeWheel(r);
    } else {
      for (int i = 0; i < 3; i++) {
        arm[i] = -shape.radius() * normal[i];
      }
    }
    return height(r);
  }

  /** {@inheritDoc} A wheel that lies flat is raised about any diameter. */
  @Override
  public double evaluateFar(RelativeMotion r) {
    double height = evaluate(r);
    if (s > 0) {
      return height;
    }
    System.arraycopy(anyDiameter, 0, track, 0, 3);
    cross(track, 0, axle, 0, up, 0);
    finishWheel(1);
    return height(r);
  }

  private double height(RelativeMotion r) {
    cross(arm, 0, along, 0, gradient, 0);
    System.arraycopy(along, 0, gradient, 3, 3);
    if (!isHolonomic()) {
      return 0;
    }
    double height = dot(normal, 0, r.position, 0);
    return isWheel ? height - shape.radius() * s - shape.tube() : height - shape.radius();
  }

  private void placeWheel(RelativeMotion r) {
    apply(r.rotation, 0, axleInB, 0, axle, 0);
    c = dot(normal, 0, axle, 0);
    cross(axle, 0, normal, 0, track, 0);
    s = Math.sqrt(dot(track, 0, track, 0));
    for (int i = 0; i < 3; i++) {
      up[i] = (normal[i] - c * axle[i]) / s;
    }
    finishWheel(s);
  }

  /**
   * Forms the touching point and t.
   *
   * @param length of {@link #track}
   */
  private void finishWheel(double length) {
    for (int i = 0; i < 3; i++) {
      arm[i] = -shape.radius() * up[i] - shape.tube() * normal[i];
    }
    if (direction == RollingShape.Direction.ALONG) {
      for (int i = 0; i < 3; i++) {
        along[i] = track[i] / length;
      }
    } else if (direction == RollingShape.Direction.ACROSS) {
      cross(normal, 0, track, 0, along, 0);
      for (int i = 0; i < 3; i++) {
        along[i] /= length;
      }
    }
  }

  /** Adds [δ(a × t); δt] = [a × δt − t × δa; δt], with δa = −radius δu. */
  @Override
  public void addCurvature(RelativeMotion r, double factor, double[] curvature) {
    if (!isWheel) {
      return;
    }
    differentiateUp();
    differentiateAlong();
    for (int j = 0; j < 3; j++) {
      for (int i = 0; i < 3; i++) {
        int next = (i + 1) % 3;
        int last = (i + 2) % 3;
        double moment =
            arm[next] * ofAlong[3 * last + j]
                - arm[last] * ofAlong[3 * next + j]
                + shape.radius()
                    * (along[next] * ofUp[3 * last + j] - along[last] * ofUp[3 * next + j]);
        curvature[6 * i + j] += factor * moment;
        curvature[6 * (3 + i) + j] += factor * ofAlong[3 * i + j];
      }
    }
  }

  /** δu = −(e δc + c δe) / s + u c δc / s², with δe = δθ × e and δc = (e × n) · δθ. */
  private void differentiateUp() {
    turned(axle, ofUp);
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        int at = 3 * i + j;
        ofUp[at] = -(axle[i] * track[j] + c * ofUp[at]) / s + up[i] * c * track[j] / (s * s);
      }
    }
  }

  /** δ(k/s) = (δe × n) / s + k c (k · δθ) / s³ with k = e × n; across the track n × that. */
  private void differentiateAlong() {
    if (direction == RollingShape.Direction.OFF) {
      return;
    }
    turned(axle, ofTrack);
    for (int j = 0; j < 3; j++) {
      for (int i = 0; i < 3; i++) {
        int next = (i + 1) % 3;
        int last = (i + 2) % 3;
        double turn = ofTrack[3 * next + j] * normal[last] - ofTrack[3 * last + j] * normal[next];
        ofAlong[3 * i + j] = turn / s + track[i] * c * track[j] / (s * s * s);
      }
    }
    if (direction == RollingShape.Direction.ACROSS) {
      System.arraycopy(ofAlong, 0, ofTrack, 0, 9);
      for (int j = 0; j < 3; j++) {
        for (int i = 0; i < 3; i++) {
          int next = (i + 1) % 3;
          int last = (i + 2) % 3;
          ofAlong[3 * i + j] =
              normal[next] * ofTrack[3 * last + j] - normal[last] * ofTrack[3 * next + j];
        }
      }
    }
  }

  /** Writes the derivative of a vector that turns with B: δv = δθ × v. */
  private static void turned(double[] v, double[] byTurn) {
    byTurn[0] = 0;
    byTurn[1] = v[2];
    byTurn[2] = -v[1];
    byTurn[3] = -v[2];
    byTurn[4] = 0;
    byTurn[5] = v[0];
    byTurn[6] = v[1];
    byTurn[7] = -v[0];
    byTurn[8] = 0;
  }
}
