package org.mechservice.solver.dynamics.event;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.mechservice.solver.api.run.RunNotes.Note;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Tape;
import org.mechservice.solver.expression.TapePieces;
import org.mechservice.solver.mechanism.Overlap;

/**
 * Looks at the start of each step how far shapes in contact are inside each other, and notes those
 * that are further than their law means.
 *
 * <p>Workspace of one run; nothing allocates in a step.
 */
final class OverlapMonitor {
  private final List<String> names;
  private final TapePieces tape;
  private final int[] quantities;
  private final double[] leaves;
  private final double[] point;
  private final double[] deepest;
  private final double[] most;
  private final double[] since;

  /**
   * @param quantities what is evaluated along a step, the leaves of {@link #tape} among it
   */
  OverlapMonitor(List<Overlap> overlaps, List<Expression> quantities) {
    names = overlaps.stream().map(Overlap::contact).toList();
    Tape results = tape(overlaps);
    tape = new TapePieces(results, results.resultCount());
    this.quantities = results.leaves().stream().mapToInt(quantities::indexOf).toArray();
    leaves = new double[this.quantities.length];
    point = tape.newPoint();
    deepest = new double[names.size()];
    most = new double[names.size()];
    since = new double[names.size()];
    Arrays.fill(since, Double.NaN);
  }

  /** Returns the tape of depth and largest depth of each contact. */
  static Tape tape(List<Overlap> overlaps) {
    List<Expression> results = new ArrayList<>();
    for (Overlap overlap : overlaps) {
      results.add(overlap.depth());
      results.add(overlap.most());
    }
    return new Tape(results);
  }

  /** Looks at the quantities at a state. */
  void look(double t, double[] values) {
    if (deepest.length == 0) {
      return;
    }
    for (int i = 0; i < leaves.length; i++) {
      leaves[i] = values[quantities[i]];
    }
    tape.at(leaves, point);
    for (int i = 0; i < deepest.length; i++) {
      double depth = tape.value(2 * i, point);
      double limit = tape.value(2 * i + 1, point);
      if (limit > 0 && depth > limit && depth > deepest[i]) {
        since[i] = Double.isNaN(since[i]) ? t : since[i];
        deepest[i] = depth;
        most[i] = limit;
      }
    }
  }

  /** Returns a note of each contact whose shapes have been inside each other too far. */
  List<Note> notes() {
    List<Note> notes = new ArrayList<>();
    for (int i = 0; i < deepest.length; i++) {
      if (!Double.isNaN(since[i])) {
        String text =
            String.format(
                Locale.ROOT,
                "The shapes of contact \"%s\" are inside each other by up to %.4g m, further than"
                    + " %.4g m, where one is behind the other: the contact no longer pushes them"
                    + " apart the way they came. Make it stiffer, or begin where they are apart.",
                names.get(i),
                deepest[i],
                most[i]);
        notes.add(new Note(MessageCode.SHAPES_OVERLAP, since[i], true, text));
      }
    }
    return notes;
  }

  /** Returns what a run carries over; not copied. */
  double[][] carried() {
    return new double[][] {deepest, most, since};
  }
}
