package org.mechservice.sim.model;

import java.util.Optional;
import java.util.Set;
import org.mechservice.sim.emit.plan.CodeForm;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MethodNames;

/**
 * What a model is to be built for.
 *
 * @param formulation {@code auto}, {@code DTR}, {@code DSR}, {@code RR} or {@code RR-JF}
 * @param closure how loops are closed: {@code auto}, {@code projection} or {@code penalty}
 * @param compact whether the model is to carry data instead of generated code
 * @param form how generated code is laid out
 * @param columns column groups it must be able to put out
 * @param settings the settings it carries as its defaults, with {@code auto} already resolved
 * @param integratorReason why {@code auto} is that integrator; empty if it was asked for, or
 *     decides along the run
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

  /** Options with an integrator given by name. */
  public BuildOptions(
      String formulation,
      String closure,
      boolean compact,
      Set<ColumnGroup> columns,
      RunSettings settings) {
    this(formulation, closure, compact, CodeForm.AUTO, columns, settings, Optional.empty());
  }

  /** The same with code laid out in a form. */
  public BuildOptions in(CodeForm wanted) {
    return new BuildOptions(
        formulation, closure, compact, wanted, columns, settings, integratorReason);
  }

  /** Generated code wherever there is some, loops closed as suits them. */
  public BuildOptions(String formulation, Set<ColumnGroup> columns, RunSettings settings) {
    this(formulation, MethodNames.AUTO, false, columns, settings);
  }
}
