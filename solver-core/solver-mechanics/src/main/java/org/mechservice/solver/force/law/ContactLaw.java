package org.mechservice.solver.force.law;

import java.util.List;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.Argument;
import org.mechservice.solver.expression.Expression.ParameterValue;
import org.mechservice.solver.expression.Tape;
import org.mechservice.solver.expression.TapeEvaluation;
import org.mechservice.solver.force.applied.AppliedForce;
import org.mechservice.solver.force.applied.Coefficients;
import org.mechservice.solver.force.applied.FrameLaw;
import org.mechservice.solver.force.applied.FrameMotion;
import org.mechservice.solver.mechanism.force.Contact;

/**
 * Normal force and friction of a surface. Legend: (x, y, z) the centre in the surface's frame; d =
 * R + h(x) − z; N = k pos(d)ⁿ + c d′ pos′(d); (sx, sy) sliding velocity at the lowest point; p =
 * √(s² + v0²).
 */
public final class ContactLaw implements FrameLaw {
  private static final String[] NAMES = {
    "radius",
    "stiffness",
    "damping",
    "exponent",
    "smoothing",
    "friction coefficient",
    "friction speed"
  };
  private static final int RADIUS = 0;
  private static final int STIFFNESS = 1;
  private static final int DAMPING = 2;
  private static final int EXPONENT = 3;
  private static final int SMOOTHING = 4;
  private static final int FRICTION = 5;
  private static final int FRICTION_SPEED = 6;

  private final Coefficients coefficients;
  private final TapeEvaluation height;
  private double slope;
  private double bend;
  private double depth;
  private double depthRate;
  private double normal;
  private double normalByDepth;
  private double normalByRate;
  private final double[] slide = new double[2];
  private double root;
  private final double[] change = new double[6];

  public ContactLaw(Contact element) {
    coefficients =
        new Coefficients(
            element.name(),
            List.of(
                element.radius(),
                element.stiffness(),
                element.damping(),
                element.exponent(),
                element.smoothing(),
                element.friction(),
                element.frictionSpeed()));
    height = new TapeEvaluation(new Tape(List.of(element.height())));
    for (Expression leaf : height.tape().leaves()) {
      if (!(leaf instanceof ParameterValue || leaf instanceof Argument)) {
        throw new IllegalArgumentException(
            "the profile of contact "
                + element.name()
                + " may contain its argument and parameters but not "
                + leaf);
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
    List<Expression> leaves = height.tape().leaves();
    for (int i = 0; i < leaves.size(); i++) {
      if (leaves.get(i) instanceof ParameterValue parameter) {
        height.setLeaf(i, values[parameter.index()], 0, 0);
      }
    }
    return true;
  }

  @Override
  public boolean wrench(FrameMotion motion, double[] w, AppliedForce force) {
    if (!readHeight(motion.displacement[0], force)) {
      return false;
    }
    double radius = coefficients.at(RADIUS);
    double eps = coefficients.at(SMOOTHING);
    double n = coefficients.at(EXPONENT);
    double k = coefficients.at(STIFFNESS);
    double c = coefficients.at(DAMPING);
    depth = radius + height.value(0) - motion.displacement[2];
    depthRate = slope * motion.twist[3] - motion.twist[5];
    double positive = SmoothPositive.value(depth, eps);
    double positiveSlope = SmoothPositive.slope(depth, eps);
    normal = k * SmoothPositive.power(positive, n) + c * depthRate * positiveSlope;
    normalByDepth =
        k * n * SmoothPositive.power(positive, n - 1) * positiveSlope
            + c * depthRate * SmoothPositive.bend(depth, eps);
    normalByRate = c * positiveSlope;
    slide[0] = motion.twist[3] - radius * motion.twist[1];
    slide[1] = motion.twist[4] + radius * motion.twist[0];
    double speed = coefficients.at(FRICTION_SPEED);
    root = Math.sqrt(slide[0] * slide[0] + slide[1] * slide[1] + speed * speed);
    double fx = friction(0);
    double fy = friction(1);
    w[0] = radius * fy;
    w[1] = -radius * fx;
    w[2] = 0;
    w[3] = fx - normal * slope;
    w[4] = fy;
    w[5] = normal;
    return true;
  }

  private double friction(int i) {
    double coefficient = coefficients.at(FRICTION);
    return coefficient == 0 ? 0 : -coefficient * normal * (slide[i] / root);
  }

  private boolean readHeight(double x, AppliedForce force) {
    List<Expression> leaves = height.tape().leaves();
    for (int i = 0; i < leaves.size(); i++) {
      if (leaves.get(i) instanceof Argument) {
        height.setLeaf(i, x, 1, 0);
      }
    }
    height.derivatives();
    height.rates();
    slope = height.rate(0);
    bend = height.secondRate(0);
    double sum = height.value(0) + slope + bend;
    return Double.isFinite(sum)
        || force.notFinite("height of the profile, or its slope, at x = " + x + " m", sum);
  }

  @Override
  public void jacobian(FrameMotion motion, double[] byPlace, double[] byVelocity) {
    double radius = coefficients.at(RADIUS);
    double[] u = motion.twist;
    // by x, by z with the twist held
    column(byPlace, 3, normalByDepth * slope + normalByRate * bend * u[3], bend, 0, 0);
    column(byPlace, 5, -normalByDepth, 0, 0, 0);
    // by ωx, ωy, ux, uy, uz
    column(byVelocity, 0, 0, 0, 0, radius);
    column(byVelocity, 1, 0, 0, -radius, 0);
    column(byVelocity, 3, normalByRate * slope, 0, 1, 0);
    column(byVelocity, 4, 0, 0, 0, 1);
    column(byVelocity, 5, -normalByRate, 0, 0, 0);
  }

  /**
   * Writes the change of the wrench for a change of N, of the slope and of the sliding velocity.
   */
  private void column(double[] out, int j, double dN, double dSlope, double dsx, double dsy) {
    double coefficient = coefficients.at(FRICTION);
    double dfx = 0;
    double dfy = 0;
    if (coefficient != 0) {
      double along = (slide[0] * dsx + slide[1] * dsy) / root / root;
      dfx = -coefficient * (dN * slide[0] + normal * (dsx - slide[0] * along)) / root;
      dfy = -coefficient * (dN * slide[1] + normal * (dsy - slide[1] * along)) / root;
    }
    double radius = coefficients.at(RADIUS);
    change[0] = radius * dfy;
    change[1] = -radius * dfx;
    change[2] = 0;
    change[3] = dfx - dN * slope - normal * dSlope;
    change[4] = dfy;
    change[5] = dN;
    for (int i = 0; i < 6; i++) {
      out[6 * i + j] = change[i];
    }
  }

  @Override
  public double potentialEnergy(FrameMotion motion) {
    return coefficients.at(STIFFNESS)
        * SmoothPositive.integral(depth, coefficients.at(SMOOTHING), coefficients.at(EXPONENT));
  }

  @Override
  public double energyRate(FrameMotion motion) {
    double positive = SmoothPositive.value(depth, coefficients.at(SMOOTHING));
    return coefficients.at(STIFFNESS)
        * SmoothPositive.power(positive, coefficients.at(EXPONENT))
        * depthRate;
  }

  @Override
  public void values(FrameMotion motion, double[] out, int at) {
    out[at] = depth;
    out[at + 1] = normal;
    out[at + 2] = friction(0);
    out[at + 3] = friction(1);
  }
}
