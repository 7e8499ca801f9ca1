package org.mechservice.report;

import java.util.List;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.JointVariables;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.run.RunSettings;

/** q'' = −9.81 sin q − c q', from rest at one radian, for two seconds. */
public final class PlanarPendulum implements ExplicitModel {
  private final double damping;

  public PlanarPendulum(double damping) {
    this.damping = damping;
  }

  @Override
  public ModelDescription description() {
    return new ModelDescription(
        "PlanarPendulum",
        "DTR",
        List.of(new JointVariables("pin", JointType.R)),
        new RunSettings(0, 2, 0.1, "ode113", 1e-6, 1e-8));
  }

  @Override
  public void initialState(double[] y) {
    y[0] = 1;
    y[1] = 0;
  }

  @Override
  public int derivative(double t, double[] y, double[] yDot) {
    yDot[0] = y[1];
    yDot[1] = -9.81 * Math.sin(y[0]) - damping * y[1];
    return REGULAR;
  }
}
