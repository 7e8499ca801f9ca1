package org.mechservice.solver.force.applied;

import java.util.List;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.ParameterValue;
import org.mechservice.solver.expression.Tape;
import org.mechservice.solver.expression.TapeEvaluation;

/**
 * The coefficients of a force law: expressions of tunable parameters only, evaluated once per run.
 */
public final class Coefficients {
  private final TapeEvaluation tape;
  private final double[] value;

  /**
   * @throws IllegalArgumentException if an expression depends on time or the state
   */
  public Coefficients(String force, List<Expression> expressions) {
    tape = new TapeEvaluation(new Tape(expressions));
    value = new double[expressions.size()];
    for (Expression leaf : tape.tape().leaves()) {
      if (!(leaf instanceof ParameterValue)) {
        throw new IllegalArgumentException(
            "coefficients of force " + force + " may contain parameters but not " + leaf);
      }
    }
  }

  /** Evaluates; returns the index of the first that is not finite, or −1. */
  public int update(double[] parameters) {
    List<Expression> leaves = tape.tape().leaves();
    for (int i = 0; i < leaves.size(); i++) {
      if (leaves.get(i) instanceof ParameterValue parameter) {
        tape.setLeaf(i, parameters[parameter.index()]);
      }
    }
    tape.values();
    for (int i = 0; i < value.length; i++) {
      value[i] = tape.value(i);
    }
    return tape.firstNotFinite();
  }

  public double at(int index) {
    return value[index];
  }
}
