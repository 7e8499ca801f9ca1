package org.mechservice.solver.api;

import java.util.Set;

/**
 * One run asked for.
 *
 * @param settings interval, output distance, integrator and tolerances
 * @param columns column groups wanted besides time and the joints' states
 */
public record RunRequest(RunSettings settings, Set<ColumnGroup> columns) {
  public RunRequest {
    columns = Set.copyOf(columns);
  }
}
