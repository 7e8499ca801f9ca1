package org.mechservice.sim.model;

import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.SimulationTask;
import org.mechservice.sim.compile.ModelCompiler;
import org.mechservice.sim.emit.AnalysisTask;
import org.mechservice.sim.emit.c.CModel;
import org.mechservice.sim.scene.FormulationChoice;
import org.mechservice.sim.scene.ModelBuildException;
import org.mechservice.sim.user.UserClasses;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.catalogue.MethodNames;
import org.mechservice.solver.mechanism.FurtherState;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * Builds models: generates code from a mechanism, compiles it and loads it. Thread-safe; every step
 * is a pure function of its arguments.
 */
public final class ModelFactory {
  private ModelFactory() {}

  /**
   * Generates the model of a mechanism: code specialised to it, or data for the formulations of the
   * solver if this is requested or no code can be generated. The reason states which.
   *
   * @throws org.mechservice.sim.scene.ModelBuildException (an {@link IllegalArgumentException}) if
   *     the formulation (S-081) or the integrator (S-082) does not fit or exist, or a name cannot
   *     be kept (S-083); the message states the reason and the remedy
   */
  public static GeneratedModel generate(MechmlModel model, BuildOptions options) {
    Mechanism mechanism = model.watchedMechanism();
    GeneratedNames.requireUsable(mechanism);
    Optional<AnalysisTask> task = AnalysisTask.of(model.settings().task());
    if (task.isPresent()) {
      requireNoStates(mechanism, model.settings().task());
      String name = model.settings().task().element();
      FormulationChoice asked =
          new FormulationChoice(name, MethodNames.NONE, "the simulation asks for it");
      return new ModelAssembly(model, options, asked).analysis(task.get());
    }
    String integrator = options.settings().integrator();
    StandaloneMain.requireIntegrator(integrator);
    FormulationChoice resolved =
        FormulationChoice.of(options.formulation(), options.closure(), options.settings(), model);
    FormulationChoice choice =
        options
            .integratorReason()
            .map(why -> resolved.because("; auto: " + integrator + ", since at the start " + why))
            .orElse(resolved);
    return new ModelAssembly(model, options, choice).generated();
  }

  private static void requireNoStates(Mechanism mechanism, SimulationTask task) {
    boolean linear = task instanceof SimulationTask.Linearization about && !about.atEquilibrium();
    boolean oneState =
        task instanceof SimulationTask.Linearization
            || task instanceof SimulationTask.StaticEquilibrium;
    Optional<FurtherState> changing =
        mechanism.furtherStates().stream()
            .filter(
                state ->
                    state.role() == FurtherState.Role.SAMPLED
                        || (state.role() == FurtherState.Role.INTEGRATED && !oneState))
            .findFirst();
    if (!linear && changing.isPresent()) {
      throw new ModelBuildException(
          MessageCode.STATE_NOT_INTEGRATED,
          "the model has states, such as \""
              + changing.get().name()
              + "\", whose values follow from integration in time, and <"
              + task.element()
              + "> does not integrate; simulate the motion, or leave the states out");
    }
  }

  /**
   * Derives a model's code in C. Options that belong to Java, such as the layout, do not matter;
   * the formulation of an open chain is DSR if asked for, else DTR; loops are closed by penalty.
   *
   * @throws org.mechservice.sim.scene.ModelBuildException S-170 if C code cannot express the model;
   *     the message names each part and the remedy
   */
  public static CModel inC(MechmlModel model, BuildOptions options) {
    return inC(model, options, Set.of());
  }

  /**
   * Derives a model's code in C, in which the loads of forces written as classes are inputs.
   *
   * @param asInputs names of these forces
   * @throws org.mechservice.sim.scene.ModelBuildException as above; also if no force written as a
   *     class has one of the names
   */
  public static CModel inC(MechmlModel model, BuildOptions options, Set<String> asInputs) {
    return MechanismInC.derive(model, options, asInputs);
  }

  /**
   * Writes the class file of a generated model and loads it; user classes are loaded with the first
   * instance.
   *
   * @param userClasses classes of the model's user forces
   * @throws org.mechservice.sim.scene.ModelBuildException (an {@link IllegalArgumentException}) if
   *     the class is too large (S-085)
   */
  public static CompiledModel compile(
      MechmlModel model, BuildOptions options, GeneratedModel generated, UserClasses userClasses) {
    return new CompiledModel(model, generated, options, generated.classFiles(), userClasses);
  }

  /** Writes and loads the class of a model without user classes. */
  public static CompiledModel compile(
      MechmlModel model, BuildOptions options, GeneratedModel generated) {
    return compile(model, options, generated, UserClasses.NONE);
  }

  /**
   * Compiles the sources of a generated model in memory. The results are the same bits; tests prove
   * with this method that the source describes the class that runs.
   *
   * @throws org.mechservice.sim.scene.ModelBuildException (an {@link IllegalArgumentException}) if
   *     this JVM has no compiler (S-084) or the class is too large (S-085)
   */
  public static CompiledModel compileSource(
      MechmlModel model, BuildOptions options, GeneratedModel generated) {
    SortedMap<String, String> sources = new TreeMap<>();
    generated.sources().forEach(source -> sources.put(source.className(), source.text()));
    SortedMap<String, byte[]> classFiles = ModelCompiler.compile(sources);
    return new CompiledModel(model, generated, options, classFiles, UserClasses.NONE);
  }
}
