package org.mechservice.sim.model;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.IntSupplier;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.emit.AnalysisTask;
import org.mechservice.sim.emit.CompactClass;
import org.mechservice.sim.emit.GeneratedClass;
import org.mechservice.sim.emit.ModelClass;
import org.mechservice.sim.emit.ModelPlan;
import org.mechservice.sim.emit.TermsClass;
import org.mechservice.sim.emit.TermsPlan;
import org.mechservice.sim.emit.plan.CodeForm;
import org.mechservice.sim.equations.derivatives.ResidualDerivatives;
import org.mechservice.sim.scene.FormulationChoice;
import org.mechservice.sim.scene.GenerationLimits;
import org.mechservice.sim.scene.ModelBuildException;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.catalogue.Formulation;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.closure.assembly.ClosedStart;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.joint.StartRole;
import org.mechservice.solver.symbol.Program;

/**
 * Assembles a model after its formulation is chosen: generated code, and data for the parts that
 * the code does not compute, or data alone.
 */
final class ModelAssembly {
  /**
   * Number of operations below which every class is small enough. A larger class may have to be
   * written twice, which takes long.
   */
  private static final int SURELY_WRITTEN = 20_000;

  private final MechmlModel model;
  private final Mechanism mechanism;
  private final BuildOptions options;
  private final FormulationChoice choice;

  ModelAssembly(MechmlModel model, BuildOptions options, FormulationChoice choice) {
    this.model = model;
    this.mechanism = model.mechanism();
    this.options = options;
    this.choice = choice;
  }

  /**
   * Returns the model, generated if this is requested and possible; its reason states which.
   *
   * @throws ModelBuildException S-092 if the loops cannot be closed at the start
   */
  GeneratedModel generated() {
    Mechanism watched = model.watchedMechanism();
    IntSupplier independent = () -> model.closedStart(options.settings().tStart()).rank();
    List<String> beyond =
        options.form() == CodeForm.AUTO
            ? GenerationLimits.leftToData(watched, choice, independent)
            : GenerationLimits.notGenerated(watched, choice, independent);
    boolean open = mechanism.closures().isEmpty();
    if (!open) {
      requireClosedLoops();
    }
    return options.compact() || !beyond.isEmpty() ? compact(beyond) : open ? tree() : looped();
  }

  /** Returns a model for an analysis other than integration in time; its data name the analysis. */
  GeneratedModel analysis(AnalysisTask task) {
    Set<ColumnGroup> further = ModelColumns.fromData(model, options, false);
    further.add(ColumnGroup.JOINTS);
    CompactClass data = data(further, Optional.empty(), Optional.empty(), Optional.of(task));
    return ofData(data, choice);
  }

  private GeneratedModel compact(List<String> beyond) {
    String form =
        beyond.isEmpty()
            ? "compact form, as asked for"
            : "compact form, since no code is generated yet for " + String.join(", ", beyond);
    Set<ColumnGroup> further =
        ModelColumns.fromData(model, options, mechanism.closures().isEmpty());
    CompactClass data = data(further, Optional.empty(), Optional.empty(), Optional.empty());
    return ofData(data, choice.because("; " + form));
  }

  private GeneratedModel ofData(CompactClass data, FormulationChoice reason) {
    Optional<CompactClass> none = Optional.empty();
    return assembled(data, none, Optional.empty(), reason, 0, List.of(), List.of());
  }

  /**
   * Checks that the loops can be closed at the start.
   *
   * @throws ModelBuildException S-092 if they cannot
   */
  void requireClosedLoops() {
    ClosedStart start = model.closedStart(options.settings().tStart());
    if (!start.isAssembled()) {
      throw new ModelBuildException(
          MessageCode.LOOPS_OPEN_AT_START,
          start.findings().stream()
              .filter(finding -> !finding.kind().isWarning())
              .map(finding -> finding.note().text())
              .collect(Collectors.joining(" ", "", " " + wayToClose())));
    }
  }

  /**
   * Returns advice on loops that do not close. Assembly cannot move driven and fixed joints, of
   * which there is often one too many.
   */
  private String wayToClose() {
    String held =
        IntStream.range(0, mechanism.joints().size())
            .filter(j -> mechanism.isDriven(j) || mechanism.startRoles().get(j) == StartRole.FIXED)
            .mapToObj(j -> "\"" + mechanism.joints().get(j).name() + "\"")
            .collect(Collectors.joining(", "));
    return held.isEmpty()
        ? "Check the lengths in this loop, and start nearer to a position that closes it."
        : "Check the lengths in this loop, start nearer to a position that closes it, or let joints"
            + " move that are driven or fixed: "
            + held
            + ".";
  }

  private GeneratedModel assembled(
      GeneratedClass written,
      Optional<CompactClass> beside,
      Optional<GeneratedClass> values,
      FormulationChoice reason,
      int operations,
      List<Omission> leftOut,
      List<Omission> fromData) {
    return new GeneratedModel(
        written,
        beside,
        values,
        mechanism.name(),
        choice.formulation(),
        reason.reason(),
        operations,
        leftOut,
        fromData);
  }

  /**
   * @param further columns that are computed from the data
   * @param generated class of the equations; empty for a data-driven model
   * @param values class of triggers and assignments of events and of outputs, if they are code
   */
  private CompactClass data(
      Set<ColumnGroup> further,
      Optional<GeneratedClass> generated,
      Optional<GeneratedClass> values,
      Optional<AnalysisTask> task) {
    return new CompactClass(
        ModelColumns.data(model, options, choice, further),
        ModelColumns.labels(further),
        generated,
        values,
        task);
  }

  private GeneratedModel tree() {
    Links links = Links.of(mechanism);
    Program derivative = TreeClass.derivative(links, choice);
    int operations = derivative.operationCount();
    List<String> noFaster = GenerationLimits.noFaster(choice.formulation(), operations);
    if (!noFaster.isEmpty()) {
      return compact(noFaster);
    }
    Optional<ResidualDerivatives.Derived> derivatives =
        Formulation.of(choice.formulation()).hasRecursiveJacobian()
            ? Optional.of(ResidualDerivatives.derive(links))
            : Optional.empty();
    List<String> tooLong =
        GenerationLimits.tooLong(
            derivatives.map(derived -> derived.program().operationCount()).orElse(0));
    if (!tooLong.isEmpty()) {
      return compact(tooLong);
    }
    List<Omission> leftOut = Omissions.unneeded(model, links, options, derivative);
    ModelPlan written =
        ModelPlan.of(
            TreeClass.derive(links, options, choice, derivative, derivatives, leftOut),
            options.form());
    List<String> tooLarge = tooLarge(written, operations);
    if (!tooLarge.isEmpty()) {
      return compact(tooLarge);
    }
    Set<ColumnGroup> further =
        ModelColumns.fromData(model, options, !ModelClass.hasUserForces(mechanism));
    ValuesClass.Derived values = ValuesClass.derive(model, links, options);
    Optional<CompactClass> beside =
        further.isEmpty() && !needsData(model.watchedMechanism())
            ? Optional.empty()
            : Optional.of(data(further, Optional.of(written), values.plan(), Optional.empty()));
    return assembled(
        written,
        beside,
        values.plan(),
        choice.callingForcesOf(mechanism),
        operations,
        leftOut,
        Omissions.fromData(model, further, values.fromData(), Optional.empty()));
  }

  /**
   * Returns whether data are needed in addition to the code: for parameters, user forces and
   * events.
   */
  private static boolean needsData(Mechanism mechanism) {
    return !mechanism.parameters().isEmpty()
        || ModelClass.hasUserForces(mechanism)
        || mechanism.mayChangeAbruptly();
  }

  /** The terms of the equations are code; their closure and rarely used columns come from data. */
  private GeneratedModel looped() {
    Links links = Links.of(mechanism);
    TermsClass terms = LoopTermsClass.derive(model, links, options, choice);
    List<String> noFaster = LoopTermsClass.noFaster(terms, choice);
    if (!noFaster.isEmpty()) {
      return compact(noFaster);
    }
    int ofDerivatives = terms.derivatives().map(Program::operationCount).orElse(0);
    boolean worthIt = GenerationLimits.areWorthCode(ofDerivatives);
    return looped(links, worthIt ? terms : terms.withoutDerivatives());
  }

  /** Returns the model with these terms, without regard to their cost. */
  GeneratedModel looped(Links links, TermsClass terms) {
    GeneratedClass written = TermsPlan.of(terms, options.form());
    int operations = terms.equations().operationCount();
    int ofDerivatives = terms.derivatives().map(Program::operationCount).orElse(0);
    List<String> tooLarge = tooLarge(written, operations + ofDerivatives);
    if (!tooLarge.isEmpty()) {
      return compact(tooLarge);
    }
    boolean leftToData =
        Formulation.of(choice.formulation()).hasRecursiveJacobian()
            && terms.derivatives().isEmpty();
    Optional<String> why =
        leftToData ? Optional.of(GenerationLimits.TOO_LONG_DERIVATIVES) : Optional.empty();
    Set<ColumnGroup> further = ModelColumns.fromData(model, options, false);
    ValuesClass.Derived values = ValuesClass.derive(model, links, options);
    return assembled(
        written,
        Optional.of(data(further, Optional.of(written), values.plan(), Optional.empty())),
        values.plan(),
        choice.callingForcesOf(mechanism),
        operations,
        Omissions.unneeded(model, links, options, terms.equations()),
        Omissions.fromData(model, further, values.fromData(), why));
  }

  /**
   * Returns the reason why a class is too large, found by writing it: the limit depends on joints
   * and forces.
   */
  private static List<String> tooLarge(GeneratedClass written, int operations) {
    if (operations < SURELY_WRITTEN) {
      return List.of();
    }
    try {
      written.classFile();
      return List.of();
    } catch (ModelBuildException e) {
      return List.of("so large a scene (" + e.getMessage() + ")");
    }
  }
}
