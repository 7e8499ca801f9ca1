package org.mechservice.sim.model;

import java.util.SortedMap;
import java.util.TreeMap;
import org.mechservice.mechml.SimulationTask;
import org.mechservice.sim.emit.MainClass;
import org.mechservice.sim.scene.ModelBuildException;
import org.mechservice.solver.catalogue.IntegrationMethod;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.simulation.RuntimeSolver;

/** The main class of a standalone JAR: it joins one model and one integrator. */
public final class StandaloneMain {
  private StandaloneMain() {}

  /**
   * @throws ModelBuildException S-082 if there is no such integrator in this version
   */
  static void requireIntegrator(String name) {
    if (IntegrationMethod.find(name).isEmpty()) {
      throw new ModelBuildException(
          MessageCode.INTEGRATOR_NOT_AVAILABLE,
          "integrator \""
              + name
              + "\" is not in this version; use "
              + IntegrationMethod.listed().replace(" and ", " or "));
    }
  }

  /** Returns the fully qualified name of the main class of a model. */
  public static String className(GeneratedFacts model) {
    return model.className() + "Main";
  }

  /** Returns the model's classes with the main class, by binary name. */
  public static SortedMap<String, byte[]> classFiles(CompiledModel model) {
    SortedMap<String, byte[]> classes = new TreeMap<>(model.classFiles());
    classes.put(className(model.generated()), main(model));
    return classes;
  }

  private static byte[] main(CompiledModel model) {
    String built = ModelColumns.labels(ModelColumns.of(model));
    String shown = ModelColumns.labels(ModelColumns.shown(model));
    String name = className(model.generated());
    if (!(model.source().settings().task() instanceof SimulationTask.Dynamic)) {
      return MainClass.ofAnalysis(name, model.generated().className(), built, shown);
    }
    String integrator = model.options().settings().integrator();
    return MainClass.of(
        name,
        model.generated().className(),
        IntegrationMethod.of(integrator).className(),
        model.hasUserClasses(),
        RuntimeSolver.formOf(model.withoutUserClasses(), integrator),
        built,
        shown);
  }
}
