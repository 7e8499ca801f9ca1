package org.mechservice.sim.user;

import java.util.Collections;
import java.util.Map;
import java.util.SortedMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.tools.ToolProvider;
import org.mechservice.solver.catalogue.MessageCode;

/** Compiles user sources against Java and the force interface, in a process of its own. */
final class SourceCompiler {
  /** Largest number of errors reported; the first is usually the cause of the others. */
  static final int MOST_ERRORS = 10;

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
    if (ToolProvider.getSystemJavaCompiler() == null) {
      findings.add(
          MessageCode.NO_COMPILER,
          first(),
          "this source must be compiled, and the server's Java is a run time without compiler; give"
              + " the class file instead, or start the server with a JDK");
      return Collections.emptySortedMap();
    }
    CompilerProcess.Result done = CompilerProcess.compile(sources, others);
    if (!done.givenUp().isEmpty()) {
      findings.add(
          MessageCode.USER_SOURCE_DOES_NOT_COMPILE,
          first(),
          "the compiler gives up on this source: " + done.givenUp() + "; write it more simply");
    }
    done.errors().forEach(this::report);
    return done.classFiles();
  }

  private String first() {
    return sources.keySet().iterator().next();
  }

  private void report(CompilerProcess.Said said) {
    String file = said.file().isEmpty() ? first() : said.file();
    String missing = missingClass(said, file);
    if (missing.isEmpty()) {
      findings.add(
          MessageCode.USER_SOURCE_DOES_NOT_COMPILE,
          file,
          said.line(),
          said.column(),
          said.text().replaceAll("\\s*\\R\\s*", "; "));
    } else {
      findings.missing(missing, file + ":" + said.line() + " needs");
    }
  }

  /** Returns the missing class that a source needs, as far as its text shows, or an empty text. */
  private String missingClass(CompilerProcess.Said said, String file) {
    String text = sources.getOrDefault(file, "");
    int from = said.position();
    if (from < 0
        || said.end() < from
        || said.end() > text.length()
        || !said.code().contains("cant.resolve")) {
      return "";
    }
    Matcher name = CLASS_NAME.matcher(text.substring(from, said.end()));
    if (!name.matches()) {
      return "";
    }
    Matcher stated = PACKAGE.matcher(text);
    String prefix = stated.find() ? stated.group(1) + "." : "";
    return prefix + name.group();
  }
}
