package org.mechservice.solver.closure.model;

import java.util.Optional;
import java.util.function.Consumer;
import org.mechservice.solver.api.capability.Defects.Defect;
import org.mechservice.solver.closure.assembly.LoopDefect;
import org.mechservice.solver.closure.assembly.LoopFinding;
import org.mechservice.solver.closure.equations.LoopEquations;

/**
 * Measures at each accepted state how close the loops are to a position in which their equations
 * lose rank. Two branches of the motion meet in such a position, and neither energy nor residuals
 * show a change from one branch to the other (docs/theory/loops.md#singular-positions).
 *
 * <p>Closeness is the smallest pivot of the scaled J by full pivoting, divided by its largest value
 * in the run. A step may cross a singular position; J is therefore interpolated to the point at
 * which the pivot would vanish. Workspace of one thread.
 */
final class SingularityMonitor {
  /**
   * The method that runs, for advice.
   *
   * @param formulation its label
   * @param penalty whether the closure is penalty
   */
  record Method(String formulation, boolean penalty) {}

  /** Closeness at which a warning is given. */
  static final double NEAR = 1e-2;

  /** Closeness above which a singular position has been passed and the next one is counted anew. */
  private static final double CLEAR = 5 * NEAR;

  /**
   * Smallest pivot at which the start is singular. Scaled pivots are about 1, so this value is
   * rounding.
   */
  private static final double NOTHING = 1e-11;

  /** Value of {@link #closest} while a run that began in a singular position is still near it. */
  private static final double LEAVING = -1;

  /** Closeness at both ends of a step above which the step crosses no singular position. */
  private static final double LOOK_BETWEEN = 0.3;

  /**
   * Closeness below which rounding shows in accelerations; it grows with the inverse cube. The
   * second constant is the number of successive approaching steps after which rounding is the cause
   * of the short steps: a regular motion crosses the position in one or two.
   */
  private static final double ROUGH = 3e-4;

  private static final int CREEPING = 10_000;

  private final LoopEquations loops;
  private final Method method;
  private final Partition partition;
  private final Consumer<LoopFinding> notes;

  /** Scaled J of the last accepted state, and J interpolated to the present one. */
  private final double[] before;

  private final double[] between;
  private double timeBefore;
  private double closenessBefore = 1;
  private double largest;

  /** Whether the loops did not close at the last attempted state; the equation and its residual. */
  private boolean failed;

  private int failedRow;
  private double failedResidual;

  /** Smallest closeness in the present approach to a singular position; 1 outside an approach. */
  private double closest = 1;

  private double closestTime;
  private int closestRow;
  private int rowBefore;

  /**
   * Number of successive steps below {@link #ROUGH} that approached the position, or did not leave
   * the start.
   */
  private int closer;

  /**
   * @param partition partition of the velocities, which computes pivots
   * @param notes receives a finding for each singular position passed
   */
  SingularityMonitor(
      LoopEquations loops, Partition partition, Method method, Consumer<LoopFinding> notes) {
    this.loops = loops;
    this.method = method;
    this.partition = partition;
    this.notes = notes;
    before = new double[partition.scaledLength()];
    between = new double[before.length];
  }

  /** Returns the length of what {@link #save} writes. */
  int stateLength() {
    return before.length + 8;
  }

  /** Writes the values that the next states are compared with. */
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

  /** Restores what {@link #save} wrote. */
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
   * Records the start state, after the partition has chosen. A singular start is reported once, not
   * again when the run leaves it.
   *
   * @return whether the start is regular
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
   * Returns whether ever shorter steps approach a singular position without reaching it, so that
   * the run cannot continue.
   */
  boolean stallsAtSingularity() {
    return closer >= CREEPING;
  }

  /** Records whether the loops could be closed at the placed state. */
  void tried(boolean closed) {
    failed = !closed;
    if (failed) {
      failedRow = loops.worst(loops.value);
      failedResidual = loops.value[failedRow];
    }
  }

  /**
   * Returns the reason why the motion cannot continue from the last accepted state: a singular
   * position, or loops that do not close at the last attempted state.
   */
  Optional<Defect> obstacle() {
    if (isNearSingular()) {
      return Optional.of(singular(closenessBefore));
    }
    return failed
        ? Optional.of(LoopDefect.open(loops.name(failedRow), failedResidual, loops.unit(failedRow)))
        : Optional.empty();
  }

  /** Returns whether the last accepted state is near a singular position. */
  boolean isNearSingular() {
    return closenessBefore < CLEAR;
  }

  /** Returns the defect of a singular position. */
  Defect singular(double closeness) {
    return LoopDefect.singular(
        loops.name(rowBefore), closeness, method.formulation(), method.penalty());
  }

  /** Returns the equation with the smallest pivot at the last accepted state. */
  int weakestRow() {
    return rowBefore;
  }

  /**
   * Records the placed state after an event, for which the partition has examined J. Positions
   * between it and the last state were not passed.
   *
   * @param closed whether the loops are closed there
   */
  void jumped(double t, boolean closed) {
    tried(closed);
    largest = Math.max(largest, partition.bestPivot());
    keep(t, partition.bestPivot() / largest);
    report();
  }

  /** Records an accepted state, at which the partition has looked for a better choice. */
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
