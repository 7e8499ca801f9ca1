package org.mechservice.mechml;

import java.util.List;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * A model file, read and resolved: SI units, numbers only.
 *
 * @param mechanism the mechanism
 * @param settings the simulation asked for
 * @param warnings what is worth knowing, in file order; no errors
 */
public record MechmlModel(
    Mechanism mechanism, SimulationSettings settings, List<Diagnostic> warnings) {
  public MechmlModel {
    warnings = List.copyOf(warnings);
  }
}
