package org.mechservice.solver.ode.step;

import java.util.function.Supplier;
import org.mechservice.solver.ode.Integrator;

/** An integrator whose steps may be watched. */
public interface WatchedIntegrator extends Integrator {
  /**
   * Has the steps of all problems to come watched.
   *
   * @param watches makes one for each method that the integrator consists of
   */
  void watch(Supplier<StepWatch> watches);
}
