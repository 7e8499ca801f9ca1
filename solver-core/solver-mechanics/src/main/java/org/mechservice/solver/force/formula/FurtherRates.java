package org.mechservice.solver.force.formula;

import java.util.List;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.FurtherState;

/**
 * The derivatives of a mechanism's further states, s' = f(t, q, v, s), in a motion that the caller
 * sweeps with poses in the world. Workspace of one thread.
 */
public final class FurtherRates {
  private final ExpressionInputs inputs;
  private final int count;

  /** Prepares the derivatives of the states of a motion's mechanism. */
  public FurtherRates(TreeMotion motion) {
    List<Expression> derivatives =
        motion.tree().mechanism().furtherStates().stream().map(FurtherState::derivative).toList();
    inputs = new ExpressionInputs(motion, derivatives);
    count = derivatives.size();
  }

  /** Returns the number of further states. */
  public int count() {
    return count;
  }

  /**
   * Evaluates the derivatives in the motion of the last sweep.
   *
   * @param rates one number per further state from {@code at}; overwritten
   */
  public void evaluate(double t, double[] rates, int at) {
    inputs.evaluate(t);
    for (int i = 0; i < count; i++) {
      rates[at + i] = inputs.value(i);
    }
  }

  /** Writes ∂f/∂s at the state of the last {@link #evaluate}, row by row. */
  public void byState(double[] slopes) {
    inputs.differentiate();
    for (int i = 0; i < count; i++) {
      for (int k = 0; k < count; k++) {
        slopes[i * count + k] = inputs.byState(i, k);
      }
    }
  }

  /**
   * Records that the state of the last sweep was accepted: angles of cut joints are unwrapped from
   * here.
   */
  public void accepted(double t) {
    inputs.evaluate(t);
    inputs.accepted();
  }
}
