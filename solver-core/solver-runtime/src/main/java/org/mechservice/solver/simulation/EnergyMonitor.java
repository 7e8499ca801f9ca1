package org.mechservice.solver.simulation;

import java.util.OptionalDouble;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.Energies;
import org.mechservice.solver.api.capability.PowerInput;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.ode.SavedState;

/**
 * Watches the mechanical energy at the output times: less the work put in, it must stay what it
 * was. Where work is done that nobody measures, nothing can be said of it.
 */
final class EnergyMonitor {
  /**
   * Relative to the energies themselves, a change that rounding explains: each is summed over
   * bodies and forces, a thousand roundings.
   */
  private static final double ROUNDING = 1000 * 0x1p-52;

  /** Of the energy at the start. */
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
   * Refuses models whose energy cannot be balanced.
   *
   * @throws IllegalArgumentException S-166 saying why
   */
  static void requireBalance(Model model) {
    if (!(model instanceof Energies)) {
      throw unbalanced(model, "does not tell its energy");
    }
    if (model instanceof PowerInput input && !input.holdsAllPower()) {
      throw unbalanced(model, "has loops with motions prescribed in time, whose work is not known");
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
   * Takes note of the energy in a state.
   *
   * @param work put in since the start, J
   * @param turnover what was put in and what was taken out since the start, added up, J
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
   * Returns the largest of kinetic energy, change of potential energy, and the mean of what forces
   * have put in and taken out, J. Without the last a block that friction holds, and that creeps,
   * has no scale: all that is pulled in is rubbed away. At least a small part of the energy itself,
   * far above its rounding, lest that looks like a drift where next to nothing moves.
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
   * Returns whether the drift last observed is above a part of the scale so far, or no number. What
   * rounding explains does not count: a mechanism at rest has no scale.
   */
  boolean exceeds(double part) {
    return !workUnknown && !(latest <= part * scale + rounding);
  }

  /** Carries what was observed over. */
  void transfer(SavedState state) {
    started = state.flag(started);
    initialTotal = state.number(initialTotal);
    initialPotential = state.number(initialPotential);
    drift = state.number(drift);
    scale = state.number(scale);
    workUnknown = state.flag(workUnknown);
  }
}
