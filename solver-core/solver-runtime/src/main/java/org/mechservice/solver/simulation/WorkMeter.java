package org.mechservice.solver.simulation;

import java.util.Optional;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.MomentumBalance;
import org.mechservice.solver.api.capability.PowerInput;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.simulation.equations.ModelEquations;

/**
 * The work of all forces without potential energy, and the impulse of external loads: power and
 * force integrated along the interpolated solution by Lobatto's rule with four points, exact to
 * degree 5. The rule is applied to each step, or to its parts between rows, and does not influence
 * the step size: down to tolerances of 1e-12 the error of the solution exceeds that of the rule,
 * also with long steps of order 12, and a rule of degree 9 makes no difference.
 */
final class WorkMeter {
  /** Points of the rule in [−1, 1], and its weights. */
  private static final double[] POINTS = {-1, -1 / Math.sqrt(5), 1 / Math.sqrt(5), 1};

  private static final double[] WEIGHTS = {1.0 / 6, 5.0 / 6, 5.0 / 6, 1.0 / 6};

  private static final PowerInput NOTHING = (t, y, power) -> {};

  private final ModelEquations equations;
  private final Integrator integrator;
  private final PowerInput source;
  private final Optional<MomentumBalance> momentum;
  private final double[] y;
  private final double[] yDot;
  private final double[] power = new double[2];
  private double reached;
  private double work;
  private double turnover;

  /**
   * @param wanted whether the work is measured; otherwise, or if the model does no such work, it
   *     stays zero
   * @param momentum balance of momentum to which impulses are added, if any
   */
  WorkMeter(
      ModelEquations equations,
      Integrator integrator,
      Model model,
      boolean wanted,
      Optional<MomentumBalance> momentum,
      double t0) {
    this.momentum = momentum;
    this.equations = equations;
    this.integrator = integrator;
    source = wanted && model instanceof PowerInput able ? able : NOTHING;
    y = new double[equations.dimension()];
    yDot = new double[equations.dimension()];
    reached = t0;
  }

  /** Adds the work up to a time inside the last step; returns false if the loops are open there. */
  boolean advance(double t) {
    if ((source == NOTHING && momentum.isEmpty()) || t <= reached) {
      return true;
    }
    double half = 0.5 * (t - reached);
    double middle = reached + half;
    double inset = equations.inset(t);
    for (int i = 0; i < POINTS.length; i++) {
      double at = middle + half * POINTS[i];
      if (i == 0 || i == POINTS.length - 1) {
        at = i == 0 ? Math.min(middle, reached + inset) : Math.max(middle, t - inset);
      }
      integrator.interpolate(at, y, yDot);
      if (!equations.closeLoops(at, y)) {
        return false;
      }
      if (momentum.isPresent()) {
        momentum.get().add(half * WEIGHTS[i], at, y);
      }
      source.power(at, y, power);
      work += half * WEIGHTS[i] * power[0];
      turnover += half * WEIGHTS[i] * power[1];
    }
    reached = t;
    return true;
  }

  /** Adds energy of an event, J. */
  void add(double energy) {
    work += energy;
    turnover += Math.abs(energy);
  }

  /** Returns the work up to the time last advanced to, J; positive into the mechanism. */
  double work() {
    return work;
  }

  /** Returns the sum of added and removed energy up to then, J. */
  double turnover() {
    return turnover;
  }

  /** Saves or restores the work. */
  void transfer(SavedState state) {
    reached = state.number(reached);
    work = state.number(work);
    turnover = state.number(turnover);
  }
}
