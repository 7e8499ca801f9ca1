package org.mechservice.mechml.diagnosis;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.catalogue.Severity;
import org.mechservice.solver.text.Origin;

/** Collects the diagnostics of one file; keeps only one of several equal ones. */
public final class Diagnostics {
  /** Largest number of messages kept; in a file with more, most of them have one cause. */
  public static final int MOST = 100;

  private final String file;
  private final Set<Diagnostic> found = new LinkedHashSet<>();
  private boolean errors;

  /**
   * Begins an empty collection.
   *
   * @param file name of the file for messages
   */
  public Diagnostics(String file) {
    this.file = file;
  }

  /** Returns a collection of its own with the messages of this one. */
  public Diagnostics copy() {
    Diagnostics copy = new Diagnostics(file);
    copy.found.addAll(found);
    copy.errors = errors;
    return copy;
  }

  /** Returns the name of the file. */
  public String file() {
    return file;
  }

  /** Adds an error: the model cannot be used. */
  public void error(MessageCode code, SourcePosition position, String message) {
    errors = true;
    add(Severity.ERROR, code, position, message);
  }

  /** Adds a warning: a probable mistake. */
  public void warning(MessageCode code, SourcePosition position, String message) {
    add(Severity.WARNING, code, position, message);
  }

  private void add(Severity severity, MessageCode code, SourcePosition position, String message) {
    if (!isFull()) {
      found.add(
          new Diagnostic(
              severity,
              code,
              message,
              fileOf(position),
              position.line(),
              position.column(),
              position.path()));
    }
  }

  /** Adds the messages about a file that this one includes. */
  public void addAll(List<Diagnostic> others) {
    for (Diagnostic other : others) {
      errors |= other.severity() == Severity.ERROR;
      if (!isFull()) {
        found.add(other);
      }
    }
  }

  /** Returns the place for messages of a run. */
  public Origin origin(SourcePosition position) {
    return new Origin(fileOf(position), position.line());
  }

  private String fileOf(SourcePosition position) {
    return position.included().isEmpty() ? file : position.included();
  }

  /** Returns whether no further message is kept. */
  public boolean isFull() {
    return found.size() >= MOST;
  }

  /** Returns whether there is an error. */
  public boolean hasErrors() {
    return errors;
  }

  /** Returns all diagnostics in file order, those about included files last. */
  public List<Diagnostic> inFileOrder() {
    List<Diagnostic> ordered = new ArrayList<>(found);
    ordered.sort(
        Comparator.comparing((Diagnostic one) -> one.file().equals(file) ? "" : one.file())
            .thenComparingInt(Diagnostic::line)
            .thenComparingInt(Diagnostic::column));
    if (isFull()) {
      ordered.add(
          new Diagnostic(
              Severity.INFO,
              MessageCode.MORE_MESSAGES,
              "only the first " + MOST + " messages are listed",
              file,
              0,
              0,
              ""));
    }
    return ordered;
  }

  /**
   * Ends the reading if there is an error.
   *
   * @throws MechmlException with all diagnostics if one of them is an error
   */
  public void throwIfErrors() throws MechmlException {
    if (errors) {
      throw new MechmlException(inFileOrder());
    }
  }
}
