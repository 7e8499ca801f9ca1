package org.mechservice.solver.simulation;

import java.util.OptionalDouble;
import org.mechservice.solver.api.Energies;
import org.mechservice.solver.integration.StateTransfer;

/**
 * Watches the mechanical energy at the output times: less the work put in, it must stay what it
 * was. Where work is done that nobody measures, nothing can be said of it.
 */
final class EnergyMonitor {
  private final double[] energy = new double[2];
  private boolean started;
  private double initialTotal;
  private double initialPotential;
  private double drift;
  private double scale;
  private boolean workUnknown;

  /**
   * Takes note of the energy in a state.
   *
   * @param work put in since the start, J
   * @param unmeasured whether work is done that is not in {@code work}
   */
  void observe(Energies model, double t, double[] y, double work, boolean unmeasured) {
    model.energy(t, y, energy);
    workUnknown |= unmeasured;
    double total = energy[0] + energy[1] - work;
    if (!started) {
      started = true;
      initialTotal = total;
      initialPotential = energy[1];
    }
    drift = Math.max(drift, Math.abs(total - initialTotal));
    scale = Math.max(scale, Math.max(energy[0], Math.abs(energy[1] - initialPotential)));
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

  /** Returns the larger of largest kinetic energy and largest change of potential energy, J. */
  OptionalDouble scale() {
    return started && !workUnknown ? OptionalDouble.of(scale) : OptionalDouble.empty();
  }

  /** Carries what was observed over. */
  void transfer(StateTransfer state) {
    started = state.flag(started);
    initialTotal = state.number(initialTotal);
    initialPotential = state.number(initialPotential);
    drift = state.number(drift);
    scale = state.number(scale);
    workUnknown = state.flag(workUnknown);
  }
}
