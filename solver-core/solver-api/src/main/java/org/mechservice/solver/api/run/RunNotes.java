package org.mechservice.solver.api.run;

import java.util.List;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * A model that has something to say about a run: a start that was corrected, equations that were
 * dropped as dependent, coordinates chosen anew, a singular position passed.
 */
public interface RunNotes {
  /** Returns what was noted since the model was made, in order of time. */
  List<Note> notes();

  /**
   * A remark for the run report.
   *
   * @param code entry of the error catalogue, such as {@code N-031}
   * @param time simulated time, s
   * @param warning whether the user should look at it
   * @param text one sentence with names, numbers and units
   */
  record Note(MessageCode code, double time, boolean warning, String text) {
    /** Returns the remark as one message. */
    public String message() {
      return code + " t=" + time + " s: " + text;
    }
  }
}
