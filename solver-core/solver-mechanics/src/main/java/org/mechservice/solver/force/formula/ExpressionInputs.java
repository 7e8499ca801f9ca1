package org.mechservice.solver.force.formula;

import java.util.List;
import java.util.function.IntConsumer;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.FormulaEvaluation;
import org.mechservice.solver.force.applied.GradientSink;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.Parameter;

/** Expressions of time, parameters and the state, evaluated in a motion that the caller sweeps. */
public final class ExpressionInputs {
  private final FormulaEvaluation formulas;
  private final LeafInput[] inputs;
  private final double[] parameters;

  /** The leaf of each further state; −1 if the expressions do not depend on it. */
  private final int[] leafOfState;

  /** ∂(result)/∂(leaf), leaves of one result after the other. */
  private final double[][] gradients;

  /**
   * Prepares expressions, with parameters at the mechanism's values.
   *
   * @throws IllegalArgumentException if one refers to an element that the mechanism does not have
   */
  public ExpressionInputs(TreeMotion motion, List<Expression> expressions) {
    formulas = new FormulaEvaluation(expressions);
    parameters =
        motion.tree().mechanism().parameters().stream().mapToDouble(Parameter::value).toArray();
    List<Expression> leaves = formulas.leaves();
    inputs = new LeafInput[leaves.size()];
    for (int i = 0; i < inputs.length; i++) {
      inputs[i] = LeafInput.of(leaves.get(i), motion, parameters);
    }
    leafOfState = new int[motion.further.length];
    for (int i = 0; i < leafOfState.length; i++) {
      leafOfState[i] = leaves.indexOf(new Expression.StateValue(i));
    }
    gradients = new double[expressions.size()][inputs.length];
  }

  /** Sets the values of the mechanism's parameters, SI units. */
  public void parameters(double[] values) {
    System.arraycopy(values, 0, parameters, 0, parameters.length);
  }

  /**
   * Evaluates all results in the motion of the last sweep, which must include poses in the world.
   */
  public void evaluate(double t) {
    for (int i = 0; i < inputs.length; i++) {
      formulas.setLeaf(i, inputs[i].value(t));
    }
    formulas.values();
  }

  /** Returns a result of the last {@link #evaluate}. */
  public double value(int result) {
    return formulas.value(result);
  }

  /** Evaluates the gradients of all results at the state of the last {@link #evaluate}. */
  public void differentiate() {
    formulas.derivatives();
    for (int i = 0; i < gradients.length; i++) {
      formulas.gradient(i, gradients[i]);
    }
  }

  /** Returns ∂(result)/∂(further state) after {@link #differentiate}. */
  public double byState(int result, int state) {
    return leafOfState[state] < 0 ? 0 : gradients[result][leafOfState[state]];
  }

  int leafCount() {
    return inputs.length;
  }

  /** Returns ∂(result)/∂(leaf). */
  double byLeaf(int result, int leaf) {
    return gradients[result][leaf];
  }

  /** Passes on the gradient of a leaf. */
  void gradient(int leaf, GradientSink sink) {
    inputs[leaf].gradient(sink);
  }

  void links(IntConsumer taker) {
    for (LeafInput input : inputs) {
      input.links(taker);
    }
  }

  /** Records an accepted state: angles of cut joints are unwrapped from here. */
  public void accepted() {
    for (LeafInput input : inputs) {
      input.accepted();
    }
  }
}
