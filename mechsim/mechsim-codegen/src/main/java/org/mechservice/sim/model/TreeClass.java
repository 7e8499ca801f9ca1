package org.mechservice.sim.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.sim.emit.ModelClass;
import org.mechservice.sim.equations.ArticulatedBodyEquations;
import org.mechservice.sim.equations.CompositeInertiaEquations;
import org.mechservice.sim.equations.EnergyEquations;
import org.mechservice.sim.equations.PoseEquations;
import org.mechservice.sim.equations.PowerEquations;
import org.mechservice.sim.equations.RecursiveResidualEquations;
import org.mechservice.sim.equations.derivatives.ResidualDerivatives;
import org.mechservice.sim.scene.FormulationChoice;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.catalogue.Formulation;
import org.mechservice.solver.force.formula.ForceFormulas;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.symbol.Program;

/** Derives the class of an open chain. */
final class TreeClass {
  private TreeClass() {}

  /** Derives y' of an open chain in a formulation. */
  static Program derivative(Links links, FormulationChoice choice) {
    return switch (Formulation.of(choice.formulation())) {
      case DSR -> CompositeInertiaEquations.derive(links);
      // Residual formulations take their accelerations from it too.
      case DTR, RR, RR_JF -> ArticulatedBodyEquations.derive(links);
    };
  }

  /**
   * Derives the further programs that a formulation and the requested columns need.
   *
   * @param derivative program of the derivative of the state
   * @param derivatives program of the derivatives of the residual, if the formulation has them
   * @param leftOut parts that the scene does not need, for the class comment
   */
  static ModelClass derive(
      Links links,
      BuildOptions options,
      FormulationChoice choice,
      Program derivative,
      Optional<ResidualDerivatives.Derived> derivatives,
      List<Omission> leftOut) {
    Mechanism mechanism = links.mechanism();
    Optional<Program> residual =
        Formulation.of(choice.formulation()).isResidual()
            ? Optional.of(RecursiveResidualEquations.derive(links))
            : Optional.empty();
    return new ModelClass(
        mechanism,
        description(mechanism, choice, options),
        derivative,
        residual,
        derivatives,
        EnergyEquations.derive(links),
        options.columns().contains(ColumnGroup.BODIES)
            ? Optional.of(PoseEquations.derive(links))
            : Optional.empty(),
        PowerEquations.power(links),
        forceValues(links, options),
        formulaParts(links),
        notes(choice, derivative, residual, derivatives, leftOut));
  }

  private static Optional<ModelClass.FormulaParts> formulaParts(Links links) {
    return ForceFormulas.of(links.mechanism())
        .map(
            parts ->
                new ModelClass.FormulaParts(
                    parts.lines(),
                    parts.expressions().size(),
                    PowerEquations.formulas(links, parts.expressions())));
  }

  private static Optional<ModelClass.ForceValues> forceValues(Links links, BuildOptions options) {
    List<Variable> columns = ForceColumnNames.of(links.mechanism());
    return columns.isEmpty()
            || ModelClass.hasUserForces(links.mechanism())
            || !options.columns().contains(ColumnGroup.FORCES)
        ? Optional.empty()
        : Optional.of(new ModelClass.ForceValues(columns, PowerEquations.values(links)));
  }

  private static ModelDescription description(
      Mechanism mechanism, FormulationChoice choice, BuildOptions options) {
    return new ModelDescription(
        mechanism.name(),
        choice.formulation(),
        ModelClass.joints(mechanism),
        mechanism.stateVariables(),
        options.settings());
  }

  private static List<String> notes(
      FormulationChoice choice,
      Program derivative,
      Optional<Program> residual,
      Optional<ResidualDerivatives.Derived> derivatives,
      List<Omission> leftOut) {
    List<String> notes = new ArrayList<>();
    notes.add("Formulation " + choice.formulation() + " (" + choice.reason() + ").");
    notes.add(
        derivative.operationCount()
            + " additions, multiplications and divisions give the derivative of the state.");
    residual.ifPresent(program -> notes.add(program.operationCount() + " give the residual."));
    derivatives.ifPresent(
        derived -> notes.add(derived.program().operationCount() + " give its derivatives."));
    notes.add(Omissions.sentence(leftOut));
    return notes;
  }
}
