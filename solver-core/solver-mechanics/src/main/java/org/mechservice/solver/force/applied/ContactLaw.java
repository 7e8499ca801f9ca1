package org.mechservice.solver.force.applied;

import java.util.Arrays;
import java.util.List;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.Argument;
import org.mechservice.solver.expression.Expression.ParameterValue;
import org.mechservice.solver.force.law.ClosestPoint;
import org.mechservice.solver.force.law.PairLaw;
import org.mechservice.solver.mechanism.force.Contact;

/** The law of a contact at the closest point of each of its curves, summed up. */
public final class ContactLaw implements FrameLaw {
  private static final int VALUES = 4;

  private final Coefficients coefficients;
  private final Touch[] touches;
  private double[] x = {};

  /**
   * @throws IllegalArgumentException if a coefficient depends on time or the state, or a curve on
   *     anything but its argument and parameters
   */
  public ContactLaw(Contact element) {
    coefficients = new Coefficients(element);
    List<Expression> curves =
        element.tracks().isEmpty() ? List.of(element.height()) : element.tracks();
    touches =
        curves.stream()
            .map(curve -> new Touch(element.pairLaw(), new ClosestPoint(curve)))
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
    for (Touch touch : touches) {
      if (!touch.law.update(coefficients, values, force)) {
        return false;
      }
      touch.point.parameters(values);
    }
    return true;
  }

  @Override
  public boolean wrench(FrameMotion motion, double[] w, AppliedForce force) {
    x = motion.x;
    Arrays.fill(w, 0);
    for (Touch touch : touches) {
      if (!touch.point.find(x[0], x[2])) {
        return force.notFinite(
            "height of the profile, or its slope, at x = " + x[0] + " m", Double.NaN);
      }
      touch.point.curve(touch.law.coefficients(), PairLaw.FOOT);
      touch.law.load(x, touch.load);
      for (int i = 0; i < w.length; i++) {
        w[i] += touch.load[i];
      }
    }
    return true;
  }

  @Override
  public void slopes(FrameMotion motion, double[] by) {
    for (Touch touch : touches) {
      touch.law.slopes(x, touch.slopes);
      for (int i = 0; i < by.length; i++) {
        by[i] += touch.slopes[i];
      }
    }
  }

  private double sum(int result) {
    double sum = 0;
    for (Touch touch : touches) {
      touch.law.results(x, touch.results);
      sum += touch.results[result];
    }
    return sum;
  }

  @Override
  public double potentialEnergy() {
    return sum(PairLaw.POTENTIAL);
  }

  @Override
  public double power(FrameMotion motion, double[] w) {
    return sum(PairLaw.POWER);
  }

  /** {@inheritDoc} The penetration of the deepest touch, and sums of the others. */
  @Override
  public void values(FrameMotion motion, double[] out, int at) {
    out[at] = Double.NEGATIVE_INFINITY;
    for (int i = 1; i < VALUES; i++) {
      out[at + i] = sum(PairLaw.VALUES + i);
    }
    for (Touch touch : touches) {
      out[at] = Math.max(out[at], touch.results[PairLaw.VALUES]);
    }
  }

  /** The contact at one curve. */
  private static final class Touch {
    final ClosestPoint point;
    final SettledLaw law;
    final double[] load = new double[PairLaw.DIRECTION + 1];
    final double[] slopes = new double[72];
    final double[] results = new double[PairLaw.VALUES + VALUES];

    Touch(PairLaw law, ClosestPoint point) {
      this.point = point;
      this.law = SettledLaw.of(law);
    }
  }
}
