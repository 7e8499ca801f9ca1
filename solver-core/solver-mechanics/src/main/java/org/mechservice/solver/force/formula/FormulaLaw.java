package org.mechservice.solver.force.formula;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.ParameterValue;
import org.mechservice.solver.expression.Expression.RelativeMotion;
import org.mechservice.solver.expression.Expression.StateValue;
import org.mechservice.solver.expression.FormulaEvaluation;
import org.mechservice.solver.force.applied.AppliedForce;
import org.mechservice.solver.force.applied.FrameLaw;
import org.mechservice.solver.force.applied.FrameMotion;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.force.PairForce;

/**
 * The formulas of a {@link PairForce}: its wrench and energy in one evaluation, whose derivatives
 * by the components of the relative motion give the Jacobian; its output values in another.
 */
public final class FormulaLaw implements FrameLaw {
  private static final int POTENTIAL = 6;
  private static final int POTENTIAL_RATE = 7;

  private final TreeMotion motion;
  private final FormulaEvaluation law;
  private final FormulaEvaluation outputs;
  private final int outputCount;
  private final double[][] gradients = new double[6][];
  private final double[] place = new double[6];

  /**
   * @throws IllegalArgumentException if a formula depends on anything but the relative motion of
   *     the force's frames, further states, parameters and time
   */
  public FormulaLaw(PairForce force, TreeMotion motion) {
    this.motion = motion;
    List<Expression> formulas = new ArrayList<>(force.wrench());
    formulas.add(force.potential());
    formulas.add(force.potentialRate());
    law = new FormulaEvaluation(formulas);
    outputs =
        new FormulaEvaluation(force.outputs().stream().map(PairForce.Value::expression).toList());
    outputCount = force.outputs().size();
    for (FormulaEvaluation evaluation : List.of(law, outputs)) {
      for (Expression leaf : evaluation.leaves()) {
        boolean own =
            leaf instanceof RelativeMotion relative
                && relative.frame1().equals(force.frame1())
                && relative.frame2().equals(force.frame2());
        if (!own && !(leaf instanceof StateValue) && !(leaf instanceof ParameterValue)) {
          throw new IllegalArgumentException("force " + force.name() + " depends on " + leaf);
        }
      }
    }
    for (int i = 0; i < gradients.length; i++) {
      gradients[i] = new double[law.leaves().size()];
    }
  }

  @Override
  public boolean parameters(double[] values, AppliedForce force) {
    for (FormulaEvaluation formulas : List.of(law, outputs)) {
      List<Expression> leaves = formulas.leaves();
      for (int i = 0; i < leaves.size(); i++) {
        if (leaves.get(i) instanceof ParameterValue parameter) {
          formulas.setLeaf(i, values[parameter.index()]);
        }
      }
    }
    return true;
  }

  private void read(FormulaEvaluation formulas, FrameMotion x) {
    List<Expression> leaves = formulas.leaves();
    for (int i = 0; i < leaves.size(); i++) {
      if (leaves.get(i) instanceof RelativeMotion relative) {
        formulas.setLeaf(i, x.component(relative.component()));
      } else if (leaves.get(i) instanceof StateValue state) {
        formulas.setLeaf(i, motion.further[state.index()]);
      }
    }
  }

  @Override
  public boolean wrench(FrameMotion x, double[] w, AppliedForce force) {
    read(law, x);
    law.values();
    for (int i = 0; i < 6; i++) {
      w[i] = law.value(i);
    }
    return true;
  }

  @Override
  public void slopes(FrameMotion x, double[] by) {
    differentiate();
    List<Expression> leaves = law.leaves();
    for (int leaf = 0; leaf < leaves.size(); leaf++) {
      if (!(leaves.get(leaf) instanceof RelativeMotion relative)) {
        continue;
      }
      int ofTwist = relative.component() - RelativeMotion.ANGULAR_VELOCITY;
      for (int j = 0; j < 6; j++) {
        double change = j == ofTwist ? 1 : 0;
        if (ofTwist < 0) {
          Arrays.fill(place, 0);
          place[j] = 1;
          change = x.changeOf(relative.component(), place);
        }
        if (change != 0) {
          int first = ofTwist < 0 ? 0 : 36;
          for (int i = 0; i < 6; i++) {
            by[first + 6 * i + j] += gradients[i][leaf] * change;
          }
        }
      }
    }
  }

  private void differentiate() {
    law.derivatives();
    for (int i = 0; i < gradients.length; i++) {
      law.gradient(i, gradients[i]);
    }
  }

  @Override
  public boolean byState(int state, double[] w) {
    List<Expression> leaves = law.leaves();
    for (int leaf = 0; leaf < leaves.size(); leaf++) {
      if (leaves.get(leaf) instanceof StateValue one && one.index() == state) {
        differentiate();
        for (int i = 0; i < 6; i++) {
          w[i] = gradients[i][leaf];
        }
        return true;
      }
    }
    return false;
  }

  @Override
  public double potentialEnergy() {
    return law.value(POTENTIAL);
  }

  @Override
  public double power(FrameMotion x, double[] w) {
    double sum = law.value(POTENTIAL_RATE);
    for (int i = 0; i < 6; i++) {
      sum += w[i] * x.twist(i);
    }
    return sum;
  }

  @Override
  public void values(FrameMotion x, double[] out, int at) {
    read(outputs, x);
    outputs.values();
    for (int i = 0; i < outputCount; i++) {
      out[at + i] = outputs.value(i);
    }
  }
}
