package org.mechservice.sim.build.javac;

import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.SortedMap;
import java.util.TreeMap;
import javax.tools.Diagnostic;
import javax.tools.DiagnosticCollector;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.mechservice.sim.build.emit.MethodSizes;
import org.mechservice.sim.scene.ModelBuildException;

/**
 * Compiles generated classes in memory, against nothing but the JDK and the solver's interfaces.
 * Nothing is read from the class path of this process and no annotation processor runs.
 */
public final class ModelCompiler {
  private static final List<String> OPTIONS =
      List.of(
          "--release", "17", "-g:none", "-proc:none", "-implicit:none", "-nowarn", "-Xlint:none");

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
    JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    if (compiler == null) {
      throw new ModelBuildException(
          "S-084",
          "this Java ("
              + System.getProperty("java.home")
              + ") has no compiler; run with a JDK 17 or"
              + " newer instead of a runtime");
    }
    DiagnosticCollector<JavaFileObject> diagnostics = new DiagnosticCollector<>();
    try (StandardJavaFileManager standard =
            compiler.getStandardFileManager(diagnostics, Locale.ROOT, StandardCharsets.UTF_8);
        MemoryFiles files = new MemoryFiles(standard, others)) {
      JavaFileObject unit = MemoryFiles.source(className, source);
      StringWriter messages = new StringWriter();
      boolean compiled =
          compiler.getTask(messages, files, diagnostics, OPTIONS, null, List.of(unit)).call();
      if (!compiled) {
        throw failure(className, diagnostics.getDiagnostics(), messages.toString());
      }
      return checked(files.written());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
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
            "S-085",
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
