package org.mechservice.mechml;

import java.util.List;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MethodNames;
import org.mechservice.solver.mechanism.Event;

/**
 * The settings of one simulation block of the file.
 *
 * @param name the block's name; empty if it has none
 * @param task kind of computation
 * @param run interval, output distance, integrator, tolerances; the integrator has the name given
 *     in the file, {@code auto} where the task needs none; a task without time set is at time 0
 * @param absoluteTolerances by class of state
 * @param formulation formulation given in the file; {@code auto} if there is none
 * @param closure loop closure given in the file; {@code auto} if there is none
 * @param columns additional groups of result columns
 * @param events events at zeros of expressions, in file order
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
          "momentum",
          "drives");

  public SimulationSettings {
    columns = List.copyOf(columns);
    events = List.copyOf(events);
  }

  /** Returns the same settings with another interval, integrator or tolerances. */
  public SimulationSettings with(RunSettings other) {
    return new SimulationSettings(
        name, task, other, absoluteTolerances, formulation, closure, columns, events);
  }

  /** Returns the same settings with another formulation, or {@code auto}. */
  public SimulationSettings withFormulation(String other) {
    return new SimulationSettings(
        name, task, run, absoluteTolerances, other, closure, columns, events);
  }

  /** Returns the same settings with another closure of loops, or {@code auto}. */
  public SimulationSettings withClosure(String other) {
    return new SimulationSettings(
        name, task, run, absoluteTolerances, formulation, other, columns, events);
  }

  /** Returns the same settings with other groups of result columns, by their labels. */
  public SimulationSettings withColumns(List<String> other) {
    return new SimulationSettings(
        name, task, run, absoluteTolerances, formulation, closure, other, events);
  }

  /** Creates the settings of a dynamic simulation with defaults for everything else. */
  public SimulationSettings(RunSettings run, String formulation) {
    this(
        "",
        new SimulationTask.Dynamic(),
        run,
        AbsoluteTolerances.uniform(run.absoluteTolerance()),
        formulation,
        MethodNames.AUTO,
        List.of(),
        List.of());
  }
}
