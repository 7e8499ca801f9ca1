package org.mechservice.solver.simulation;

import java.util.OptionalDouble;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.Energies;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.ode.SavedState;

/**
 * Monitors the energy balance at the output times: the mechanical energy minus the work must be
 * constant. There is no balance if some work is not measured.
 */
final class EnergyMonitor {
  /**
   * Change relative to the energies that rounding explains: each is a sum over bodies and forces
   * with about a thousand rounding errors.
   */
  private static final double ROUNDING = 1000 * 0x1p-52;

  /** Smallest energy scale, as a fraction of the energy at the start. */
  private static final double LEAST_SCALE = 1e-10;

  private final double[] energy = new double[2];
  private boolean started;
  private double initialTotal;
  private double initialPotential;
  private double drift;
  private double latest;
  private double rounding;
  private double scale;
  private boolean workUnknown;

  /**
   * Rejects models without an energy balance.
   *
   * @throws IllegalArgumentException S-166 with the reason
   */
  static void requireBalance(Model model) {
    if (!(model instanceof Energies)) {
      throw unbalanced(model, "does not tell its energy");
    }
  }

  /** Returns the refusal to watch a model's energy balance. */
  static IllegalArgumentException unbalanced(Model model, String why) {
    return new IllegalArgumentException(
        MessageCode.ENERGY_BALANCE_NOT_WATCHED
            + " model \""
            + model.description().name()
            + "\" "
            + why
            + ", so no drift of its energy balance can end the run; leave out --max-drift");
  }

  /**
   * Records the energy at a state.
   *
   * @param work work since the start, J
   * @param turnover sum of added and removed energy since the start, J
   * @param unmeasured whether work is done that is not in {@code work}
   */
  void observe(
      Energies model, double t, double[] y, double work, double turnover, boolean unmeasured) {
    model.energy(t, y, energy);
    workUnknown |= unmeasured;
    double total = energy[0] + energy[1] - work;
    if (!started) {
      started = true;
      initialTotal = total;
      initialPotential = energy[1];
    }
    latest = Math.abs(total - initialTotal);
    double sizes = energy[0] + Math.abs(energy[1]) + Math.abs(work) + Math.abs(initialTotal);
    rounding = ROUNDING * sizes;
    drift = Math.max(drift, latest);
    scale = Math.max(scale, Math.max(energy[0], Math.abs(energy[1] - initialPotential)));
    scale = Math.max(scale, turnover / 2);
  }

  /** Returns the kinetic energy last observed, J. */
  double kinetic() {
    return energy[0];
  }

  /** Returns the potential energy last observed, J. */
  double potential() {
    return energy[1];
  }

  /**
   * Returns the largest |E(t) − W(t) − E(0)| observed, J; empty if nothing was observed or W is not
   * known.
   */
  OptionalDouble drift() {
    return started && !workUnknown ? OptionalDouble.of(drift) : OptionalDouble.empty();
  }

  /**
   * Returns the largest of kinetic energy, change of potential energy, and the mean of added and
   * removed energy, J. The last one is the scale of a creeping block held by friction, which
   * dissipates all work. The scale is at least a small fraction of the energy, far above rounding,
   * so that rounding does not look like a drift if hardly anything moves.
   */
  OptionalDouble scale() {
    return started && !workUnknown
        ? OptionalDouble.of(Math.max(scale, LEAST_SCALE * Math.abs(initialTotal)))
        : OptionalDouble.empty();
  }

  /** Returns |E(t) − W(t) − E(0)| as last observed, J. */
  double latestDrift() {
    return latest;
  }

  /**
   * Returns whether the last drift is above a fraction of the scale so far, or NaN. A drift by
   * rounding does not count: a mechanism at rest has no scale.
   */
  boolean exceeds(double part) {
    return !workUnknown && !(latest <= part * scale + rounding);
  }

  /** Saves or restores the observed values. */
  void transfer(SavedState state) {
    started = state.flag(started);
    initialTotal = state.number(initialTotal);
    initialPotential = state.number(initialPotential);
    drift = state.number(drift);
    scale = state.number(scale);
    workUnknown = state.flag(workUnknown);
  }
}
