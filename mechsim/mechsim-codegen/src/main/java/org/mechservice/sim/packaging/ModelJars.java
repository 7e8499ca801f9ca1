package org.mechservice.sim.packaging;

import java.nio.charset.StandardCharsets;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.stream.Collectors;
import org.mechservice.sim.compile.ReachableClasses;
import org.mechservice.sim.model.CompiledModel;
import org.mechservice.sim.model.GeneratedFacts;
import org.mechservice.sim.model.ModelColumns;
import org.mechservice.sim.model.Omission;
import org.mechservice.sim.model.StandaloneMain;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.mechanism.FurtherState;
import org.mechservice.solver.simulation.SolverVersion;
import org.mechservice.solver.text.Sha256;

/** Makes the JARs of models. */
public final class ModelJars {
  private ModelJars() {}

  /** Returns the JAR of a model without a solver, which needs the runtime JAR beside it. */
  public static JarImage model(CompiledModel model, String mechmlSha256) {
    return image(
        model,
        model.classFiles(),
        Collections.emptySortedMap(),
        model.generated().className(),
        "",
        manifest(model, mechmlSha256));
  }

  /** Returns the JAR of a model with a main class and the solver classes that it reaches. */
  public static JarImage standalone(CompiledModel model, String mechmlSha256) {
    SortedMap<String, byte[]> own = StandaloneMain.classFiles(model);
    String mainClass = StandaloneMain.className(model.generated());
    Map<String, String> manifest = new LinkedHashMap<>();
    manifest.put("Main-Class", mainClass);
    manifest.putAll(manifest(model, mechmlSha256));
    SortedMap<String, byte[]> solver = ReachableClasses.from(own, ChosenClasses.of(model)::needed);
    return image(model, own, solver, mainClass, "-standalone", manifest);
  }

  /**
   * @param own the model's classes, by binary name
   * @param solver the solver's classes, by path
   * @param suffix of the file's name
   */
  private static JarImage image(
      CompiledModel model,
      SortedMap<String, byte[]> own,
      SortedMap<String, byte[]> solver,
      String mainClass,
      String suffix,
      Map<String, String> manifest) {
    ReproducibleJar jar = new ReproducibleJar(manifest).addClasses(own);
    solver.forEach(jar::add);
    jar.add(
        "META-INF/modelDescription.xml", descriptionXml(model).getBytes(StandardCharsets.UTF_8));
    byte[] bytes = jar.bytes();
    String className = model.generated().className();
    return new JarImage(
        className.substring(className.lastIndexOf('.') + 1) + suffix + ".jar",
        bytes,
        Sha256.of(bytes),
        mainClass,
        jar.compressedSize(model.classFiles()),
        manifest);
  }

  private static Map<String, String> manifest(CompiledModel model, String mechmlSha256) {
    GeneratedFacts generated = model.generated();
    Map<String, String> manifest = new LinkedHashMap<>();
    manifest.put("Implementation-Title", generated.modelName());
    manifest.put("Implementation-Version", SolverVersion.CURRENT);
    manifest.put("Mech-Model", generated.className());
    manifest.put("Mech-Api-Version", Integer.toString(Model.API_VERSION));
    manifest.put("Mech-Formulation", generated.formulation());
    manifest.put("Mech-Formulation-Reason", generated.formulationReason());
    manifest.put("Mech-Code", generated.code());
    manifest.put("Mech-Integrator", model.options().settings().integrator());
    manifest.put("Mech-Columns", ModelColumns.labels(ModelColumns.of(model)));
    manifest.put("Mech-Columns-Shown", ModelColumns.labels(ModelColumns.shown(model)));
    manifest.put("Mech-Model-SHA-256", mechmlSha256);
    manifest.put("Mech-Left-Out", listed(generated.leftOut()));
    String inputs =
        model.source().mechanism().furtherStates().stream()
            .filter(state -> state.role() == FurtherState.Role.INPUT)
            .map(FurtherState::name)
            .collect(Collectors.joining(" "));
    if (!inputs.isEmpty()) {
      manifest.put("Mech-Inputs", inputs);
    }
    if (!generated.fromData().isEmpty()) {
      manifest.put("Mech-From-Data", listed(generated.fromData()));
    }
    return manifest;
  }

  private static String listed(List<Omission> omissions) {
    return omissions.stream()
        .map(omission -> omission.what() + " (" + omission.why() + ")")
        .collect(Collectors.joining("; "));
  }

  private static String descriptionXml(CompiledModel model) {
    Model instance = model.withoutUserClasses();
    ModelDescription description = instance.description();
    double[] start = new double[description.stateCount()];
    instance.initialState(start);
    return ModelDescriptionXml.of(description, start);
  }
}
