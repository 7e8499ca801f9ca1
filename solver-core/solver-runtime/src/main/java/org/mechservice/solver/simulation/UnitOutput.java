package org.mechservice.solver.simulation;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.api.JointVariables;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.run.RunNotes.Note;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.spatial.EulerParameters;

/**
 * Normalises Euler parameters in the output, and records the drift of their norm in the
 * integration, on which nothing depends (docs/theory/motion.md#positions).
 */
final class UnitOutput {
  /** A norm of four numbers is one to some units of round-off. */
  private static final double ROUNDING = 8 * Math.ulp(1.0);

  private final int[] start;
  private final List<String> joints = new ArrayList<>();
  private double largest;
  private double time;
  private int worst;

  UnitOutput(ModelDescription description) {
    List<Integer> starts = new ArrayList<>();
    int position = 0;
    for (JointVariables joint : description.joints()) {
      if (joint.type().hasEulerParameters()) {
        starts.add(position);
        joints.add(joint.name());
      }
      position += joint.type().positionCount();
    }
    start = starts.stream().mapToInt(Integer::intValue).toArray();
  }

  /**
   * Scales the Euler parameters of a row.
   *
   * @param row overwritten
   * @param at where the positions begin
   */
  void normalize(double t, double[] row, int at) {
    for (int i = 0; i < start.length; i++) {
      double norm = EulerParameters.norm(row, at + start[i]);
      if (Math.abs(norm - 1) > largest) {
        largest = Math.abs(norm - 1);
        time = t;
        worst = i;
      }
      for (int k = at + start[i]; k < at + start[i] + 4; k++) {
        row[k] /= norm;
      }
    }
  }

  /**
   * Scales the Euler parameters of a state without recording the drift.
   *
   * @param state overwritten
   * @param at where the positions begin
   */
  void scale(double[] state, int at) {
    for (int first : start) {
      double norm = EulerParameters.norm(state, at + first);
      for (int k = at + first; k < at + first + 4; k++) {
        state[k] /= norm;
      }
    }
  }

  /** Returns a note, or none if all norms differ from one only by rounding. */
  List<Note> notes() {
    if (largest <= ROUNDING) {
      return List.of();
    }
    String text =
        String.format(
            "The norm of the Euler parameters of joint \"%s\" had left one by %.1e, the most of"
                + " all; they are put out with norm one.",
            joints.get(worst), largest);
    return List.of(new Note(MessageCode.EULER_PARAMETER_NORM, time, false, text));
  }
}
