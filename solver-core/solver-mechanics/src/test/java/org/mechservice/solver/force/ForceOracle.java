package org.mechservice.solver.force;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.RealMatrix;
import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.force.law.Side;
import org.mechservice.solver.mechanism.force.Bushing;
import org.mechservice.solver.mechanism.force.Contact;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.LawForce;
import org.mechservice.solver.mechanism.force.SpringDamper;
import org.mechservice.solver.oracle.OracleForce;
import org.mechservice.solver.oracle.TaylorPose;
import org.mechservice.solver.oracle.TaylorVector;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/** The forces between bodies once more, from their descriptions, in numbers and world axes. */
public final class ForceOracle {
  private ForceOracle() {}

  /** Returns the forces of a mechanism for the oracle. */
  public static List<OracleForce> of(List<ForceElement> elements) {
    List<OracleForce> forces = new ArrayList<>();
    for (ForceElement element : elements) {
      if (element instanceof SpringDamper spring) {
        forces.add((t, pose, loads) -> spring(spring, pose, loads));
      } else if (element instanceof Bushing bushing) {
        forces.add((t, pose, loads) -> bushing(bushing, pose, loads));
      } else if (element instanceof Contact contact) {
        forces.add((t, pose, loads) -> contact(contact, pose, loads));
      } else if (element instanceof LawForce law) {
        forces.add((t, pose, loads) -> law(law, pose, loads));
      } else {
        throw new IllegalArgumentException("the oracle does not know " + element);
      }
    }
    return forces;
  }

  private static double number(Expression value) {
    return ((Expression.Constant) value).value();
  }

  private static Vector3 way(BodyPoint p1, BodyPoint p2, IntFunction<TaylorPose> pose) {
    return line(p1, p2, pose).value();
  }

  private static TaylorVector line(BodyPoint p1, BodyPoint p2, IntFunction<TaylorPose> pose) {
    return pose.apply(p2.body()).at(p2.position()).minus(pose.apply(p1.body()).at(p1.position()));
  }

  private static void spring(
      SpringDamper s, IntFunction<TaylorPose> pose, OracleForce.Loads loads) {
    TaylorVector line = line(s.point1(), s.point2(), pose);
    double length = line.value().norm();
    Vector3 direction = line.value().times(1 / length);
    double rate = direction.dot(line.rate());
    double k = number(s.stiffness());
    double c = number(s.damping());
    double x = length - number(s.length0());
    double sign = s.side() == Side.BELOW ? -1 : 1;
    double tension =
        s.side() == Side.BOTH
            ? number(s.force0()) + k * x + c * rate
            : sign
                * push(
                    sign * x,
                    sign * rate,
                    new double[] {k, 1, c, number(s.dissipation()), number(s.smoothing())});
    loads.force(s.point1(), direction.times(tension));
    loads.force(s.point2(), direction.times(-tension));
  }

  /** max(0, E + D) with its rounded corner; {@code c} has k, n, c, χ and ε. */
  private static double push(double x, double rate, double[] c) {
    double root = Math.sqrt(x * x + c[4] * c[4]);
    double positive = (x + root) / 2;
    double slope = positive / root;
    double elastic = c[0] * Math.pow(positive, c[1]);
    double sum = elastic + c[2] * rate * slope + c[3] * rate * elastic;
    double r = 2 * sum / elastic;
    if (r >= 1 || r <= -1) {
      return Math.max(0, sum);
    }
    double polynomial = 63 - 122 * r + 102 * r * r - 42 * Math.pow(r, 3) + 7 * Math.pow(r, 4);
    return 0.5 * elastic * Math.pow(1 + r, 6) * polynomial / 512;
  }

  /** The relative motion of two frames, in the axes of frame 1. */
  private record Relative(Vector3 r, Rotation turn, Vector3 omega, Vector3 rate, Rotation axes1) {
    static Relative of(BodyFrame frame1, BodyFrame frame2, IntFunction<TaylorPose> pose) {
      TaylorPose body1 = pose.apply(frame1.body());
      TaylorPose body2 = pose.apply(frame2.body());
      TaylorVector line = line(frame1.origin(), frame2.origin(), pose);
      Rotation axes1 = body1.rotation().value().times(frame1.axes());
      Rotation axes2 = body2.rotation().value().times(frame2.axes());
      Vector3 omega1 = body1.rotation().angularVelocity();
      Vector3 omega = body2.rotation().angularVelocity().minus(omega1);
      Vector3 rate = line.rate().minus(omega1.cross(line.value()));
      Rotation back = axes1.transposed();
      return new Relative(
          back.apply(line.value()), back.times(axes2), back.apply(omega), back.apply(rate), axes1);
    }

    /** Adds a force and a moment on body 2, and the opposite on the same line to body 1. */
    void add(
        Vector3 force,
        Vector3 moment,
        BodyFrame frame1,
        BodyFrame frame2,
        OracleForce.Loads loads) {
      Vector3 f = axes1.apply(force);
      Vector3 m = axes1.apply(moment);
      loads.force(frame2.origin(), f);
      loads.moment(frame2.body(), m);
      loads.force(frame1.origin(), f.negated());
      loads.moment(frame1.body(), m.negated().minus(axes1.apply(r).cross(f)));
    }
  }

  /** The rotation vector from the angle and axis of a rotation matrix. */
  private static Vector3 rotationVector(Rotation r) {
    double angle = Math.acos(Math.max(-1, Math.min(1, (r.xx() + r.yy() + r.zz() - 1) / 2)));
    Vector3 axis = new Vector3(r.zy() - r.yz(), r.xz() - r.zx(), r.yx() - r.xy());
    return axis.times(angle / (2 * Math.sin(angle)));
  }

  /** B of φ′ = B ω: the inverse of Σ [φ]×ⁿ / (n + 1)!. */
  private static RealMatrix rates(Vector3 phi) {
    RealMatrix cross =
        new Array2DRowRealMatrix(
            new double[][] {
              {0, -phi.z(), phi.y()}, {phi.z(), 0, -phi.x()}, {-phi.y(), phi.x(), 0}
            });
    RealMatrix sum = MatrixUtils.createRealIdentityMatrix(3);
    RealMatrix term = sum;
    for (int n = 1; n < 60; n++) {
      term = term.multiply(cross).scalarMultiply(1.0 / (n + 1));
      sum = sum.add(term);
    }
    return new LUDecomposition(sum).getSolver().getInverse();
  }

  private static double[] numbers(Vector3 v) {
    return new double[] {v.x(), v.y(), v.z()};
  }

  private static void bushing(Bushing b, IntFunction<TaylorPose> pose, OracleForce.Loads loads) {
    Relative motion = Relative.of(b.frame1(), b.frame2(), pose);
    Vector3 phi = rotationVector(motion.turn());
    RealMatrix rates = rates(phi);
    boolean energy = b.law() == Bushing.Law.ENERGY;
    double[] omega = numbers(motion.omega());
    double[] turning = energy ? rates.operate(omega) : omega;
    double[] x = new double[6];
    double[] rate = new double[6];
    System.arraycopy(numbers(motion.r()), 0, x, 0, 3);
    System.arraycopy(numbers(phi), 0, x, 3, 3);
    System.arraycopy(numbers(motion.rate()), 0, rate, 0, 3);
    System.arraycopy(turning, 0, rate, 3, 3);
    double[] g = new double[6];
    for (int i = 0; i < 6; i++) {
      g[i] = number(b.preload().get(i));
      for (int k = 0; k < 6; k++) {
        g[i] -= number(b.stiffness().get(6 * i + k)) * x[k];
        g[i] -= number(b.damping().get(6 * i + k)) * rate[k];
      }
    }
    double[] conjugate = {g[3], g[4], g[5]};
    double[] m = energy ? rates.preMultiply(conjugate) : conjugate;
    motion.add(
        new Vector3(g[0], g[1], g[2]),
        new Vector3(m[0], m[1], m[2]),
        b.frame1(),
        b.frame2(),
        loads);
  }

  /** A sphere on the plane of frame 1, with friction at its lowest point. */
  private static void contact(Contact c, IntFunction<TaylorPose> pose, OracleForce.Loads loads) {
    if (!c.height().equals(Expression.ZERO)) {
      throw new IllegalArgumentException("the oracle knows planes alone");
    }
    BodyFrame sphere = new BodyFrame(c.center().body(), c.center().position(), Rotation.IDENTITY);
    Relative motion = Relative.of(c.surface(), sphere, pose);
    double radius = number(c.radius());
    Vector3 arm = new Vector3(0, 0, -radius);
    double normal =
        push(
            radius - motion.r().z(),
            -motion.rate().z(),
            new double[] {
              number(c.stiffness()),
              number(c.exponent()),
              number(c.damping()),
              number(c.dissipation()),
              number(c.smoothing())
            });
    Vector3 place = motion.rate().plus(motion.omega().cross(arm));
    double speed = Math.hypot(Math.hypot(place.x(), place.y()), number(c.frictionSpeed()));
    double share = -number(c.friction()) * normal / speed;
    Vector3 force = new Vector3(share * place.x(), share * place.y(), normal);
    motion.add(force, arm.cross(force), c.surface(), sphere, loads);
  }

  private static void law(LawForce f, IntFunction<TaylorPose> pose, OracleForce.Loads loads) {
    switch (f.law()) {
      case INVERSE_SQUARE -> {
        Vector3 way = way(f.frame1().origin(), f.frame2().origin(), pose);
        double soft = number(f.numbers().get(1));
        double distance = Math.sqrt(way.dot(way) + soft * soft);
        Vector3 force = way.times(-number(f.numbers().get(0)) / Math.pow(distance, 3));
        loads.force(f.frame2().origin(), force);
        loads.force(f.frame1().origin(), force.negated());
      }
      case ROTATION_FRICTION -> {
        Vector3 omega1 = pose.apply(f.frame1().body()).rotation().angularVelocity();
        Vector3 omega2 = pose.apply(f.frame2().body()).rotation().angularVelocity();
        Vector3 omega = omega2.minus(omega1);
        double speed = Math.hypot(omega.norm(), number(f.numbers().get(2)));
        double share = number(f.numbers().get(0)) + number(f.numbers().get(1)) / speed;
        loads.moment(f.frame2().body(), omega.times(-share));
        loads.moment(f.frame1().body(), omega.times(share));
      }
      default -> throw new IllegalArgumentException("the oracle does not know " + f.law());
    }
  }
}
