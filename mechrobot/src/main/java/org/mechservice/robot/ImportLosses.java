package org.mechservice.robot;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.mechml.diagnosis.SourcePosition;
import org.mechservice.mechml.document.Element;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.catalogue.Severity;

/** Collects the parts of a robot's file that MechML cannot express. */
final class ImportLosses {
  private final String file;
  private final List<Diagnostic> found = new ArrayList<>();

  ImportLosses(String file) {
    this.file = file;
  }

  /**
   * Notes a loss.
   *
   * @param element the element that is lost or loses something
   * @param what a sentence about it, after its label
   */
  void add(Element element, String what) {
    SourcePosition position = element.position();
    found.add(
        new Diagnostic(
            Severity.WARNING,
            MessageCode.ROBOT_LOST,
            element.label() + ": " + what,
            file,
            position.line(),
            position.column(),
            position.path()));
  }

  List<Diagnostic> inFileOrder() {
    List<Diagnostic> ordered = new ArrayList<>(found);
    ordered.sort(Comparator.comparingInt(Diagnostic::line).thenComparingInt(Diagnostic::column));
    return ordered;
  }
}
