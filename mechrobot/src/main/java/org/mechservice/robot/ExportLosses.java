package org.mechservice.robot;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.SourcePosition;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.catalogue.Severity;
import org.mechservice.solver.text.Origin;

/** Collects what URDF cannot express of a mechanism: what is left out, and what must not be. */
final class ExportLosses {
  private final String file;
  private final Diagnostics refused;
  private final List<Diagnostic> found = new ArrayList<>();

  /**
   * @param file name of the model file
   * @param refused receives the parts without which the mechanism would be another one
   */
  ExportLosses(String file, Diagnostics refused) {
    this.file = file;
    this.refused = refused;
  }

  /** Notes a part that is left out. */
  void add(Origin place, String what) {
    found.add(
        new Diagnostic(
            Severity.WARNING,
            MessageCode.URDF_LOST,
            what,
            place.file().isEmpty() ? file : place.file(),
            place.line(),
            0,
            ""));
  }

  /** Refuses a part without which the mechanism would be another one. */
  void refuse(Origin place, String what) {
    refused.error(
        MessageCode.URDF_CANNOT,
        place.line() == 0 ? SourcePosition.FILE : new SourcePosition(place.line(), 0, ""),
        what);
  }

  List<Diagnostic> all() {
    return List.copyOf(found);
  }
}
