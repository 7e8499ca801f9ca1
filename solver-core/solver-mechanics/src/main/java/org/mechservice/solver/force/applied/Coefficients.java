package org.mechservice.solver.force.applied;

import java.util.List;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.ParameterValue;
import org.mechservice.solver.expression.FormulaEvaluation;
import org.mechservice.solver.force.law.Condition;
import org.mechservice.solver.mechanism.force.Coefficient;
import org.mechservice.solver.mechanism.force.ForceElement;

/** The coefficients of a force: expressions of tunable parameters only, evaluated once per run. */
final class Coefficients {
  private final List<Coefficient> coefficients;
  private final FormulaEvaluation formulas;

  /**
   * @throws IllegalArgumentException if an expression depends on time or the state
   */
  Coefficients(ForceElement force) {
    coefficients = force.coefficients();
    formulas = new FormulaEvaluation(coefficients.stream().map(Coefficient::value).toList());
    for (Expression leaf : formulas.leaves()) {
      if (!(leaf instanceof ParameterValue)) {
        throw new IllegalArgumentException(
            "coefficients of force " + force.name() + " may contain parameters but not " + leaf);
      }
    }
  }

  /**
   * Evaluates.
   *
   * @param parameters values of all parameters, SI units; not modified
   * @param out receives the coefficients
   * @param force receives the defect of one that cannot be used
   * @return false if there is one
   */
  boolean update(double[] parameters, double[] out, AppliedForce force) {
    List<Expression> leaves = formulas.leaves();
    for (int i = 0; i < leaves.size(); i++) {
      if (leaves.get(i) instanceof ParameterValue parameter) {
        formulas.setLeaf(i, parameters[parameter.index()]);
      }
    }
    formulas.values();
    for (int i = 0; i < coefficients.size(); i++) {
      out[i] = formulas.value(i);
      if (!Double.isFinite(out[i])) {
        return refuse(i, out[i], Condition.FINITE, force);
      }
    }
    for (int i = 0; i < coefficients.size(); i++) {
      Condition condition = coefficients.get(i).condition();
      if (!condition.holds(out[i], i == 0 ? 0 : out[i - 1])) {
        return refuse(i, out[i], condition, force);
      }
    }
    return true;
  }

  private boolean refuse(int coefficient, double value, Condition condition, AppliedForce force) {
    return force.refuse(coefficients.get(coefficient).name(), value, condition.text());
  }
}
