package org.mechservice.solver.force.formula;

import java.util.List;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.ParameterValue;
import org.mechservice.solver.expression.Expression.PathMotion;
import org.mechservice.solver.expression.Expression.StateValue;
import org.mechservice.solver.expression.Expression.Time;
import org.mechservice.solver.expression.FormulaEvaluation;
import org.mechservice.solver.force.applied.AppliedForce;
import org.mechservice.solver.force.applied.ScalarLaw;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.force.PathForce;

/** The tension of a {@link PathForce}, as a force that makes the path longer. */
public final class TensionLaw implements ScalarLaw {
  private final TreeMotion motion;
  private final FormulaEvaluation tension;
  private final List<Expression> leaves;
  private final int time;
  private final int length;
  private final int rate;
  private final int[] states;
  private final double[] gradient;
  private double velocity;

  /**
   * @throws IllegalArgumentException if the formula depends on anything but the motion of the path,
   *     time, parameters and further states
   */
  public TensionLaw(PathForce force, TreeMotion motion) {
    this.motion = motion;
    tension = new FormulaEvaluation(List.of(force.tension()));
    leaves = tension.leaves();
    for (Expression leaf : leaves) {
      if (!(leaf instanceof PathMotion)
          && !(leaf instanceof Time)
          && !(leaf instanceof ParameterValue)
          && !(leaf instanceof StateValue)) {
        throw new IllegalArgumentException("force " + force.name() + " depends on " + leaf);
      }
    }
    time = leaves.indexOf(new Time());
    length = leaves.indexOf(PathMotion.LENGTH);
    rate = leaves.indexOf(PathMotion.RATE);
    states = new int[motion.further.length];
    for (int i = 0; i < states.length; i++) {
      states[i] = leaves.indexOf(new StateValue(i));
    }
    gradient = new double[leaves.size()];
  }

  @Override
  public boolean parameters(double[] values, AppliedForce force) {
    for (int i = 0; i < leaves.size(); i++) {
      if (leaves.get(i) instanceof ParameterValue parameter) {
        tension.setLeaf(i, values[parameter.index()]);
      }
    }
    return true;
  }

  @Override
  public void at(double t) {
    if (time >= 0) {
      tension.setLeaf(time, t);
    }
  }

  @Override
  public double force(double x, double v) {
    velocity = v;
    if (length >= 0) {
      tension.setLeaf(length, x);
    }
    if (rate >= 0) {
      tension.setLeaf(rate, v);
    }
    for (int i = 0; i < states.length; i++) {
      if (states[i] >= 0) {
        tension.setLeaf(states[i], motion.further[i]);
      }
    }
    tension.derivatives();
    return -tension.value(0);
  }

  @Override
  public void slopes(double[] by) {
    tension.gradient(0, gradient);
    by[0] = length >= 0 ? -gradient[length] : 0;
    by[1] = rate >= 0 ? -gradient[rate] : 0;
  }

  @Override
  public double byState(int state) {
    if (states[state] < 0) {
      return 0;
    }
    tension.gradient(0, gradient);
    return -gradient[states[state]];
  }

  @Override
  public double potentialEnergy() {
    return 0;
  }

  @Override
  public double power() {
    return -tension.value(0) * velocity;
  }
}
