package org.mechservice.solver.api.run;

import java.util.OptionalDouble;
import java.util.Set;
import org.mechservice.solver.api.result.ColumnGroup;

/**
 * One run asked for.
 *
 * @param settings interval, output distance, integrator and tolerances
 * @param columns column groups wanted besides time and the joints' states
 * @param strict whether the first warning of the model ends the run
 * @param maxDrift drift of the energy balance over the energy scale, both as in {@link RunReport},
 *     above which the run ends as failed; empty: it is not watched
 */
public record RunRequest(
    RunSettings settings, Set<ColumnGroup> columns, boolean strict, OptionalDouble maxDrift) {
  public RunRequest {
    columns = Set.copyOf(columns);
  }

  /** A run that goes on whatever there is to warn of, and however its energy drifts. */
  public RunRequest(RunSettings settings, Set<ColumnGroup> columns) {
    this(settings, columns, false, OptionalDouble.empty());
  }
}
