package org.mechservice.mechml.diagnosis;

import java.util.List;
import java.util.stream.Collectors;

/** Thrown when a model file has errors; carries all diagnostics. */
public final class MechmlException extends Exception {
  private static final long serialVersionUID = 1L;

  private final transient List<Diagnostic> diagnostics;

  public MechmlException(List<Diagnostic> diagnostics) {
    super(diagnostics.stream().map(Diagnostic::toString).collect(Collectors.joining("\n")));
    this.diagnostics = List.copyOf(diagnostics);
  }

  /** Returns the diagnostics in file order, at least one of them an error. */
  public List<Diagnostic> diagnostics() {
    return diagnostics;
  }
}
