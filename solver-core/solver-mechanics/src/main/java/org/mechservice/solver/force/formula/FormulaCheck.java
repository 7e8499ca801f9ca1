package org.mechservice.solver.force.formula;

import java.util.Optional;
import org.mechservice.solver.kinematics.TreeMotion;

/** Evaluates the subexpressions of forces' formulas from the data of a mechanism. */
public final class FormulaCheck {
  private final ForceFormulas formulas;
  private final ExpressionInputs inputs;

  private FormulaCheck(ForceFormulas formulas, TreeMotion motion) {
    this.formulas = formulas;
    inputs = new ExpressionInputs(motion, formulas.expressions());
  }

  /**
   * Prepares the check.
   *
   * @param motion swept by the caller, with poses in the world
   * @return empty if all formulas always have values
   */
  public static Optional<FormulaCheck> of(TreeMotion motion) {
    return ForceFormulas.of(motion.tree().mechanism()).map(f -> new FormulaCheck(f, motion));
  }

  /** Returns the lines of {@link ForceFormulas}. */
  public String lines() {
    return formulas.lines();
  }

  /** Returns the values in the motion of the last sweep. */
  public double[] values(double t) {
    double[] values = new double[formulas.expressions().size()];
    inputs.evaluate(t);
    for (int i = 0; i < values.length; i++) {
      values[i] = inputs.value(i);
    }
    return values;
  }
}
