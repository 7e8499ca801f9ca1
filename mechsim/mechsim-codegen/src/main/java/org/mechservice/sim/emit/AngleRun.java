package org.mechservice.sim.emit;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.sim.symbolic.Operation;
import org.mechservice.sim.symbolic.Scalar;

/**
 * Angles whose sines and cosines are computed together: one by itself, or several in a loop, inputs
 * that follow one another or the same multiple of such.
 *
 * @param start which of the program's angles is the first
 * @param count how many
 * @param angle the first
 */
record AngleRun(int start, int count, Scalar angle) {
  /** Fewer angles in a row than this are written one by one. */
  private static final int SHORTEST_LOOP = 3;

  /** Returns all angles of a program, in order. */
  static List<AngleRun> of(List<Scalar> angles) {
    List<AngleRun> runs = new ArrayList<>();
    for (int i = 0; i < angles.size(); ) {
      int length = length(angles, i);
      int count = length >= SHORTEST_LOOP ? length : 1;
      runs.add(new AngleRun(i, count, angles.get(i)));
      i += count;
    }
    return runs;
  }

  private static int length(List<Scalar> angles, int start) {
    AngleRun first = new AngleRun(start, 1, angles.get(start));
    if (first.input().operation() != Operation.INPUT) {
      return 1;
    }
    int length = 1;
    while (start + length < angles.size() && first.goesOn(angles.get(start + length), length)) {
      length++;
    }
    return length;
  }

  private boolean goesOn(Scalar other, int distance) {
    AngleRun next = new AngleRun(start + distance, 1, other);
    return next.input().operation() == Operation.INPUT
        && next.input().index() == input().index() + distance
        && next.isMultiple() == isMultiple()
        && (!isMultiple() || next.factor() == factor());
  }

  /** Returns whether it is computed in a loop. */
  boolean isLoop() {
    return count > 1;
  }

  /** Returns whether inputs are multiplied by a constant. */
  boolean isMultiple() {
    return angle.operation() == Operation.MULTIPLY && angle.first().isConstant();
  }

  /** Returns the constant that inputs are multiplied by, if they are. */
  Scalar factor() {
    return angle.first();
  }

  /** Returns the first of the inputs, if it is one. */
  Scalar input() {
    return isMultiple() ? angle.second() : angle;
  }
}
