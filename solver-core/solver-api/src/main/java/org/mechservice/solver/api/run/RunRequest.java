package org.mechservice.solver.api.run;

import java.util.OptionalDouble;
import java.util.Set;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * The request of one run.
 *
 * @param settings interval, output distance, integrator and tolerances
 * @param columns column groups besides time and the joints' states
 * @param strict whether the first warning of the model ends the run
 * @param maxDrift drift of the energy balance over the energy scale, both as in {@link RunReport},
 *     above which the run ends as failed; empty if it is not monitored
 * @param silenced warnings that the run does not give
 */
public record RunRequest(
    RunSettings settings,
    Set<ColumnGroup> columns,
    boolean strict,
    OptionalDouble maxDrift,
    Set<MessageCode> silenced) {
  public RunRequest {
    columns = Set.copyOf(columns);
    silenced = Set.copyOf(silenced);
  }

  /** Creates the request of a run that gives all its warnings. */
  public RunRequest(
      RunSettings settings, Set<ColumnGroup> columns, boolean strict, OptionalDouble maxDrift) {
    this(settings, columns, strict, maxDrift, Set.of());
  }

  /** Creates the request of a run that neither warnings nor energy drift end. */
  public RunRequest(RunSettings settings, Set<ColumnGroup> columns) {
    this(settings, columns, false, OptionalDouble.empty());
  }
}
