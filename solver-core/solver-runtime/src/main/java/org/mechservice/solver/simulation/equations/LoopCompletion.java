package org.mechservice.solver.simulation.equations;

import org.mechservice.solver.api.capability.DependentStates;
import org.mechservice.solver.ode.CompletedSystem;

/** Adapter of a model's dependent states to the integrator's interface. */
interface LoopCompletion extends CompletedSystem {
  /** Returns the model's dependent states. */
  DependentStates loops();

  /** Returns the time for evaluations at {@code t}. */
  double evaluationTime(double t);

  @Override
  default boolean independent(int component) {
    return loops().independent(component);
  }

  @Override
  default boolean tested(int component) {
    return loops().tested(component);
  }

  @Override
  default void enlarge(double[] sizes) {
    loops().enlarge(sizes);
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
