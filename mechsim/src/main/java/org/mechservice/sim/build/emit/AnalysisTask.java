package org.mechservice.sim.build.emit;

import java.util.Optional;
import org.mechservice.mechml.SimulationTask;
import org.mechservice.solver.analysis.EquilibriumModel;
import org.mechservice.solver.analysis.LinearModel;
import org.mechservice.solver.analysis.PrescribedModel;

/**
 * What is computed without integration.
 *
 * @param model class of the solver that does, with a method {@code model(loader, options, columns,
 *     data)}
 * @param options its options as text
 */
public record AnalysisTask(Class<?> model, String options) {
  /** Returns what a simulation asks for; empty if it is integrated in time. */
  public static Optional<AnalysisTask> of(SimulationTask task) {
    if (task instanceof SimulationTask.StaticEquilibrium rest) {
      return Optional.of(
          new AnalysisTask(EquilibriumModel.class, rest.tolerance() + " " + rest.maxIterations()));
    } else if (task instanceof SimulationTask.Linearization linear) {
      String at = linear.atEquilibrium() ? "equilibrium" : "start";
      return Optional.of(
          new AnalysisTask(LinearModel.class, at + (linear.modes() ? " modes" : " matrices")));
    }
    return task instanceof SimulationTask.Dynamic
        ? Optional.empty()
        : Optional.of(new AnalysisTask(PrescribedModel.class, ""));
  }
}
