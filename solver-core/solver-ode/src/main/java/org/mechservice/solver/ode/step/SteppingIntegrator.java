package org.mechservice.solver.ode.step;

import org.mechservice.solver.ode.IntegrationFailure;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.StepResult;

/** Common part of the integrators: settings and progress. */
public abstract class SteppingIntegrator implements WatchedIntegrator {
  /** Settings with the tolerances of the error tests, and these relative to those asked for. */
  public final IntegratorSettings settings;

  public final double toleranceFactor;
  public final IntegrationProgress progress;

  /**
   * @param progress shared with another that takes turns with this one
   * @throws IllegalArgumentException if a setting is out of range
   */
  public SteppingIntegrator(IntegratorSettings settings, IntegrationProgress progress) {
    settings.requireUsable();
    this.progress = progress;
    this.settings = settings.working();
    toleranceFactor = settings.toleranceFactor();
  }

  /** Goes on from where another method has come to; the counters go on. */
  public abstract StepResult takeOver(double t, double[] y);

  /** Returns how often f was evaluated by this method. */
  public abstract long evaluations();

  @Override
  public double time() {
    return progress.time();
  }

  @Override
  public final double previousTime() {
    return progress.previousTime();
  }

  @Override
  public final double stepSize() {
    return progress.stepSize();
  }

  @Override
  public final int order() {
    return progress.order();
  }

  @Override
  public final IntegrationFailure failure() {
    return progress.failure();
  }
}
