package org.mechservice.solver.simulation.equations;

import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.catalogue.MessageCode;

/** y' = f(t, y) of open chains. */
public final class ExplicitForm implements EquationForm {
  @Override
  public ModelEquations of(Model model) {
    return new ExplicitModelEquations(explicit(model));
  }

  public static ExplicitModel explicit(Model model) {
    if (model instanceof ExplicitModel explicit) {
      return explicit;
    }
    throw new IllegalArgumentException(
        MessageCode.EQUATION_FORM_MISSING
            + " model \""
            + model.description().name()
            + "\" has no explicit form y' = f(t, y)");
  }
}
