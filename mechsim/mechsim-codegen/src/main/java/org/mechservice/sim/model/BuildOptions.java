package org.mechservice.sim.model;

import java.util.Optional;
import java.util.Set;
import org.mechservice.sim.emit.plan.CodeForm;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MethodNames;

/**
 * Options for building a model.
 *
 * @param formulation {@code auto}, {@code DTR}, {@code DSR}, {@code RR} or {@code RR-JF}
 * @param closure closure of loops: {@code auto}, {@code projection} or {@code penalty}
 * @param compact whether the model consists of data instead of generated code
 * @param form layout of generated code
 * @param columns column groups that the model can output
 * @param settings default settings of the model, with {@code auto} already resolved
 * @param integratorReason reason for the integrator that {@code auto} chose; empty if the
 *     integrator was requested by name, or is chosen during the run
 */
public record BuildOptions(
    String formulation,
    String closure,
    boolean compact,
    CodeForm form,
    Set<ColumnGroup> columns,
    RunSettings settings,
    Optional<String> integratorReason) {
  public BuildOptions {
    columns = Set.copyOf(columns);
  }

  /** Creates options with an integrator requested by name. */
  public BuildOptions(
      String formulation,
      String closure,
      boolean compact,
      Set<ColumnGroup> columns,
      RunSettings settings) {
    this(formulation, closure, compact, CodeForm.AUTO, columns, settings, Optional.empty());
  }

  /** Returns the same options with another layout of the code. */
  public BuildOptions in(CodeForm wanted) {
    return new BuildOptions(
        formulation, closure, compact, wanted, columns, settings, integratorReason);
  }

  /** Creates options with generated code wherever possible and automatic closure. */
  public BuildOptions(String formulation, Set<ColumnGroup> columns, RunSettings settings) {
    this(formulation, MethodNames.AUTO, false, columns, settings);
  }
}
