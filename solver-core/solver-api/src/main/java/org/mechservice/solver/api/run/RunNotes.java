package org.mechservice.solver.api.run;

import java.util.List;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * A model with notes about a run: a corrected start, redundant equations left out, a new choice of
 * coordinates, a singular position passed.
 */
public interface RunNotes {
  /** Returns all notes since the model was created, in order of time. */
  List<Note> notes();

  /**
   * A note of the run report.
   *
   * @param code entry of the error catalogue, such as {@code N-031}
   * @param time simulated time, s
   * @param warning whether it is a warning
   * @param text one sentence with names, numbers and units
   */
  record Note(MessageCode code, double time, boolean warning, String text) {
    /** Returns the note as one message. */
    public String message() {
      return code + " t=" + time + " s: " + text;
    }
  }
}
