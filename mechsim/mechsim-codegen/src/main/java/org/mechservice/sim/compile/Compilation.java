package org.mechservice.sim.compile;

import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.SortedMap;
import javax.tools.Diagnostic;
import javax.tools.DiagnosticCollector;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.mechservice.sim.scene.ModelBuildException;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * The result of compiling sources in memory.
 *
 * @param succeeded whether there are class files
 * @param classFiles by binary name; must not be modified
 * @param diagnostics messages of the compiler
 * @param messages messages that belong to none of the sources
 */
public record Compilation(
    boolean succeeded,
    SortedMap<String, byte[]> classFiles,
    List<Diagnostic<? extends JavaFileObject>> diagnostics,
    String messages) {

  /** Returns a source file in memory. */
  public static JavaFileObject source(String className, String source) {
    return MemoryFiles.source(className, source);
  }

  /**
   * Compiles.
   *
   * @param sources see {@link #source}
   * @param options of the compiler
   * @param visiblePackages packages of the solver that the sources may name
   * @param others class files that they may name, by binary name; not modified
   * @throws ModelBuildException S-084 if there is no compiler in this JVM
   */
  public static Compilation of(
      List<JavaFileObject> sources,
      List<String> options,
      Set<String> visiblePackages,
      SortedMap<String, byte[]> others) {
    JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    if (compiler == null) {
      throw new ModelBuildException(
          MessageCode.NO_COMPILER,
          "this Java ("
              + System.getProperty("java.home")
              + ") has no compiler; run with a JDK 17 or"
              + " newer instead of a runtime");
    }
    DiagnosticCollector<JavaFileObject> diagnostics = new DiagnosticCollector<>();
    try (StandardJavaFileManager standard =
            compiler.getStandardFileManager(diagnostics, Locale.ROOT, StandardCharsets.UTF_8);
        MemoryFiles files = new MemoryFiles(standard, visiblePackages, others)) {
      StringWriter messages = new StringWriter();
      boolean succeeded =
          compiler.getTask(messages, files, diagnostics, options, null, sources).call();
      return new Compilation(
          succeeded, files.written(), diagnostics.getDiagnostics(), messages.toString());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
