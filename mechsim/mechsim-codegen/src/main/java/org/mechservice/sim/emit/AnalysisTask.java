package org.mechservice.sim.emit;

import java.util.Locale;
import java.util.Optional;
import org.mechservice.mechml.SimulationTask;
import org.mechservice.solver.analysis.EquilibriumSource;
import org.mechservice.solver.analysis.LinearSource;
import org.mechservice.solver.analysis.PrescribedSource;
import org.mechservice.solver.analysis.Trim;

/**
 * An analysis without integration in time.
 *
 * @param source class of the solver that a model's class extends, constructed from options and
 *     columns
 * @param options its options as text
 */
public record AnalysisTask(Class<?> source, String options) {
  /** Returns the analysis of a simulation; empty if it is integrated in time. */
  public static Optional<AnalysisTask> of(SimulationTask task) {
    if (task instanceof SimulationTask.StaticEquilibrium rest) {
      return Optional.of(
          new AnalysisTask(
              EquilibriumSource.class,
              rest.tolerance() + " " + rest.maxIterations() + words(rest.trim())));
    } else if (task instanceof SimulationTask.Linearization linear) {
      String at =
          linear.trim().isPresent() ? "trim" : linear.atEquilibrium() ? "equilibrium" : "start";
      String gives = linear.gives().name().toLowerCase(Locale.ROOT);
      String frequencies =
          linear.gives() == SimulationTask.Linearization.Result.RESPONSE
              ? " " + linear.from() + " " + linear.to() + " " + linear.points()
              : "";
      return Optional.of(
          new AnalysisTask(
              LinearSource.class, at + " " + gives + frequencies + words(linear.trim())));
    }
    return task instanceof SimulationTask.Dynamic
        ? Optional.empty()
        : Optional.of(new AnalysisTask(PrescribedSource.class, ""));
  }

  /** Returns the words of a trim problem, each after a blank. */
  private static String words(Optional<SimulationTask.TrimProblem> trim) {
    return trim.map(problem -> " " + Trim.text(problem.unknowns(), problem.conditions()))
        .orElse("");
  }
}
