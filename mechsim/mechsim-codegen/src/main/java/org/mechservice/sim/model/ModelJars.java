package org.mechservice.sim.model;

import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.SortedMap;
import java.util.stream.Collectors;
import org.mechservice.sim.jar.LeanClass;
import org.mechservice.sim.jar.ModelDescriptionXml;
import org.mechservice.sim.jar.Packing;
import org.mechservice.sim.jar.ReachableClasses;
import org.mechservice.sim.jar.ReproducibleJar;
import org.mechservice.sim.jar.Sha256;
import org.mechservice.sim.jar.SolidClasses;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.simulation.SolverVersion;
import org.mechservice.solver.standalone.Launcher;

/** Packs models. */
final class ModelJars {
  /** The classes that take data apart by the components of records. */
  private static final String READS_RECORDS = "org/mechservice/solver/compact/Record";

  private ModelJars() {}

  /** Packs a model without a solver, but with what it needs beyond the runtime JAR. */
  static PackedJar model(CompiledModel model, String mechmlSha256, Packing packing) {
    Map<String, String> manifest = manifest(model, mechmlSha256);
    ReproducibleJar jar = new ReproducibleJar(manifest, packing).addClasses(model.classFiles());
    RuntimeJar runtime = RuntimeJar.current();
    // What the runtime JAR has reaches nothing beyond it.
    ReachableClasses.from(
            model.classFiles(),
            path -> runtime.has(path) ? null : ColumnClasses.needed(path, model))
        .forEach(jar::add);
    return packed(model, jar, packing, "", model.generated().className(), manifest);
  }

  /** Packs a model with its main class and the solver classes that it reaches. */
  static PackedJar standalone(CompiledModel model, String mechmlSha256, Packing packing) {
    SortedMap<String, byte[]> own = StandaloneMain.classFiles(model);
    String mainClass = StandaloneMain.className(model.generated());
    Map<String, String> manifest = new LinkedHashMap<>();
    String launcher = Launcher.class.getName();
    manifest.put("Main-Class", launcher);
    manifest.putAll(manifest(model, mechmlSha256));
    SortedMap<String, byte[]> solver =
        ReachableClasses.from(own, path -> ColumnClasses.needed(path, model));
    if (solver.keySet().stream().noneMatch(path -> path.startsWith(READS_RECORDS))) {
      solver.replaceAll((path, file) -> LeanClass.withoutComponents(file));
    }
    ReproducibleJar jar = new ReproducibleJar(manifest, packing).addClasses(own);
    String launcherFile = launcher.replace('.', '/') + ".class";
    jar.add(launcherFile, Objects.requireNonNull(SolverFiles.lean(launcherFile)));
    jar.add(Launcher.SOLVER, SolidClasses.of(mainClass, solver));
    return packed(model, jar, packing, "-standalone", launcher, manifest);
  }

  private static PackedJar packed(
      CompiledModel model,
      ReproducibleJar jar,
      Packing packing,
      String suffix,
      String mainClass,
      Map<String, String> manifest) {
    String className = model.generated().className();
    String xml = descriptionXml(model);
    jar.add("META-INF/modelDescription.xml", xml.getBytes(StandardCharsets.UTF_8));
    byte[] bytes = jar.bytes();
    long modelBytes =
        model.classFiles().values().stream().mapToLong(file -> packing.deflated(file).length).sum();
    return new PackedJar(
        className.substring(className.lastIndexOf('.') + 1) + suffix + ".jar",
        bytes,
        Sha256.of(bytes),
        mainClass,
        modelBytes,
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
    manifest.put("Mech-Columns", BuiltColumns.labels(BuiltColumns.of(model)));
    manifest.put("Mech-Columns-Shown", BuiltColumns.labels(BuiltColumns.shown(model)));
    manifest.put("Mech-Model-SHA-256", mechmlSha256);
    manifest.put("Mech-Left-Out", listed(generated.leftOut()));
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
