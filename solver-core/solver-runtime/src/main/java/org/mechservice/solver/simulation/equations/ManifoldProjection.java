package org.mechservice.solver.simulation.equations;

import org.mechservice.solver.api.capability.ProjectedStates;
import org.mechservice.solver.ode.ProjectedSystem;

/** Adapter of a model's projection of states to the integrator's interface. */
interface ManifoldProjection extends ProjectedSystem {
  /** Returns the model's projection. */
  ProjectedStates loops();

  /** Returns the time for evaluations at {@code t}. */
  double evaluationTime(double t);

  @Override
  default boolean project(double t, double[] y) {
    return loops().project(evaluationTime(t), y);
  }

  @Override
  default boolean projectError(double t, double[] y, double[] error) {
    return loops().projectError(evaluationTime(t), y, error);
  }

  @Override
  default void projectionAccepted(double t, double[] y) {
    loops().accepted(t, y);
  }
}
