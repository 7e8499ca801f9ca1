package org.mechservice.solver.simulation;

import java.util.Arrays;
import org.mechservice.solver.api.ExplicitModel;
import org.mechservice.solver.integration.OdeSystem;

/** A model as the integrator sees it; remembers where its inertia was singular. */
final class ModelEquations implements OdeSystem {
  private final ExplicitModel model;
  private final int dimension;
  private int singularJoint = ExplicitModel.REGULAR;

  ModelEquations(ExplicitModel model) {
    this.model = model;
    this.dimension = model.description().stateCount();
  }

  @Override
  public int dimension() {
    return dimension;
  }

  @Override
  public void derivative(double t, double[] y, double[] yDot) {
    singularJoint = model.derivative(t, y, yDot);
    if (singularJoint != ExplicitModel.REGULAR) {
      Arrays.fill(yDot, Double.NaN);
    }
  }

  /**
   * Returns the joint at which the last evaluation was singular, or {@link ExplicitModel#REGULAR}.
   */
  int singularJoint() {
    return singularJoint;
  }
}
