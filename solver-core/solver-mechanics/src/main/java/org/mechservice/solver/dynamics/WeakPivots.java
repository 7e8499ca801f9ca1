package org.mechservice.solver.dynamics;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.run.RunNotes.Note;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.dynamics.tree.PivotCheck;

/** Warnings about joints with nearly singular inertia: one per joint, for the worst state. */
final class WeakPivots {
  private final StateJoints joints;
  private final double[] condition;
  private final double[] time;

  WeakPivots(StateJoints joints) {
    this.joints = joints;
    condition = new double[joints.velocityCount()];
    time = new double[condition.length];
  }

  void observe(double t, PivotCheck check) {
    int velocity = check.weakVelocity();
    if (velocity != ExplicitModel.REGULAR && check.condition() > condition[velocity]) {
      condition[velocity] = check.condition();
      time[velocity] = t;
    }
  }

  List<Note> notes() {
    List<Note> notes = new ArrayList<>();
    for (int velocity = 0; velocity < condition.length; velocity++) {
      if (condition[velocity] > 0) {
        String text =
            String.format(
                "The inertia at %s is nearly singular: the joints beyond leave one part in %.1e of"
                    + " it, so its acceleration has about %d digits.",
                joints.name(velocity), condition[velocity], digits(condition[velocity]));
        notes.add(new Note(MessageCode.NEARLY_SINGULAR_INERTIA, time[velocity], true, text));
      }
    }
    notes.sort((a, b) -> Double.compare(a.time(), b.time()));
    return notes;
  }

  private static int digits(double condition) {
    return Math.max(0, (int) Math.floor(-Math.log10(condition * Math.ulp(1.0))));
  }
}
