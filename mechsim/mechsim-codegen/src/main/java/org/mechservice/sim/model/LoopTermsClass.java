package org.mechservice.sim.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.emit.ModelClass;
import org.mechservice.sim.emit.TermsClass;
import org.mechservice.sim.equations.EnergyEquations;
import org.mechservice.sim.equations.PoseEquations;
import org.mechservice.sim.equations.PowerEquations;
import org.mechservice.sim.equations.derivatives.ResidualDerivatives;
import org.mechservice.sim.equations.loop.LoopCode;
import org.mechservice.sim.equations.loop.LoopRecursion;
import org.mechservice.sim.scene.FormulationChoice;
import org.mechservice.sim.scene.GenerationLimits;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.catalogue.Formulation;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.closure.equations.UnwrappedAngles;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.symbol.Program;

/**
 * Generates the code of the terms of a model with loops. The solver closes the loops with these
 * terms.
 */
final class LoopTermsClass {
  private LoopTermsClass() {}

  /** Derives the programs that a formulation and the requested columns need. */
  static TermsClass derive(
      MechmlModel model, Links links, BuildOptions options, FormulationChoice choice) {
    Mechanism mechanism = links.mechanism();
    int rows = new LoopEquations(new TreeGeometry(mechanism)).count();
    boolean recursive = GenerationLimits.isRecursive(mechanism);
    Program loops = recursive ? LoopRecursion.loops(links, rows) : LoopCode.loops(links, rows);
    Program equations =
        recursive ? LoopRecursion.accelerations(links, rows) : LoopCode.equations(links, rows);
    Optional<TermsClass.OfResidual> ofResidual =
        Formulation.of(choice.formulation()).isResidual()
            ? Optional.of(
                new TermsClass.OfResidual(
                    LoopCode.offset(links, rows),
                    LoopCode.residual(links),
                    derivatives(links, choice)))
            : Optional.empty();
    return new TermsClass(
        mechanism.name(),
        ModelClass.hasUserForces(mechanism),
        recursive,
        mechanism.stateCount() + UnwrappedAngles.of(mechanism).size(),
        links.velocityCount(),
        loops,
        equations,
        EnergyEquations.derive(links),
        PowerEquations.ofForces(links),
        options.columns().contains(ColumnGroup.BODIES)
            ? Optional.of(PoseEquations.derive(links))
            : Optional.empty(),
        mechanism.furtherStates().isEmpty()
            ? Optional.empty()
            : Optional.of(LoopCode.further(links)),
        ofResidual,
        notes(
            choice,
            recursive,
            loops,
            equations,
            ofResidual,
            Omissions.unneeded(model, links, options, equations)));
  }

  /** Returns the part that data evaluate at least as fast as code, if there is one. */
  static List<String> noFaster(TermsClass terms, FormulationChoice choice) {
    if (!terms.recursive()) {
      return GenerationLimits.noFaster(choice.formulation(), terms.equations().operationCount());
    }
    return terms.equations().hasOutputs()
        ? List.of()
        : List.of("large loops with a joint that moves no inertia while the loops are open");
  }

  /** Derives the program of the derivatives; user force classes add their own. */
  private static Optional<Program> derivatives(Links links, FormulationChoice choice) {
    return Formulation.of(choice.formulation()).hasRecursiveJacobian()
        ? Optional.of(ResidualDerivatives.ofLoops(links))
        : Optional.empty();
  }

  private static List<String> notes(
      FormulationChoice choice,
      boolean recursive,
      Program loops,
      Program equations,
      Optional<TermsClass.OfResidual> ofResidual,
      List<Omission> leftOut) {
    List<String> notes = new ArrayList<>();
    notes.add("Formulation " + choice.formulation() + " (" + choice.reason() + ").");
    notes.add(
        equations.operationCount()
            + " additions, multiplications and divisions give the "
            + (recursive ? "accelerations, " : "terms of the equations of motion, ")
            + loops.operationCount()
            + " those of the loops alone.");
    ofResidual.ifPresent(
        programs ->
            notes.add(programs.residual().operationCount() + " give the residual of the tree."));
    notes.add(Omissions.sentence(leftOut));
    return notes;
  }
}
