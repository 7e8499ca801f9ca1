package org.mechservice.sim.build;

import java.util.Set;
import org.mechservice.solver.api.ColumnGroup;
import org.mechservice.solver.api.RunSettings;

/**
 * What a model is to be built for.
 *
 * @param formulation {@code auto} or {@code DTR}
 * @param columns column groups it must be able to put out
 * @param settings the settings it carries as its defaults, with {@code auto} already resolved
 */
public record BuildOptions(String formulation, Set<ColumnGroup> columns, RunSettings settings) {
  public BuildOptions {
    columns = Set.copyOf(columns);
  }
}
