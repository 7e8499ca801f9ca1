package org.mechservice.solver.simulation;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.api.run.RunNotes;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.Integrator.MethodChange;

/** Notes of the run report on changes of the integration method. */
final class MethodNotes {
  private static final MessageCode CODE = MessageCode.METHOD_SWITCHED;

  private MethodNotes() {}

  /** Returns a note for each recorded change, and the number of further ones. */
  static List<RunNotes.Note> of(Integrator integrator) {
    List<RunNotes.Note> notes = new ArrayList<>();
    List<MethodChange> changes = integrator.methodChanges();
    for (MethodChange change : changes) {
      notes.add(new RunNotes.Note(CODE, change.time(), false, text(change)));
    }
    long further = integrator.methodChangeCount() - changes.size();
    if (further > 0) {
      double last = changes.get(changes.size() - 1).time();
      notes.add(new RunNotes.Note(CODE, last, false, "Then the method changed " + further + "x."));
    }
    return notes;
  }

  private static String text(MethodChange change) {
    float size = (float) Math.abs(change.stepSize());
    return change.stiff()
        ? "The method changes from ode113 to ode15s: stability, not accuracy, limited the step to "
            + size
            + " s."
        : "The method changes from ode15s to ode113: at a step of " + size + " s it costs less.";
  }
}
