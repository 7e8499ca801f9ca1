package org.mechservice.mechml;

import java.util.List;
import org.mechservice.solver.api.RunSettings;
import org.mechservice.solver.mechanism.Event;

/**
 * What one of the file's simulation blocks asks for.
 *
 * @param name the block's name; empty if it has none
 * @param task what is to be computed
 * @param run interval, output distance, integrator, tolerances; the integrator as the file names
 *     it, {@code auto} where the task needs none. A task without time set stands at the instant 0
 * @param absoluteTolerances by class of state
 * @param formulation formulation asked for; {@code auto} if the file leaves it open
 * @param closure how loops are closed; {@code auto} if the file leaves it open
 * @param columns groups of result columns beside the joints'
 * @param events what happens at zeros of expressions, in file order
 */
public record SimulationSettings(
    String name,
    SimulationTask task,
    RunSettings run,
    AbsoluteTolerances absoluteTolerances,
    String formulation,
    String closure,
    List<String> columns,
    List<Event> events) {

  /** The groups of columns an {@code output} may name; {@code all} stands for all of them. */
  public static final List<String> COLUMN_GROUPS =
      List.of(
          "joints",
          "accelerations",
          "bodies",
          "energy",
          "constraints",
          "reactions",
          "forces",
          "outputs",
          "momentum");

  public SimulationSettings {
    columns = List.copyOf(columns);
    events = List.copyOf(events);
  }

  /** Settings of a dynamic simulation that leaves everything else open. */
  public SimulationSettings(RunSettings run, String formulation) {
    this(
        "",
        new SimulationTask.Dynamic(),
        run,
        AbsoluteTolerances.uniform(run.absoluteTolerance()),
        formulation,
        "auto",
        List.of(),
        List.of());
  }
}
