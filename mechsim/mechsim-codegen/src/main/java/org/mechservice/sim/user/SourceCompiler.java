package org.mechservice.sim.user;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.tools.Diagnostic;
import javax.tools.JavaFileObject;
import org.mechservice.sim.compile.Compilation;
import org.mechservice.sim.scene.ModelBuildException;
import org.mechservice.solver.api.UserForce;
import org.mechservice.solver.catalogue.MessageCode;

/** Compiles user sources against Java and the force interface. */
final class SourceCompiler {
  private static final List<String> OPTIONS =
      List.of(
          "--release",
          "17",
          "--limit-modules",
          "java.base",
          "-g",
          "-proc:none",
          "-implicit:none",
          "-Xlint:none");
  private static final Set<String> VISIBLE_PACKAGES = Set.of(UserForce.class.getPackageName());

  /** Largest number of errors reported; the first is usually the cause of the others. */
  private static final int MOST_ERRORS = 10;

  private static final Pattern PACKAGE =
      Pattern.compile("(?m)^\\s*package\\s+([A-Za-z0-9_$.]{1,300})\\s*;");

  /** Usual form of class names; constants are written in capitals. */
  private static final Pattern CLASS_NAME = Pattern.compile("[A-Z][A-Za-z0-9_$]*[a-z][\\w$]*");

  private final Map<String, String> sources;
  private final UserCodeFindings findings;

  private SourceCompiler(Map<String, String> sources, UserCodeFindings findings) {
    this.sources = sources;
    this.findings = findings;
  }

  /**
   * Returns class files by binary name; none if there is an error.
   *
   * @param sources texts by file name
   * @param others class files they may name, by binary name; not modified
   * @param findings receives the messages of the compiler and the missing classes
   */
  static SortedMap<String, byte[]> compile(
      Map<String, String> sources, SortedMap<String, byte[]> others, UserCodeFindings findings) {
    return new SourceCompiler(sources, findings).compile(others);
  }

  private SortedMap<String, byte[]> compile(SortedMap<String, byte[]> others) {
    List<JavaFileObject> units = new ArrayList<>();
    sources.forEach(
        (name, text) ->
            units.add(Compilation.source(name.substring(0, name.lastIndexOf('.')), text)));
    try {
      Compilation done = Compilation.of(units, OPTIONS, VISIBLE_PACKAGES, others);
      if (done.succeeded()) {
        return done.classFiles();
      }
      report(done);
    } catch (ModelBuildException e) {
      findings.add(
          e.code(),
          first(),
          "this source must be compiled, and the server's Java is a run time without compiler; give"
              + " the class file instead, or start the server with a JDK");
    } catch (IllegalStateException | StackOverflowError e) {
      giveUp();
    }
    return Collections.emptySortedMap();
  }

  private void report(Compilation failed) {
    List<Diagnostic<? extends JavaFileObject>> errors =
        failed.diagnostics().stream()
            .filter(said -> said.getKind() == Diagnostic.Kind.ERROR)
            .toList();
    errors.stream().limit(MOST_ERRORS).forEach(this::report);
    if (errors.isEmpty()) {
      giveUp();
    }
  }

  /** Reports a source that is nested too deeply for the compiler's stack. */
  private void giveUp() {
    findings.add(
        MessageCode.USER_SOURCE_DOES_NOT_COMPILE,
        first(),
        "the compiler gives up on this source; write it more simply");
  }

  private String first() {
    return sources.keySet().iterator().next();
  }

  private void report(Diagnostic<? extends JavaFileObject> said) {
    JavaFileObject source = said.getSource();
    String file = source == null ? first() : name(source);
    int line = (int) Math.max(0, said.getLineNumber());
    String missing = missingClass(said, file);
    if (missing.isEmpty()) {
      String text = said.getMessage(Locale.ROOT).replaceAll("\\s*\\R\\s*", "; ");
      findings.add(
          MessageCode.USER_SOURCE_DOES_NOT_COMPILE,
          file,
          line,
          (int) Math.max(0, said.getColumnNumber()),
          text);
    } else {
      findings.missing(missing, file + ":" + line + " needs");
    }
  }

  private static String name(JavaFileObject source) {
    return source.toUri().getPath().substring(1);
  }

  /** Returns the missing class that a source needs, as far as its text shows, or null. */
  private String missingClass(Diagnostic<? extends JavaFileObject> said, String file) {
    String text = sources.getOrDefault(file, "");
    int from = (int) said.getPosition();
    String code = String.valueOf(said.getCode());
    if (from < 0 || said.getEndPosition() > text.length() || !code.contains("cant.resolve")) {
      return "";
    }
    Matcher name = CLASS_NAME.matcher(text.substring(from, (int) said.getEndPosition()));
    if (!name.matches()) {
      return "";
    }
    Matcher stated = PACKAGE.matcher(text);
    String prefix = stated.find() ? stated.group(1) + "." : "";
    return prefix + name.group();
  }
}
