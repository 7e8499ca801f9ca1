package org.mechservice.solver.ode.newton;

import java.util.Arrays;
import java.util.function.BooleanSupplier;
import org.mechservice.solver.ode.ResidualSystem;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.SavedSystem;
import org.mechservice.solver.ode.step.Breakpoints;
import org.mechservice.solver.ode.step.Manifold;

/**
 * F(t, y, y') as its integrator sees it: counted, not evaluated after the stop signal, not across
 * its own jumps, and 0 in the places of passive components.
 */
public final class Residual {
  private final ResidualSystem system;
  private final Manifold manifold;
  private final BooleanSupplier stop;
  private final Breakpoints breakpoints = new Breakpoints();
  private final double[] completed;
  private long evaluations;

  public Residual(ResidualSystem system, Manifold manifold, BooleanSupplier stop) {
    this.system = system;
    this.manifold = manifold;
    this.stop = stop;
    completed = new double[manifold.dimension()];
  }

  Manifold manifold() {
    return manifold;
  }

  /** Returns the places at which F jumps; to be begun with the problem. */
  public Breakpoints breakpoints() {
    return breakpoints;
  }

  /** Returns whether ∂F/∂y' moves with states that need nobody to complete them. */
  boolean massMatrixMoves() {
    return system.massMatrixMoves() && !manifold.completes();
  }

  /** Returns whether the stop signal is given. */
  boolean stopped() {
    return stop.getAsBoolean();
  }

  /** Evaluates F at a completed state unless told to stop; returns whether it did. */
  boolean evaluate(double t, double[] y, double[] yDot, double[] residual) {
    if (stopped()) {
      return false;
    }
    evaluateAlways(t, y, yDot, residual);
    return true;
  }

  /** Evaluates F at a completed state. */
  void evaluateAlways(double t, double[] y, double[] yDot, double[] residual) {
    system.residual(breakpoints.inside(t), y, yDot, residual);
    if (manifold.completes()) {
      manifold.clearPassive(residual);
    }
    evaluations++;
  }

  /** Evaluates F after making the passive components fit; NaN if that is not possible. */
  boolean evaluateCompleted(double t, double[] y, double[] yDot, double[] residual) {
    if (!manifold.completes()) {
      return evaluate(t, y, yDot, residual);
    }
    System.arraycopy(y, 0, completed, 0, y.length);
    if (manifold.complete(t, completed)) {
      return evaluate(t, completed, yDot, residual);
    }
    Arrays.fill(residual, Double.NaN);
    return !stopped();
  }

  public long evaluations() {
    return evaluations;
  }

  /** Carries the counter, the places passed and the problem's own state over. */
  void transfer(SavedState state) {
    evaluations = state.integer(evaluations);
    breakpoints.transfer(state);
    system.part(SavedSystem.class).ifPresent(saved -> saved.transfer(state));
    manifold.refresh();
  }
}
