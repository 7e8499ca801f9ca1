package org.mechservice.solver.standalone;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.net.URL;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.jar.Attributes;
import java.util.jar.JarFile;
import java.util.jar.Manifest;
import org.mechservice.solver.api.ModelSource;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.simulation.RuntimeSolver;

/**
 * Runs the model JAR on the class path with the solver of the runtime JAR:
 *
 * <pre>java -cp runtime.jar:model.jar org.mechservice.solver.standalone.RunModel --out rows.csv
 * </pre>
 *
 * <p>A manifest on the class path names the model in {@code Mech-Model}. The options are those of a
 * standalone JAR.
 */
public final class RunModel {
  private static final String MODEL = "Mech-Model";
  private static final int BAD_USAGE = 2;

  private RunModel() {}

  /** Runs the model and ends the process with the exit status of {@link Standalone#run}. */
  public static void main(String[] args) {
    ClassLoader classPath = RunModel.class.getClassLoader();
    System.exit(run(classPath, args, System.out, System.err));
  }

  static int run(ClassLoader classPath, String[] args, PrintStream out, PrintStream err) {
    try {
      Map<String, Attributes> models = models(classPath);
      if (models.size() != 1) {
        err.println(
            MessageCode.STANDALONE_JAR_DAMAGED
                + " the class path has "
                + (models.isEmpty() ? "no model JAR" : "more than one model: " + models.keySet())
                + "; it must have exactly one JAR whose manifest names a "
                + MODEL);
        return BAD_USAGE;
      }
      String name = models.keySet().iterator().next();
      Attributes manifest = models.getOrDefault(name, new Attributes());
      Object model = classPath.loadClass(name).getDeclaredConstructor().newInstance();
      return new Standalone(
              ModelSource.from(model),
              new RuntimeSolver(),
              String.valueOf(manifest.getValue("Mech-Columns")),
              String.valueOf(manifest.getValue("Mech-Columns-Shown")),
              out,
              err)
          .run(args);
    } catch (ReflectiveOperationException | IOException e) {
      err.println(
          MessageCode.STANDALONE_JAR_DAMAGED
              + " the model JAR on the class path cannot be used: "
              + e);
      return BAD_USAGE;
    }
  }

  /** Returns the manifests that name a model, by the model's class. */
  private static Map<String, Attributes> models(ClassLoader classPath) throws IOException {
    Map<String, Attributes> models = new TreeMap<>();
    List<URL> manifests =
        new ArrayList<>(Collections.list(classPath.getResources(JarFile.MANIFEST_NAME)));
    for (URL place : manifests) {
      try (InputStream file = place.openStream()) {
        Attributes manifest = new Manifest(file).getMainAttributes();
        String model = manifest.getValue(MODEL);
        if (model != null) {
          models.put(model, manifest);
        }
      }
    }
    return models;
  }
}
