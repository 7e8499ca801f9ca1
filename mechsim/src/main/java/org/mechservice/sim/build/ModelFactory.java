package org.mechservice.sim.build;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.build.dynamics.ArticulatedBodyEquations;
import org.mechservice.sim.build.dynamics.CompositeInertiaEquations;
import org.mechservice.sim.build.dynamics.EnergyEquations;
import org.mechservice.sim.build.dynamics.Links;
import org.mechservice.sim.build.dynamics.PoseEquations;
import org.mechservice.sim.build.dynamics.PowerEquations;
import org.mechservice.sim.build.dynamics.ResidualDerivatives;
import org.mechservice.sim.build.dynamics.ResidualEquations;
import org.mechservice.sim.build.emit.AnalysisTask;
import org.mechservice.sim.build.emit.CompactClass;
import org.mechservice.sim.build.emit.ModelClass;
import org.mechservice.sim.build.emit.ModelPlan;
import org.mechservice.sim.build.emit.TermsClass;
import org.mechservice.sim.build.emit.TermsPlan;
import org.mechservice.sim.build.emit.WrittenClass;
import org.mechservice.sim.build.jar.Packing;
import org.mechservice.sim.build.javac.ModelCompiler;
import org.mechservice.sim.build.user.UserClasses;
import org.mechservice.sim.scene.FormulationChoice;
import org.mechservice.sim.scene.GenerationLimits;
import org.mechservice.sim.scene.ModelBuildException;
import org.mechservice.sim.scene.SceneAnalysis;
import org.mechservice.sim.symbolic.Program;
import org.mechservice.solver.api.ColumnGroup;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.Variable;
import org.mechservice.solver.closure.ClosedMechanism;
import org.mechservice.solver.force.ForceFormulas;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * The way from a mechanism to code: generate, compile, pack. Thread-safe; every step is a pure
 * function of its arguments.
 */
public final class ModelFactory {
  /** Operations below which no class was ever too large; writing such a one twice takes long. */
  private static final int SURELY_WRITTEN = 20_000;

  private ModelFactory() {}

  /**
   * Writes the model class of a mechanism: code specialised to it, or, where that is asked for or
   * no code is generated yet, data for the formulations of the solver; the reason says which.
   *
   * @throws org.mechservice.sim.scene.ModelBuildException (an {@link IllegalArgumentException}) if
   *     the formulation (S-081) or the integrator (S-082) does not fit or exist, or a name cannot
   *     be kept (S-083); the message says why and what does
   */
  public static GeneratedModel generate(MechmlModel model, BuildOptions options) {
    Mechanism mechanism = model.watchedMechanism();
    ModelNames.requireUsable(mechanism);
    Optional<AnalysisTask> task = AnalysisTask.of(model.settings().task());
    if (task.isPresent()) {
      return analysis(model, options, task);
    }
    String integrator = options.settings().integrator();
    StandaloneMain.requireIntegrator(integrator);
    FormulationChoice resolved =
        FormulationChoice.of(
            options.formulation(), options.closure(), options.settings(), mechanism);
    FormulationChoice choice =
        options
            .integratorReason()
            .map(why -> resolved.because("; auto: " + integrator + ", since at the start " + why))
            .orElse(resolved);
    List<String> notGenerated = GenerationLimits.notGenerated(mechanism, choice);
    return options.compact() || !notGenerated.isEmpty()
        ? compact(model, options, choice, notGenerated)
        : mechanism.closures().isEmpty()
            ? specialised(model, options, choice)
            : looped(model, options, choice);
  }

  /** Returns a model that is not integrated; its data say what is done with it. */
  private static GeneratedModel analysis(
      MechmlModel model, BuildOptions options, Optional<AnalysisTask> task) {
    String name = model.settings().task().element();
    FormulationChoice choice = new FormulationChoice(name, "none", "the simulation asks for it");
    Set<ColumnGroup> further = DataColumns.of(model, options, false);
    further.add(ColumnGroup.JOINTS);
    return new GeneratedModel(
        new CompactClass(
            DataColumns.data(model, options, choice, further),
            BuiltColumns.labels(further),
            "",
            task),
        Optional.empty(),
        model.mechanism().name(),
        name,
        choice.reason(),
        0,
        List.of());
  }

  private static GeneratedModel compact(
      MechmlModel model,
      BuildOptions options,
      FormulationChoice choice,
      List<String> notGenerated) {
    Mechanism mechanism = model.mechanism();
    requireClosedLoops(mechanism, choice, options);
    boolean open = mechanism.closures().isEmpty();
    Set<ColumnGroup> further = DataColumns.of(model, options, open);
    String form =
        notGenerated.isEmpty()
            ? "compact form, as asked for"
            : "compact form, since no code is generated yet for " + String.join(", ", notGenerated);
    return new GeneratedModel(
        new CompactClass(
            DataColumns.data(model, options, choice, further),
            BuiltColumns.labels(further),
            "",
            Optional.empty()),
        Optional.empty(),
        mechanism.name(),
        choice.formulation(),
        choice.reason() + "; " + form,
        0,
        List.of());
  }

  /**
   * @throws ModelBuildException S-092 if the loops cannot be closed at the start
   */
  private static void requireClosedLoops(
      Mechanism mechanism, FormulationChoice choice, BuildOptions options) {
    ClosedMechanism closed =
        new ClosedMechanism(mechanism, choice.formulation(), options.settings());
    if (!closed.isAssembled()) {
      throw new ModelBuildException(
          "S-092",
          closed.findings().stream()
              .filter(finding -> !finding.kind().isWarning())
              .map(finding -> finding.note().text())
              .collect(Collectors.joining(" ")));
    }
  }

  private static GeneratedModel specialised(
      MechmlModel model, BuildOptions options, FormulationChoice choice) {
    Mechanism mechanism = model.mechanism();
    SceneAnalysis scene = SceneAnalysis.of(mechanism);
    Links links = Links.of(mechanism);
    Program derivative = derivative(links, choice);
    List<String> noFaster =
        GenerationLimits.noFaster(choice.formulation(), derivative.operationCount());
    if (!noFaster.isEmpty()) {
      return compact(model, options, choice, noFaster);
    }
    Optional<Program> residual =
        choice.formulation().startsWith("RR")
            ? Optional.of(ResidualEquations.derive(links))
            : Optional.empty();
    Optional<ResidualDerivatives.Derived> derivatives =
        choice.formulation().equals("RR-JF")
            ? Optional.of(ResidualDerivatives.derive(links))
            : Optional.empty();
    List<String> tooLong =
        GenerationLimits.tooLong(
            derivatives.map(derived -> derived.program().operationCount()).orElse(0));
    if (!tooLong.isEmpty()) {
      return compact(model, options, choice, tooLong);
    }
    List<Omission> leftOut = LeftOut.of(model, scene, links, options, derivative);
    ModelClass written =
        new ModelClass(
            mechanism,
            description(mechanism, choice, options),
            derivative,
            residual,
            derivatives,
            EnergyEquations.derive(links),
            options.columns().contains(ColumnGroup.BODIES) && !ModelClass.hasUserForces(mechanism)
                ? Optional.of(PoseEquations.derive(links))
                : Optional.empty(),
            PowerEquations.power(links),
            forceValues(links, options),
            formulaParts(links),
            notes(choice, derivative, residual, derivatives, leftOut));
    ModelPlan plan = ModelPlan.of(written);
    List<String> tooLarge = tooLarge(plan, derivative.operationCount());
    if (!tooLarge.isEmpty()) {
      return compact(model, options, choice, tooLarge);
    }
    Set<ColumnGroup> further = DataColumns.of(model, options, !ModelClass.hasUserForces(mechanism));
    return new GeneratedModel(
        plan,
        further.isEmpty() && !needsData(model.watchedMechanism())
            ? Optional.empty()
            : Optional.of(
                new CompactClass(
                    DataColumns.data(model, options, choice, further),
                    BuiltColumns.labels(further),
                    written.simpleName(),
                    Optional.empty())),
        mechanism.name(),
        choice.formulation(),
        choice.callingForcesOf(mechanism).reason(),
        derivative.operationCount(),
        leftOut);
  }

  /** Tries to write a large class: how many bodies fit depends on their joints and forces. */
  private static List<String> tooLarge(WrittenClass written, int operations) {
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

  /** Derives y' of an open chain in a formulation. */
  static Program derivative(Links links, FormulationChoice choice) {
    return choice.formulation().equals("DSR")
        ? CompositeInertiaEquations.derive(links)
        : ArticulatedBodyEquations.derive(links);
  }

  /** Code for the terms of the equations; their closure, and what is seldom wanted, from data. */
  private static GeneratedModel looped(
      MechmlModel model, BuildOptions options, FormulationChoice choice) {
    Mechanism mechanism = model.mechanism();
    requireClosedLoops(mechanism, choice, options);
    Links links = Links.of(mechanism);
    TermsClass terms = LoopTermsClass.derive(links, choice);
    List<String> noFaster =
        GenerationLimits.noFaster(choice.formulation(), terms.equations().operationCount());
    if (!noFaster.isEmpty()) {
      return compact(model, options, choice, noFaster);
    }
    TermsPlan written = TermsPlan.of(terms);
    List<String> tooLarge = tooLarge(written, terms.equations().operationCount());
    if (!tooLarge.isEmpty()) {
      return compact(model, options, choice, tooLarge);
    }
    Set<ColumnGroup> further = DataColumns.of(model, options, false);
    String derivatives =
        choice.formulation().equals("RR-JF") ? "; derivatives of the residual from data" : "";
    return new GeneratedModel(
        written,
        Optional.of(
            new CompactClass(
                DataColumns.data(model, options, choice, further),
                BuiltColumns.labels(further),
                written.simpleName(),
                Optional.empty())),
        mechanism.name(),
        choice.formulation(),
        choice.because(derivatives).callingForcesOf(mechanism).reason(),
        terms.equations().operationCount(),
        LeftOut.of(model, SceneAnalysis.of(mechanism), links, options, terms.equations()));
  }

  /** Parameters, user forces and what happens along a run are kept as data beside the code. */
  private static boolean needsData(Mechanism mechanism) {
    return !mechanism.parameters().isEmpty()
        || ModelClass.hasUserForces(mechanism)
        || !mechanism.events().isEmpty()
        || mechanism.mayJump();
  }

  private static Optional<ModelClass.ForceValues> forceValues(Links links, BuildOptions options) {
    List<Variable> columns = ForceColumns.of(links.mechanism());
    return columns.isEmpty()
            || ModelClass.hasUserForces(links.mechanism())
            || !options.columns().contains(ColumnGroup.FORCES)
        ? Optional.empty()
        : Optional.of(new ModelClass.ForceValues(columns, PowerEquations.values(links)));
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

  private static ModelDescription description(
      Mechanism mechanism, FormulationChoice choice, BuildOptions options) {
    return new ModelDescription(
        mechanism.name(), choice.formulation(), ModelClass.joints(mechanism), options.settings());
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
    StringBuilder list = new StringBuilder("Left out:");
    String separator = " ";
    for (Omission omission : leftOut) {
      list.append(separator)
          .append(omission.what())
          .append(" (")
          .append(omission.why())
          .append(')');
      separator = "; ";
    }
    notes.add(list.append('.').toString());
    return notes;
  }

  /**
   * Writes the class file of a generated model and loads it; classes of users are loaded when it is
   * instantiated.
   *
   * @param userClasses those of the model's forces
   * @throws org.mechservice.sim.scene.ModelBuildException (an {@link IllegalArgumentException}) if
   *     the class is too large (S-085)
   */
  public static CompiledModel compile(
      MechmlModel model, BuildOptions options, GeneratedModel generated, UserClasses userClasses) {
    return new CompiledModel(model, generated, options, generated.classFiles(), userClasses);
  }

  /** Writes and loads the class of a model without classes of users. */
  public static CompiledModel compile(
      MechmlModel model, BuildOptions options, GeneratedModel generated) {
    return compile(model, options, generated, UserClasses.NONE);
  }

  /**
   * Compiles the source of a generated model in memory: another way to the same results, kept as
   * the proof that the source is what runs.
   *
   * @throws org.mechservice.sim.scene.ModelBuildException (an {@link IllegalArgumentException}) if
   *     this JVM has no compiler (S-084) or the class is too large (S-085)
   */
  static CompiledModel compileSource(
      MechmlModel model, BuildOptions options, GeneratedModel generated) {
    SortedMap<String, byte[]> classFiles = new TreeMap<>(generated.classFiles());
    classFiles.putAll(
        ModelCompiler.compile(
            generated.sourceName(), generated.source(), Collections.emptySortedMap()));
    return new CompiledModel(model, generated, options, classFiles, UserClasses.NONE);
  }

  /** Packs the model's own classes, description and manifest; it runs with {@link #runtimeJar}. */
  public static PackedJar modelJar(CompiledModel model, String mechmlSha256, Packing packing) {
    return ModelJars.model(model, mechmlSha256, packing);
  }

  /** Packs the model with just the solver classes it reaches; starts with {@code java -jar}. */
  public static PackedJar standaloneJar(CompiledModel model, String mechmlSha256, Packing packing) {
    return ModelJars.standalone(model, mechmlSha256, packing);
  }

  /** Returns the solver of this process, packed. */
  public static PackedJar runtimeJar() {
    return RuntimeJar.current().jar();
  }
}
