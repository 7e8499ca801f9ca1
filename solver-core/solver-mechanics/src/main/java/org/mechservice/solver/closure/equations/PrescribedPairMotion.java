package org.mechservice.solver.closure.equations;

import java.util.List;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.FormulaEvaluation;

/** Prescribed coordinates as functions of time and parameters. Workspace of one thread. */
public final class PrescribedPairMotion {
  private final FormulaEvaluation evaluation;
  private final double[] parameters;

  /**
   * @param coordinates one expression per coordinate
   * @param parameters values of the parameters; stored, later changes have effect
   * @throws IllegalArgumentException if an expression depends on anything but time and parameters
   */
  public PrescribedPairMotion(List<Expression> coordinates, double[] parameters) {
    evaluation = new FormulaEvaluation(coordinates);
    this.parameters = parameters;
    for (Expression leaf : evaluation.leaves()) {
      if (!(leaf instanceof Expression.Time) && !(leaf instanceof Expression.ParameterValue)) {
        throw new IllegalArgumentException("a prescribed motion depends on " + leaf);
      }
    }
  }

  /** Returns the number of coordinates. */
  public int count() {
    return evaluation.resultCount();
  }

  /** Evaluates the coordinates with their first and second derivatives. */
  public void evaluate(double t) {
    List<Expression> leaves = evaluation.leaves();
    for (int i = 0; i < leaves.size(); i++) {
      if (leaves.get(i) instanceof Expression.ParameterValue parameter) {
        evaluation.setLeaf(i, parameters[parameter.index()], 0, 0);
      } else {
        evaluation.setLeaf(i, t, 1, 0);
      }
    }
    evaluation.derivatives();
    evaluation.rates();
  }

  /** Returns the position of a coordinate, rad or m. */
  public double value(int index) {
    return evaluation.value(index);
  }

  /** Returns the velocity of a coordinate, rad/s or m/s. */
  public double rate(int index) {
    return evaluation.rate(index);
  }

  /** Returns the acceleration of a coordinate, rad/s² or m/s². */
  public double acceleration(int index) {
    return evaluation.secondRate(index);
  }
}
