package org.mechservice.sim.compile;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import javax.tools.Diagnostic;
import javax.tools.JavaFileObject;
import org.mechservice.sim.emit.bytes.MethodSizes;
import org.mechservice.sim.scene.ModelBuildException;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * Compiles generated classes in memory, against the JDK and the solver's interfaces only. The
 * compiler does not read the class path of this process and runs no annotation processor.
 */
public final class ModelCompiler {
  private static final List<String> OPTIONS =
      List.of(
          "--release", "17", "-g:none", "-proc:none", "-implicit:none", "-nowarn", "-Xlint:none");

  /** Packages that generated code may name. */
  private static final Set<String> VISIBLE_PACKAGES =
      Set.of(
          "org.mechservice.solver.analysis",
          "org.mechservice.solver.api",
          "org.mechservice.solver.api.capability",
          "org.mechservice.solver.api.result",
          "org.mechservice.solver.api.run",
          "org.mechservice.solver.catalogue",
          "org.mechservice.solver.closure",
          "org.mechservice.solver.closure.assembly",
          "org.mechservice.solver.closure.equations",
          "org.mechservice.solver.closure.model",
          "org.mechservice.solver.compact",
          "org.mechservice.solver.dynamics",
          "org.mechservice.solver.dynamics.derivative",
          "org.mechservice.solver.dynamics.event",
          "org.mechservice.solver.dynamics.recursion",
          "org.mechservice.solver.dynamics.tree",
          "org.mechservice.solver.expression",
          "org.mechservice.solver.force",
          "org.mechservice.solver.force.applied",
          "org.mechservice.solver.force.formula",
          "org.mechservice.solver.force.user",
          "org.mechservice.solver.mechanism",
          "org.mechservice.solver.ode",
          "org.mechservice.solver.ode.adams",
          "org.mechservice.solver.ode.events",
          "org.mechservice.solver.ode.stiff",
          "org.mechservice.solver.ode.switching",
          "org.mechservice.solver.spatial",
          "org.mechservice.solver.standalone");

  private ModelCompiler() {}

  /**
   * Compiles one class.
   *
   * @param className fully qualified name
   * @param source its source
   * @param others class files it may refer to besides the solver's, by binary name; not modified
   * @return class files by binary name
   * @throws ModelBuildException S-084 if there is no compiler in this JVM, S-085 if the class is
   *     too large
   */
  public static SortedMap<String, byte[]> compile(
      String className, String source, SortedMap<String, byte[]> others) {
    return compile(className, List.of(MemoryFiles.source(className, source)), others);
  }

  /**
   * Compiles all classes of a model, as {@link #compile(String, String, SortedMap)} does one.
   *
   * @param sources by fully qualified name
   */
  public static SortedMap<String, byte[]> compile(SortedMap<String, String> sources) {
    List<JavaFileObject> units = new ArrayList<>();
    sources.forEach((name, text) -> units.add(MemoryFiles.source(name, text)));
    return compile(String.join(", ", sources.keySet()), units, Collections.emptySortedMap());
  }

  private static SortedMap<String, byte[]> compile(
      String className, List<JavaFileObject> units, SortedMap<String, byte[]> others) {
    Compilation done = Compilation.of(units, OPTIONS, VISIBLE_PACKAGES, others);
    if (!done.succeeded()) {
      throw failure(className, done.diagnostics(), done.messages());
    }
    return checked(done.classFiles());
  }

  private static SortedMap<String, byte[]> checked(SortedMap<String, byte[]> written) {
    SortedMap<String, byte[]> classes = new TreeMap<>();
    written.forEach((name, bytes) -> classes.put(name, CompactLocals.compacted(bytes)));
    classes.values().forEach(MethodSizes::requireCompilable);
    return Collections.unmodifiableSortedMap(classes);
  }

  private static RuntimeException failure(
      String className, List<Diagnostic<? extends JavaFileObject>> diagnostics, String messages) {
    StringBuilder text = new StringBuilder();
    for (Diagnostic<? extends JavaFileObject> diagnostic : diagnostics) {
      String code = String.valueOf(diagnostic.getCode());
      if (code.contains("limit.")) {
        return new ModelBuildException(
            MessageCode.MODEL_CLASS_TOO_LARGE,
            "the generated class "
                + className
                + " is too large for a class file ("
                + diagnostic.getMessage(Locale.ROOT)
                + "); use fewer bodies");
      }
      text.append("\nline ").append(diagnostic.getLineNumber()).append(": ");
      text.append(diagnostic.getMessage(Locale.ROOT));
    }
    return new IllegalStateException(
        "the generated class " + className + " does not compile:" + text + messages);
  }
}
