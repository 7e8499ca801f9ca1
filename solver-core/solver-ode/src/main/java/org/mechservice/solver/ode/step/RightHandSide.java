package org.mechservice.solver.ode.step;

import java.util.function.BooleanSupplier;
import org.mechservice.solver.ode.OdeSystem;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.SavedSystem;

/**
 * The problem as its integrator sees it: counted, not evaluated after the stop signal, and not
 * across its own jumps.
 */
public final class RightHandSide {
  private static final int ALL_FINITE = -1;

  private final OdeSystem system;
  private final BooleanSupplier stop;
  private final Breakpoints breakpoints = new Breakpoints();
  private long evaluations;

  public RightHandSide(OdeSystem system, BooleanSupplier stop) {
    this.system = system;
    this.stop = stop;
  }

  public OdeSystem system() {
    return system;
  }

  /** Returns the places at which f jumps; to be begun with the problem. */
  public Breakpoints breakpoints() {
    return breakpoints;
  }

  /** Returns whether the stop signal is given. */
  public boolean stopped() {
    return stop.getAsBoolean();
  }

  /** Evaluates f unless told to stop; returns whether it did. */
  public boolean evaluate(double t, double[] y, double[] yDot) {
    if (stopped()) {
      return false;
    }
    evaluateAlways(t, y, yDot);
    return true;
  }

  /** Evaluates f. */
  public void evaluateAlways(double t, double[] y, double[] yDot) {
    system.derivative(breakpoints.inside(t), y, yDot);
    evaluations++;
  }

  /** Carries the counter, the places passed and the problem's own state over. */
  public void transfer(SavedState state) {
    evaluations = state.integer(evaluations);
    breakpoints.transfer(state);
    system.part(SavedSystem.class).ifPresent(saved -> saved.transfer(state));
  }

  public long evaluations() {
    return evaluations;
  }

  /** Returns the first component that is not finite; −1 if all are. */
  public static int firstNotFinite(double[] x) {
    double zero = 0;
    for (double component : x) {
      zero += 0 * component; // NaN from one that is not finite on
    }
    return zero == 0 ? ALL_FINITE : searchNotFinite(x);
  }

  private static int searchNotFinite(double[] x) {
    for (int l = 0; l < x.length; l++) {
      if (!Double.isFinite(x[l])) {
        return l;
      }
    }
    return ALL_FINITE;
  }

  /** Stands in until a problem is given. */
  public static RightHandSide none() {
    OdeSystem nothing =
        new OdeSystem() {
          @Override
          public int dimension() {
            return 0;
          }

          @Override
          public void derivative(double t, double[] y, double[] yDot) {}
        };
    return new RightHandSide(nothing, () -> false);
  }
}
