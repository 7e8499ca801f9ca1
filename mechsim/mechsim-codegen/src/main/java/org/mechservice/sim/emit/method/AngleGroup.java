package org.mechservice.sim.emit.method;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarOperation;

/**
 * Angles whose sines and cosines are computed together: a single one, or several in a loop, whose
 * angles are consecutive inputs or the same multiple of consecutive inputs.
 *
 * @param start index of the first among the program's angles
 * @param count number of angles
 * @param angle the first angle
 */
public record AngleGroup(int start, int count, Scalar angle) {
  /** Smallest number of consecutive angles for a loop. */
  private static final int SHORTEST_LOOP = 3;

  /** Returns all angles of a program, in order. */
  public static List<AngleGroup> of(List<Scalar> angles) {
    List<AngleGroup> runs = new ArrayList<>();
    for (int i = 0; i < angles.size(); ) {
      int length = length(angles, i);
      int count = length >= SHORTEST_LOOP ? length : 1;
      runs.add(new AngleGroup(i, count, angles.get(i)));
      i += count;
    }
    return runs;
  }

  private static int length(List<Scalar> angles, int start) {
    AngleGroup first = new AngleGroup(start, 1, angles.get(start));
    if (first.input().operation() != ScalarOperation.INPUT) {
      return 1;
    }
    int length = 1;
    while (start + length < angles.size()
        && first.continuesWith(angles.get(start + length), length)) {
      length++;
    }
    return length;
  }

  private boolean continuesWith(Scalar other, int distance) {
    AngleGroup next = new AngleGroup(start + distance, 1, other);
    return next.input().operation() == ScalarOperation.INPUT
        && next.input().index() == input().index() + distance
        && next.isMultiple() == isMultiple()
        && (!isMultiple() || next.factor() == factor());
  }

  /** Returns whether it is computed in a loop. */
  public boolean isLoop() {
    return count > 1;
  }

  /** Returns whether inputs are multiplied by a constant. */
  public boolean isMultiple() {
    return angle.operation() == ScalarOperation.MULTIPLY && angle.first().isConstant();
  }

  /** Returns the constant that inputs are multiplied by, if they are. */
  public Scalar factor() {
    return angle.first();
  }

  /** Returns the first of the inputs, if it is one. */
  public Scalar input() {
    return isMultiple() ? angle.second() : angle;
  }
}
