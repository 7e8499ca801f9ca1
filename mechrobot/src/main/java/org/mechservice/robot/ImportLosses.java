package org.mechservice.robot;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.mechml.diagnosis.SourcePosition;
import org.mechservice.mechml.document.Element;

/** Collects the parts of a robot's file that are not in the model, by grade. */
final class ImportLosses {
  private final String file;
  private final Set<Diagnostic> found = new LinkedHashSet<>();

  ImportLosses(String file) {
    this.file = file;
  }

  /** Notes a loss without which the robot moves otherwise. */
  void motion(Element element, String what) {
    add(LossGrade.MOTION, element, what);
  }

  /** Notes a loss that matters to contacts or motors only. */
  void contact(Element element, String what) {
    add(LossGrade.CONTACT, element, what);
  }

  /** Notes a loss of the picture or of a note. */
  void picture(Element element, String what) {
    add(LossGrade.PICTURE, element, what);
  }

  /**
   * Notes a loss.
   *
   * @param element the element that is lost or loses something
   * @param what a sentence about it, after its label
   */
  void add(LossGrade grade, Element element, String what) {
    SourcePosition position = element.position();
    found.add(
        new Diagnostic(
            grade.code().severity(),
            grade.code(),
            element.label() + ": " + what,
            position.included().isEmpty() ? file : position.included(),
            position.line(),
            position.column(),
            position.path()));
  }

  /** Returns them in file order, those of included files last. */
  List<Diagnostic> inFileOrder() {
    List<Diagnostic> ordered = new ArrayList<>(found);
    ordered.sort(
        Comparator.comparing((Diagnostic one) -> one.file().equals(file) ? "" : one.file())
            .thenComparingInt(Diagnostic::line)
            .thenComparingInt(Diagnostic::column));
    return ordered;
  }
}
