package org.mechservice.library;

import java.util.Optional;
import java.util.SortedMap;
import java.util.function.UnaryOperator;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.SimulationSettings;
import org.mechservice.mechml.SimulationTask;
import org.mechservice.sim.compile.ReusedCode;
import org.mechservice.sim.emit.plan.CodeForm;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.CompiledModel;
import org.mechservice.sim.model.GeneratedModel;
import org.mechservice.sim.model.ModelColumns;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.sim.scene.IntegratorSelection;
import org.mechservice.sim.user.UserClasses;
import org.mechservice.solver.api.ModelSource;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MethodNames;

/**
 * The generated code of a model with some settings. The code that runs in this process is generated
 * once, when it is first needed. May be used by several threads.
 */
final class ModelCode {
  private final MechmlModel model;
  private final UserClasses userClasses;
  private final UnaryOperator<SimulationSettings> changes;
  private Optional<IntegratorSelection> selection = Optional.empty();
  private Optional<CompiledModel> compiled = Optional.empty();

  /**
   * @param changes turns the settings of the file into those of the runs
   */
  ModelCode(MechmlModel model, UserClasses userClasses, UnaryOperator<SimulationSettings> changes) {
    this.model = model;
    this.userClasses = userClasses;
    this.changes = changes;
  }

  /** Returns the settings of the runs; the integrator may be {@code auto}. */
  SimulationSettings settings() {
    return changes.apply(model.settings());
  }

  /** Returns how the runs are integrated, with {@code auto} resolved. */
  RunSettings run() {
    SimulationSettings asked = settings();
    return asked.run().withIntegrator(selection().integrator());
  }

  /** Returns the class files of the classes that forces need, by binary name. */
  SortedMap<String, byte[]> userClassFiles() {
    return userClasses.classFiles();
  }

  /** Returns the integrator; the choice may take a trial, which is made once. */
  private synchronized IntegratorSelection selection() {
    if (selection.isEmpty()) {
      selection = Optional.of(selection(settings()));
    }
    return selection.get();
  }

  private IntegratorSelection selection(SimulationSettings asked) {
    String given = asked.run().integrator();
    if (!(asked.task() instanceof SimulationTask.Dynamic)) {
      return new IntegratorSelection(MethodNames.NONE, Optional.empty());
    }
    return given.equals(MethodNames.AUTO)
        ? IntegratorSelection.of(asked.formulation(), model.mechanism(), asked.run())
        : new IntegratorSelection(given, Optional.empty());
  }

  /**
   * Returns the code for runs in this process. As the service builds it, it has the output times
   * and tolerances of the file: runs that differ in these only share one class.
   *
   * @throws IllegalArgumentException if the model cannot be built so; says why
   */
  synchronized CompiledModel compiled() {
    if (compiled.isEmpty()) {
      compiled = Optional.of(built(model.settings().run()));
    }
    return compiled.get();
  }

  /**
   * Returns the code for a model that goes elsewhere, which has the settings of the runs.
   *
   * @throws IllegalArgumentException if the model cannot be built so; says why
   */
  CompiledModel built() {
    return built(settings().run());
  }

  private CompiledModel built(RunSettings run) {
    BuildOptions options = options(run);
    return ModelFactory.compile(model, options, ModelFactory.generate(model, options), userClasses);
  }

  /** Returns a source of models by classes that are loaded already, unless this code is. */
  ModelSource instances(ReusedCode code) {
    synchronized (this) {
      if (compiled.isPresent() || !userClasses.isEmpty()) {
        return compiled().instances();
      }
    }
    GeneratedModel generated = ModelFactory.generate(model, options(model.settings().run()));
    return code.source(generated.className(), generated.classFiles());
  }

  private BuildOptions options(RunSettings run) {
    SimulationSettings asked = settings();
    IntegratorSelection chosen = selection();
    return new BuildOptions(
        asked.formulation(),
        asked.closure(),
        false,
        CodeForm.AUTO,
        ModelColumns.shown(asked),
        run.withIntegrator(chosen.integrator()),
        chosen.reason());
  }
}
