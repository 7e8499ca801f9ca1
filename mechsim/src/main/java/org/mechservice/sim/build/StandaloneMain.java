package org.mechservice.sim.build;

import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.mechservice.sim.build.emit.ModelClass;
import org.mechservice.sim.build.javac.ModelCompiler;
import org.mechservice.sim.scene.ModelBuildException;

/** The main class of a standalone JAR: it joins one model and one integrator. */
final class StandaloneMain {
  private static final String INTEGRATION = "org.mechservice.solver.integration.";

  /** Class of each integrator by its name in settings. */
  private static final Map<String, String> INTEGRATORS = Map.of("DE", "De", "ode113", "Ode113");

  private StandaloneMain() {}

  /**
   * @throws ModelBuildException S-082 if there is no such integrator in this version
   */
  static void requireIntegrator(String name) {
    if (!INTEGRATORS.containsKey(name)) {
      throw new ModelBuildException(
          "S-082", "integrator \"" + name + "\" is not in this version; use ode113 or DE");
    }
  }

  /** Returns the fully qualified name of the main class of a model. */
  static String className(GeneratedModel model) {
    return model.className() + "Main";
  }

  /** Compiles the main class; it implements the factory itself, which spares a lambda. */
  static SortedMap<String, byte[]> compile(CompiledModel model) {
    String className = className(model.generated());
    SortedMap<String, byte[]> classes = new TreeMap<>(model.classFiles());
    classes.putAll(ModelCompiler.compile(className, source(model), model.classFiles()));
    return classes;
  }

  private static String source(CompiledModel model) {
    String modelClass = simpleName(model.generated().className());
    String name = simpleName(className(model.generated()));
    String integrator = INTEGRATORS.getOrDefault(model.options().settings().integrator(), "");
    return """
        package %s;

        import %s%s;
        import org.mechservice.solver.integration.Integrator;
        import org.mechservice.solver.integration.IntegratorFactory;
        import org.mechservice.solver.integration.IntegratorSettings;
        import org.mechservice.solver.standalone.Standalone;

        public final class %s implements IntegratorFactory {
          @Override
          public Integrator create(IntegratorSettings settings) {
            return new %s(settings);
          }

          public static void main(String[] args) {
            System.exit(Standalone.run(new %s(), new %s(), args));
          }
        }
        """
        .formatted(ModelClass.PACKAGE, INTEGRATION, integrator, name, integrator, modelClass, name);
  }

  private static String simpleName(String className) {
    return className.substring(className.lastIndexOf('.') + 1);
  }
}
