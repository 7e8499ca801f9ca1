package org.mechservice.solver.simulation;

import java.util.OptionalDouble;
import org.mechservice.solver.api.Energies;
import org.mechservice.solver.integration.StateTransfer;

/**
 * Watches the mechanical energy at the output times; without forces that do work it must stay what
 * it was.
 */
final class EnergyMonitor {
  private final double[] energy = new double[2];
  private boolean started;
  private double initialTotal;
  private double initialPotential;
  private double drift;
  private double scale;

  /** Takes note of the energy in a state. */
  void observe(Energies model, double t, double[] y) {
    model.energy(t, y, energy);
    double total = energy[0] + energy[1];
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

  /** Returns the largest |E(t) − E(0)| observed, J; empty if nothing was observed. */
  OptionalDouble drift() {
    return started ? OptionalDouble.of(drift) : OptionalDouble.empty();
  }

  /** Returns the larger of largest kinetic energy and largest change of potential energy, J. */
  OptionalDouble scale() {
    return started ? OptionalDouble.of(scale) : OptionalDouble.empty();
  }

  /** Carries what was observed over. */
  void transfer(StateTransfer state) {
    started = state.flag(started);
    initialTotal = state.number(initialTotal);
    initialPotential = state.number(initialPotential);
    drift = state.number(drift);
    scale = state.number(scale);
  }
}
