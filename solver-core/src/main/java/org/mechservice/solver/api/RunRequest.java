package org.mechservice.solver.api;

import java.util.Set;

/**
 * One run asked for.
 *
 * @param settings interval, output distance, integrator and tolerances
 * @param columns column groups wanted besides time and the joints' states
 * @param strict whether the first warning of the model ends the run
 */
public record RunRequest(RunSettings settings, Set<ColumnGroup> columns, boolean strict) {
  public RunRequest {
    columns = Set.copyOf(columns);
  }

  /** A run that goes on whatever there is to warn of. */
  public RunRequest(RunSettings settings, Set<ColumnGroup> columns) {
    this(settings, columns, false);
  }
}
