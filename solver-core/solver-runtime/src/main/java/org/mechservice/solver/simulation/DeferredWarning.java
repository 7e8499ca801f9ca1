package org.mechservice.solver.simulation;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunNotes.Note;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;

/** A warning that can be decided only at the end of a run. */
final class DeferredWarning {
  private DeferredWarning() {}

  /**
   * Returns the report with the warning after its other notes, unless the request silences it. A
   * strict run that was completed fails with it.
   */
  static RunReport added(RunReport report, Note warning, RunRequest request) {
    if (request.silenced().contains(warning.code())) {
      return report;
    }
    List<Note> notes = new ArrayList<>(report.notes());
    notes.add(warning);
    boolean ended = request.strict() && report.outcome() instanceof Outcome.Completed;
    return report.with(
        ended ? new Outcome.Failed(FailureText.ofStrict(warning)) : report.outcome(), notes);
  }
}
