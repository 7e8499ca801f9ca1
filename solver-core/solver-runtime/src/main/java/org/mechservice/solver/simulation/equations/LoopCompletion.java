package org.mechservice.solver.simulation.equations;

import org.mechservice.solver.api.capability.DependentStates;
import org.mechservice.solver.ode.CompletedSystem;

/** What a model knows of its dependent states, in the integrator's words. */
interface LoopCompletion extends CompletedSystem {
  /** Returns what the model knows. */
  DependentStates loops();

  /** Returns where to evaluate instead of at {@code t}. */
  double evaluationTime(double t);

  @Override
  default boolean independent(int component) {
    return loops().independent(component);
  }

  @Override
  default boolean complete(double t, double[] y) {
    return loops().complete(evaluationTime(t), y);
  }

  @Override
  default boolean accepted(double t, double[] y) {
    return loops().accepted(evaluationTime(t), y);
  }
}
