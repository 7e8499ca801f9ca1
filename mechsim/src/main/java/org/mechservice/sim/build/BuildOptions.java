package org.mechservice.sim.build;

import java.util.Set;
import org.mechservice.solver.api.ColumnGroup;
import org.mechservice.solver.api.RunSettings;

/**
 * What a model is to be built for.
 *
 * @param formulation {@code auto}, {@code DTR}, {@code DSR}, {@code RR} or {@code RR-JF}
 * @param closure how loops are closed: {@code auto}, {@code projection} or {@code penalty}
 * @param compact whether the model is to carry data instead of generated code
 * @param columns column groups it must be able to put out
 * @param settings the settings it carries as its defaults, with {@code auto} already resolved
 */
public record BuildOptions(
    String formulation,
    String closure,
    boolean compact,
    Set<ColumnGroup> columns,
    RunSettings settings) {
  public BuildOptions {
    columns = Set.copyOf(columns);
  }

  /** Generated code wherever there is some, loops closed as suits them. */
  public BuildOptions(String formulation, Set<ColumnGroup> columns, RunSettings settings) {
    this(formulation, "auto", false, columns, settings);
  }
}
