package org.mechservice.solver.force.law;

import java.util.Arrays;
import java.util.List;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.Argument;
import org.mechservice.solver.expression.Expression.ParameterValue;
import org.mechservice.solver.force.applied.AppliedForce;
import org.mechservice.solver.force.applied.Coefficients;
import org.mechservice.solver.force.applied.FrameLaw;
import org.mechservice.solver.force.applied.FrameMotion;
import org.mechservice.solver.mechanism.force.Contact;

/**
 * Push and friction of a surface at the closest point of each of its curves, summed up. Legend: R
 * the radius; (x, y, z) the centre in the surface's frame; d the depth; n = (−sin θ, 0, cos θ) the
 * normal and t = (cos θ, 0, sin θ) the tangent; (s, r) sliding velocity along t and y at the point
 * R below the centre along n; p = √(s² + r² + v0²).
 */
public final class ContactLaw implements FrameLaw {
  private static final String[] NAMES = {
    "radius",
    "stiffness",
    "damping",
    "dissipation",
    "exponent",
    "smoothing",
    "friction coefficient",
    "friction speed"
  };
  private static final int RADIUS = 0;
  private static final int STIFFNESS = 1;
  private static final int DAMPING = 2;
  private static final int DISSIPATION = 3;
  private static final int EXPONENT = 4;
  private static final int SMOOTHING = 5;
  private static final int FRICTION = 6;
  private static final int FRICTION_SPEED = 7;

  private final Coefficients coefficients;
  private final Touch[] touches;

  public ContactLaw(Contact element) {
    coefficients =
        new Coefficients(
            element.name(),
            List.of(
                element.radius(),
                element.stiffness(),
                element.damping(),
                element.dissipation(),
                element.exponent(),
                element.smoothing(),
                element.friction(),
                element.frictionSpeed()));
    boolean ofCentre = !element.tracks().isEmpty();
    List<Expression> curves = ofCentre ? element.tracks() : List.of(element.height());
    touches =
        curves.stream()
            .map(curve -> new Touch(new ClosestPoint(curve, ofCentre), ofCentre))
            .toArray(Touch[]::new);
    for (Touch touch : touches) {
      for (Expression leaf : touch.point.leaves()) {
        if (!(leaf instanceof ParameterValue || leaf instanceof Argument)) {
          throw new IllegalArgumentException(
              "the profile of contact "
                  + element.name()
                  + " may contain its argument and parameters but not "
                  + leaf);
        }
      }
    }
  }

  @Override
  public boolean parameters(double[] values, AppliedForce force) {
    int bad = coefficients.update(values);
    if (bad >= 0) {
      return force.refuse(NAMES[bad], coefficients.at(bad), "finite");
    }
    for (int i = 0; i < NAMES.length; i++) {
      if (coefficients.at(i) < 0) {
        return force.refuse(NAMES[i], coefficients.at(i), "zero or positive");
      }
    }
    if (coefficients.at(EXPONENT) < 1) {
      return force.refuse(NAMES[EXPONENT], coefficients.at(EXPONENT), "at least 1");
    }
    if (coefficients.at(FRICTION) > 0 && coefficients.at(FRICTION_SPEED) == 0) {
      return force.refuse(NAMES[FRICTION_SPEED], 0, "positive where there is friction");
    }
    for (Touch touch : touches) {
      touch.parameters(values);
    }
    return true;
  }

  @Override
  public boolean wrench(FrameMotion motion, double[] w, AppliedForce force) {
    Arrays.fill(w, 0);
    for (Touch touch : touches) {
      if (!touch.evaluate(motion, w, force)) {
        return false;
      }
    }
    return true;
  }

  @Override
  public void jacobian(FrameMotion motion, double[] byPlace, double[] byVelocity) {
    for (Touch touch : touches) {
      touch.jacobian(motion, byPlace, byVelocity);
    }
  }

  @Override
  public double potentialEnergy(FrameMotion motion) {
    double sum = 0;
    for (Touch touch : touches) {
      sum += touch.push.potentialEnergy(touch.depth);
    }
    return sum;
  }

  @Override
  public double energyRate(FrameMotion motion) {
    double sum = 0;
    for (Touch touch : touches) {
      sum += touch.push.elastic() * touch.depthRate;
    }
    return sum;
  }

  @Override
  public void values(FrameMotion motion, double[] out, int at) {
    out[at] = Double.NEGATIVE_INFINITY;
    for (int i = 1; i < 4; i++) {
      out[at + i] = 0;
    }
    for (Touch touch : touches) {
      out[at] = Math.max(out[at], touch.depth);
      out[at + 1] += touch.push.force();
      out[at + 2] += touch.friction(0);
      out[at + 3] += touch.friction(1);
    }
  }

  /** Push and friction at the closest point of one curve. */
  private final class Touch {
    private final ClosestPoint point;

    /** Whether the curve is that of the centre, else the surface. */
    private final boolean ofCentre;

    private final OneSidedLaw push = new OneSidedLaw();
    private double depth;
    private double depthRate;
    private final double[] slide = new double[2];
    private double root;
    private final double[] change = new double[6];

    Touch(ClosestPoint point, boolean ofCentre) {
      this.point = point;
      this.ofCentre = ofCentre;
    }

    void parameters(double[] values) {
      point.parameters(values);
      push.set(
          coefficients.at(STIFFNESS),
          coefficients.at(EXPONENT),
          coefficients.at(DAMPING),
          coefficients.at(DISSIPATION),
          coefficients.at(SMOOTHING));
    }

    boolean evaluate(FrameMotion motion, double[] w, AppliedForce force) {
      double radius = coefficients.at(RADIUS);
      double reach = ofCentre ? 0 : radius;
      double x = motion.displacement[0];
      if (!point.find(x, motion.displacement[2])) {
        return force.notFinite(
            "height of the profile, or its slope, at x = " + x + " m", Double.NaN);
      }
      double sine = point.sine();
      double cosine = point.cosine();
      double[] u = motion.twist;
      depth = reach - point.distance();
      depthRate = sine * u[3] - cosine * u[5];
      push.evaluate(depth, depthRate);
      slide[0] = cosine * u[3] + sine * u[5] - radius * u[1];
      slide[1] = u[4] + radius * (cosine * u[0] + sine * u[2]);
      double speed = coefficients.at(FRICTION_SPEED);
      root = Math.sqrt(slide[0] * slide[0] + slide[1] * slide[1] + speed * speed);
      double along = friction(0);
      double across = friction(1);
      w[0] += radius * cosine * across;
      w[1] -= radius * along;
      w[2] += radius * sine * across;
      w[3] += cosine * along - sine * push.force();
      w[4] += across;
      w[5] += sine * along + cosine * push.force();
      return true;
    }

    /** Returns the friction along t or along y, N. */
    double friction(int i) {
      double coefficient = coefficients.at(FRICTION);
      return coefficient == 0 ? 0 : -coefficient * push.force() * (slide[i] / root);
    }

    void jacobian(FrameMotion motion, double[] byPlace, double[] byVelocity) {
      double radius = coefficients.at(RADIUS);
      double sine = point.sine();
      double cosine = point.cosine();
      double[] u = motion.twist;
      double along = cosine * u[3] + sine * u[5];
      double towards = cosine * u[5] - sine * u[3];
      double across = radius * (cosine * u[2] - sine * u[0]);
      // by x, by z with the twist held: the normal turns by dθ
      for (int j = 3; j < 6; j += 2) {
        double turn = point.turning() * (j == 3 ? cosine : sine);
        double deeper = j == 3 ? sine : -cosine;
        double dN = push.byDepth() * deeper + push.byRate() * along * turn;
        column(byPlace, j, dN, turn, towards * turn, across * turn);
      }
      // by ωx, ωy, ωz, ux, uy, uz
      column(byVelocity, 0, 0, 0, 0, radius * cosine);
      column(byVelocity, 1, 0, 0, -radius, 0);
      column(byVelocity, 2, 0, 0, 0, radius * sine);
      column(byVelocity, 3, push.byRate() * sine, 0, cosine, 0);
      column(byVelocity, 4, 0, 0, 0, 1);
      column(byVelocity, 5, -push.byRate() * cosine, 0, sine, 0);
    }

    /** Adds the change of the wrench for a change of N, of θ and of the sliding velocity. */
    private void column(double[] out, int j, double dN, double turn, double ds, double dr) {
      double coefficient = coefficients.at(FRICTION);
      double along = friction(0);
      double across = friction(1);
      double dAlong = 0;
      double dAcross = 0;
      if (coefficient != 0) {
        double share = (slide[0] * ds + slide[1] * dr) / root / root;
        double normal = push.force();
        dAlong = -coefficient * (dN * slide[0] + normal * (ds - slide[0] * share)) / root;
        dAcross = -coefficient * (dN * slide[1] + normal * (dr - slide[1] * share)) / root;
      }
      double radius = coefficients.at(RADIUS);
      double sine = point.sine();
      double cosine = point.cosine();
      double normal = push.force();
      change[0] = radius * (cosine * dAcross - sine * across * turn);
      change[1] = -radius * dAlong;
      change[2] = radius * (sine * dAcross + cosine * across * turn);
      change[3] = cosine * dAlong - sine * along * turn - sine * dN - cosine * normal * turn;
      change[4] = dAcross;
      change[5] = sine * dAlong + cosine * along * turn + cosine * dN - sine * normal * turn;
      for (int i = 0; i < 6; i++) {
        out[6 * i + j] += change[i];
      }
    }
  }
}
