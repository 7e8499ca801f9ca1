package org.mechservice.mechml.urdf;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.mechservice.mechml.Diagnostic;
import org.mechservice.mechml.diagnosis.Place;
import org.mechservice.mechml.document.Element;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.catalogue.Severity;

/** What of a robot's file is not carried over, all of it. */
final class Losses {
  private final String file;
  private final List<Diagnostic> found = new ArrayList<>();

  Losses(String file) {
    this.file = file;
  }

  /**
   * Notes a loss.
   *
   * @param element what is lost, or has lost something
   * @param what a sentence about it, after its label
   */
  void add(Element element, String what) {
    Place place = element.place();
    found.add(
        new Diagnostic(
            Severity.WARNING,
            MessageCode.URDF_LOST,
            element.label() + ": " + what,
            file,
            place.line(),
            place.column(),
            place.path()));
  }

  List<Diagnostic> inFileOrder() {
    List<Diagnostic> ordered = new ArrayList<>(found);
    ordered.sort(Comparator.comparingInt(Diagnostic::line).thenComparingInt(Diagnostic::column));
    return ordered;
  }
}
