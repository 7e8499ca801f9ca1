package org.mechservice.solver.simulation;

import java.util.List;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.JointVariables;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.capability.Energies;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.run.RunSettings;

/** A unit mass on a unit spring, displaced by 1: q = cos t. */
class HarmonicOscillator implements ExplicitModel, Energies {
  static final RunSettings SETTINGS = new RunSettings(0, 2, 0.25, "ode113", 1e-10, 1e-12);

  @Override
  public ModelDescription description() {
    return new ModelDescription(
        "Oscillator", "DTR", List.of(new JointVariables("slide", JointType.P)), SETTINGS);
  }

  @Override
  public void initialState(double[] y) {
    y[0] = 1;
    y[1] = 0;
  }

  @Override
  public int derivative(double t, double[] y, double[] yDot) {
    yDot[0] = y[1];
    yDot[1] = -y[0];
    return REGULAR;
  }

  @Override
  public void energy(double t, double[] y, double[] energy) {
    energy[0] = 0.5 * y[1] * y[1];
    energy[1] = 0.5 * y[0] * y[0];
  }
}
