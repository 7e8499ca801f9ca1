package org.mechservice.solver.api.run;

import java.util.OptionalDouble;
import java.util.Set;
import org.mechservice.solver.api.result.ColumnGroup;

/**
 * The request of one run.
 *
 * @param settings interval, output distance, integrator and tolerances
 * @param columns column groups besides time and the joints' states
 * @param strict whether the first warning of the model ends the run
 * @param maxDrift drift of the energy balance over the energy scale, both as in {@link RunReport},
 *     above which the run ends as failed; empty if it is not monitored
 */
public record RunRequest(
    RunSettings settings, Set<ColumnGroup> columns, boolean strict, OptionalDouble maxDrift) {
  public RunRequest {
    columns = Set.copyOf(columns);
  }

  /** Creates the request of a run that neither warnings nor energy drift end. */
  public RunRequest(RunSettings settings, Set<ColumnGroup> columns) {
    this(settings, columns, false, OptionalDouble.empty());
  }
}
