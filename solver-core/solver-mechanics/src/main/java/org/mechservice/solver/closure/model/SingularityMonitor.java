package org.mechservice.solver.closure.model;

import java.util.Optional;
import java.util.function.Consumer;
import org.mechservice.solver.api.capability.Defects.Defect;
import org.mechservice.solver.closure.assembly.LoopDefect;
import org.mechservice.solver.closure.assembly.LoopFinding;
import org.mechservice.solver.closure.equations.LoopEquations;

/**
 * Watches how close the loops come to positions in which their equations lose rank, from one
 * accepted state to the next. There two branches of the motion meet, and neither energy nor
 * residuals would show a change from one to the other (NUMERICS §3).
 *
 * <p>Closeness is the smallest pivot of J, rows over their sizes and columns in units, as full
 * pivoting finds it, over the largest that it was in the run. A step may lead across: J is then
 * interpolated to where the pivot would vanish. Workspace of one thread.
 */
final class SingularityMonitor {
  /** Closeness worth a warning. */
  static final double NEAR = 1e-2;

  /** Closeness at which a singular position lies behind: the next one is another. */
  private static final double CLEAR = 5 * NEAR;

  /**
   * Smallest pivot at which the start is a singular position: in units of the mechanism, where
   * pivots are about 1, this is rounding.
   */
  private static final double NOTHING = 1e-11;

  /** Stands for {@link #closest} as long as a run that began in a singular position is near it. */
  private static final double LEAVING = -1;

  /** Above this closeness at both ends of a step there is nothing in between. */
  private static final double LOOK_BETWEEN = 0.3;

  /**
   * Closeness below which rounding, which grows with its inverse cube, shows in accelerations, and
   * the steps in a row that come closer after which it is rounding that makes them so short: a
   * motion that goes on steps across in one or two.
   */
  private static final double ROUGH = 3e-4;

  private static final int CREEPING = 10_000;

  private final LoopEquations loops;
  private final Partition partition;
  private final Consumer<LoopFinding> notes;

  /** Scaled J of the last accepted state, and what is between it and this one. */
  private final double[] before;

  private final double[] between;
  private double timeBefore;
  private double closenessBefore = 1;
  private double largest;

  /** Whether the loops did not close at the state last tried, where, and by how much. */
  private boolean failed;

  private int failedRow;
  private double failedResidual;

  /** The closest since a singular position came near; none if it is 1. */
  private double closest = 1;

  private double closestTime;
  private int closestRow;
  private int rowBefore;

  /** Steps in a row where it is rough that have come closer, or not left where the run began. */
  private int closer;

  /**
   * @param partition of the velocities, which finds pivots
   * @param notes is told of singular positions passed
   */
  SingularityMonitor(LoopEquations loops, Partition partition, Consumer<LoopFinding> notes) {
    this.loops = loops;
    this.partition = partition;
    this.notes = notes;
    before = new double[partition.scaledLength()];
    between = new double[before.length];
  }

  /** Returns the length of what {@link #save} writes. */
  int stateLength() {
    return before.length + 8;
  }

  /** Writes what the next states are compared with. */
  void save(double[] state, int at) {
    System.arraycopy(before, 0, state, at, before.length);
    int next = at + before.length;
    state[next++] = timeBefore;
    state[next++] = closenessBefore;
    state[next++] = closest;
    state[next++] = closestTime;
    state[next++] = closestRow;
    state[next++] = rowBefore;
    state[next++] = largest;
    state[next] = closer;
  }

  /** Takes up what {@link #save} wrote. */
  void restore(double[] state, int at) {
    System.arraycopy(state, at, before, 0, before.length);
    int next = at + before.length;
    timeBefore = state[next++];
    closenessBefore = state[next++];
    closest = state[next++];
    closestTime = state[next++];
    closestRow = (int) state[next++];
    rowBefore = (int) state[next++];
    largest = state[next++];
    closer = (int) state[next];
  }

  /**
   * Takes the state a run begins with, in which the partition has chosen.
   *
   * @return whether it is no singular position; what is said of one at the start is not said again
   *     when the run leaves it
   */
  boolean begin(double t) {
    double pivot = partition.bestPivot();
    boolean regular = pivot > NOTHING;
    largest = regular ? pivot : 1;
    closest = regular ? 1 : LEAVING;
    keep(t, regular ? 1 : 0);
    return regular;
  }

  /**
   * Returns whether steps creep up to a singular position and would never reach it: no further
   * state is to be found then.
   */
  boolean creeps() {
    return closer >= CREEPING;
  }

  /** Takes note of whether the loops could be closed at a state tried, where they are placed. */
  void tried(boolean closed) {
    failed = !closed;
    if (failed) {
      failedRow = loops.worst(loops.value);
      failedResidual = loops.value[failedRow];
    }
  }

  /**
   * Returns what keeps the loops from going on from the last accepted state: a singular position,
   * or that the last state tried could not be closed.
   */
  Optional<Defect> obstacle() {
    if (closenessBefore < CLEAR) {
      return Optional.of(LoopDefect.singular(loops.name(rowBefore), closenessBefore));
    }
    return failed
        ? Optional.of(LoopDefect.open(loops.name(failedRow), failedResidual, loops.unit(failedRow)))
        : Optional.empty();
  }

  /** Returns the equation whose pivot was smallest in the last accepted state. */
  int weakestRow() {
    return rowBefore;
  }

  /**
   * Takes a state to which an event has led, where the loops are placed and in which the partition
   * has looked for a choice: what lies between it and the last one was not passed.
   *
   * @param closed whether the loops are closed there
   */
  void jumped(double t, boolean closed) {
    tried(closed);
    largest = Math.max(largest, partition.bestPivot());
    keep(t, partition.bestPivot() / largest);
    report();
  }

  /** Takes note of an accepted state, at which the partition looked for a better choice. */
  void accepted(double t) {
    largest = Math.max(largest, partition.bestPivot());
    double closeness = partition.bestPivot() / largest;
    remember(closeness, t);
    double s = closenessBefore / (closenessBefore + closeness);
    double timeOfLast = timeBefore;
    boolean draws = closeness < closenessBefore || closest == LEAVING;
    closer = closeness < ROUGH && draws ? closer + 1 : 0;
    boolean look = closest >= 0 && Math.min(closeness, closenessBefore) < LOOK_BETWEEN;
    for (int i = 0; look && i < between.length; i++) {
      between[i] = (1 - s) * before[i] + s * partition.scaled()[i];
    }
    keep(t, closeness);
    if (look && s >= 0) {
      remember(partition.bestPivot(between) / largest, timeOfLast + s * (t - timeOfLast));
    }
    if (closeness >= CLEAR) {
      report();
    }
  }

  private void keep(double t, double closeness) {
    System.arraycopy(partition.scaled(), 0, before, 0, before.length);
    timeBefore = t;
    closenessBefore = closeness;
    rowBefore = partition.weakestRow();
  }

  private void report() {
    if (closest >= 0 && closest < NEAR) {
      String equation = loops.name(closestRow);
      notes.accept(
          new LoopFinding(LoopFinding.Kind.SINGULAR_PASSED, equation, closest, "1", closestTime));
    }
    closest = 1;
  }

  private void remember(double closeness, double t) {
    if (closeness < closest) {
      closest = closeness;
      closestTime = t;
      closestRow = partition.weakestRow();
    }
  }
}
