package org.mechservice.sim.user;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.guard.UserCode;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.catalogue.Severity;

/** Errors in the user classes of a model; each error is reported once. */
final class UserCodeFindings {
  private final Map<String, Diagnostic> found = new LinkedHashMap<>();

  /** Adds an error of a file or a class. */
  void add(MessageCode code, String file, String text) {
    add(code, file, 0, 0, text);
  }

  /** Adds an error at a position in a file. */
  void add(MessageCode code, String file, int line, int column, String text) {
    found.putIfAbsent(
        code + file + line + text,
        new Diagnostic(Severity.ERROR, code, text, file, line, column, ""));
  }

  /**
   * Adds a missing class. The message names its file, so that a client knows which file to send.
   *
   * @param who element that names it, such as {@code force "Road" (car.xml:12) is}
   */
  void missing(String className, String who) {
    String simple = className.substring(className.lastIndexOf('.') + 1);
    String file = className.replace('.', '/') + ".class";
    found.putIfAbsent(
        file,
        new Diagnostic(
            Severity.ERROR,
            MessageCode.USER_CLASS_MISSING,
            who
                + " the class "
                + className
                + ", which did not come with the model; put "
                + simple
                + ".java or "
                + simple
                + ".class, or either in the folders of its package, into the folder given with"
                + " --user-code"
                + UserCode.IN_PROGRAMS,
            file,
            0,
            0,
            ""));
  }

  /**
   * @throws MechmlException if there is an error
   */
  void throwIfAny() throws MechmlException {
    if (!found.isEmpty()) {
      throw new MechmlException(List.copyOf(found.values()));
    }
  }
}
