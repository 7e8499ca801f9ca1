package org.mechservice.solver.closure.model;

import java.util.Arrays;
import java.util.Optional;
import java.util.function.Consumer;
import org.mechservice.solver.api.capability.Defects.Defect;
import org.mechservice.solver.closure.ClosedTree;
import org.mechservice.solver.closure.assembly.LoopDefect;
import org.mechservice.solver.closure.assembly.LoopFinding;
import org.mechservice.solver.closure.assembly.PositionEquations;
import org.mechservice.solver.closure.equations.CoordinateUnits;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.closure.equations.LoopRounding;
import org.mechservice.solver.kinematics.StateCoordinates;
import org.mechservice.solver.linear.SparseMatrix;

/**
 * Finds dependent positions and velocities from independent ones: positions by Newton's method,
 * velocities by the equations differentiated. When the coordinates chosen as independent lose their
 * hold, others are chosen. Workspace of one thread.
 */
public final class Completion {
  /** After a correction this small the next would be its square: below round-off. */
  private static final double CONVERGED = 1e-8;

  /** Beyond half a radian the solution found may be that of another assembly. */
  private static final double TOO_FAR = 0.5;

  private static final int ITERATIONS = 12;

  /** Residual over its size beyond which an equation left out does not follow from the others. */
  private static final double LEFT_OUT = 1e-7;

  /**
   * Other coordinates are taken when their smallest pivot is larger by this factor: what is
   * dependent then never moves much faster than what is not. Waiting until a pivot has fallen to
   * 1e-3 makes the error of a pendulum in crossed slides 1500 times larger, at 1e-10.
   */
  private static final double BETTER = 2;

  /**
   * Dependent velocities are those of another branch if they differ from the expected ones by this
   * part of all velocities. Expected are those handed in, which were predicted, and those that the
   * equations of the last accepted state would give.
   */
  private static final double OTHER_BRANCH = 0.25;

  /**
   * Velocities in units that are those of a mechanism at rest, 1/s: a radian in thirty thousand
   * years. In a structure that cannot move all velocities are rounding errors, and their changes as
   * large as themselves.
   */
  private static final double AT_REST = 1e-12;

  private final ClosedTree work;
  private final LoopEquations loops;
  private final PositionEquations positions;
  private final Partition ofPositions;
  private final Partition ofVelocities;
  private final CoordinateUnits units;
  private final LoopRounding rounding;
  private final int nq;
  private final int nv;
  private final double[] correction;
  private final double[] velocityCorrection;
  private final SingularityMonitor watch;
  private final Partition before;
  private final SparseMatrix acceptedJacobian;
  private final double[] acceptedOffset;
  private double acceptedSpeed;

  /**
   * @param rank number of independent equations among those of the loops
   * @param notes is told of singular positions that were passed
   */
  Completion(ClosedTree work, int rank, Consumer<LoopFinding> notes) {
    this.work = work;
    loops = work.loops;
    units = work.units;
    rounding = new LoopRounding(work.tree, loops, work.coordinates);
    StateCoordinates coordinates = work.coordinates;
    positions = new PositionEquations(loops, coordinates);
    nq = work.nq;
    nv = work.nv;
    boolean large = loops.isLarge();
    ofPositions = Partition.of(positions.matrix, nq, rank + coordinates.ballCount(), large);
    ofVelocities = Partition.of(loops.jacobian, nv, rank, large);
    correction = new double[ofPositions.rank()];
    velocityCorrection = new double[rank];
    watch = new SingularityMonitor(loops, ofVelocities, notes);
    before = Partition.of(loops.jacobian, nv, rank, large);
    acceptedJacobian = loops.jacobian.sameShape();
    acceptedOffset = new double[loops.count()];
  }

  /** Returns which velocities are found from which; factored by {@link #complete}. */
  public Partition ofVelocities() {
    return ofVelocities;
  }

  /** Returns which positions are found from which. */
  Partition ofPositions() {
    return ofPositions;
  }

  /** Forms the equations of positions, differentiated, where the loops are. */
  void formPositionMatrix(double[] y) {
    positions.differentiate(y);
  }

  /** Returns the equations of positions, differentiated, as formed last. */
  SparseMatrix positionMatrix() {
    return positions.matrix;
  }

  /** Returns whether a component of y = [q; v] is independent. */
  boolean independent(int component) {
    return component < nq
        ? ofPositions.isIndependent(component)
        : ofVelocities.isIndependent(component - nq);
  }

  /**
   * Chooses the independent coordinates at a state that closes the loops.
   *
   * @return false if there are not as many independent equations as there should be
   */
  boolean begin(double t, double[] y) {
    work.place(t, y);
    differentiate(y);
    double[] rows = new double[positions.count];
    Arrays.fill(rows, 1);
    for (int row = 0; row < loops.count(); row++) {
      rows[row] = 1 / loops.size(row);
    }
    ofPositions.scale(rows, units.positions);
    ofVelocities.scale(rows, units.velocities);
    remember(y);
    boolean positionsChosen = ofPositions.choose(positions.matrix);
    boolean velocitiesChosen = ofVelocities.choose(loops.jacobian);
    return watch.begin(t) && positionsChosen && velocitiesChosen;
  }

  private void differentiate(double[] y) {
    positions.evaluate(y);
    positions.differentiate(y);
  }

  /** Overwrites dependent positions and velocities; returns false if nothing fits. */
  boolean complete(double t, double[] y) {
    boolean done = !watch.creeps() && completePositions(t, y) && completeVelocities(t, y);
    watch.tried(done);
    return done;
  }

  /** Says that {@link #begin} could not choose. */
  Defect startsSingular() {
    return LoopDefect.singularStart(loops.name(watch.weakestRow()));
  }

  /** Says that the dependent velocities cannot be found at the last state tried. */
  Defect locked() {
    return LoopDefect.singular(loops.name(watch.weakestRow()), 0);
  }

  /**
   * Returns what keeps the loops from going on from the last accepted state: a singular position,
   * or that the last state tried could not be completed.
   */
  Optional<Defect> obstacle() {
    return watch.obstacle();
  }

  private boolean completePositions(double t, double[] y) {
    for (int i = 0; i < ITERATIONS; i++) {
      work.placeLoops(t, y);
      differentiate(y);
      if (!ofPositions.factor(positions.matrix)) {
        return false;
      }
      double size = correct(y);
      if (!(size <= TOO_FAR)) {
        return false;
      }
      if (size <= CONVERGED) {
        return true;
      }
    }
    return false;
  }

  /** One correction of the dependent positions; returns its size, the largest in units. */
  private double correct(double[] y) {
    for (int i = 0; i < correction.length; i++) {
      correction[i] = positions.value[ofPositions.kept[i]];
    }
    ofPositions.solve(correction);
    double size = 0;
    for (int i = 0; i < correction.length; i++) {
      int j = ofPositions.dependent[i];
      y[j] -= correction[i];
      size = larger(size, Math.abs(correction[i]) / units.positions[j]);
    }
    return size;
  }

  /** Returns the larger of two, NaN if one is. */
  private static double larger(double a, double b) {
    return a > b ? a : b >= a ? b : Double.NaN;
  }

  private boolean completeVelocities(double t, double[] y) {
    work.place(t, y);
    if (!keptAreClosed(y) || !ofVelocities.factor(loops.jacobian)) {
      return false;
    }
    for (int i = 0; i < velocityCorrection.length; i++) {
      velocityCorrection[i] = loops.rate[ofVelocities.kept[i]];
    }
    ofVelocities.solve(velocityCorrection);
    double change = 0;
    for (int i = 0; i < velocityCorrection.length; i++) {
      int j = ofVelocities.dependent[i];
      y[nq + j] -= velocityCorrection[i];
      change = larger(change, Math.abs(velocityCorrection[i]) / units.velocities[j]);
    }
    double speed = Math.max(acceptedSpeed, units.speed(y, nq));
    return change <= Math.max(AT_REST, OTHER_BRANCH * speed) || asBefore(y, OTHER_BRANCH * speed);
  }

  /** Whether the equations of the last accepted state give nearly the same velocities. */
  private boolean asBefore(double[] y, double tolerance) {
    before.copyChoice(ofVelocities);
    if (!before.factor(acceptedJacobian)) {
      return false;
    }
    for (int i = 0; i < velocityCorrection.length; i++) {
      int row = ofVelocities.kept[i];
      double rate = acceptedOffset[row];
      for (int e = acceptedJacobian.start[row]; e < endOfState(row); e++) {
        rate += acceptedJacobian.value[e] * y[nq + acceptedJacobian.column[e]];
      }
      velocityCorrection[i] = rate;
    }
    before.solve(velocityCorrection);
    double change = 0;
    for (int i = 0; i < velocityCorrection.length; i++) {
      double unit = units.velocities[ofVelocities.dependent[i]];
      change = larger(change, Math.abs(velocityCorrection[i]) / unit);
    }
    return change <= tolerance;
  }

  /** Returns where the elements of a row of J end that belong to velocities of the state. */
  private int endOfState(int row) {
    int end = loops.jacobian.start[row + 1];
    while (end > loops.jacobian.start[row] && loops.jacobian.column[end - 1] >= nv) {
      end--;
    }
    return end;
  }

  /** Keeps what the next state is compared with: J and Φ_t = Φ' − J v. */
  private void remember(double[] y) {
    acceptedSpeed = units.speed(y, nq);
    acceptedJacobian.copy(loops.jacobian);
    for (int row = 0; row < loops.count(); row++) {
      double rate = loops.rate[row];
      for (int e = acceptedJacobian.start[row]; e < endOfState(row); e++) {
        rate -= acceptedJacobian.value[e] * y[nq + acceptedJacobian.column[e]];
      }
      acceptedOffset[row] = rate;
    }
  }

  /**
   * Returns why an equation that was left out is to be heard after all, if one is.
   *
   * @param y the state last accepted; not modified
   */
  Optional<Defect> leftOutIsOpen(double[] y) {
    int worst = loops.worst(loops.value);
    return worst < 0 || rounding.excess(worst, y) <= LEFT_OUT
        ? Optional.empty()
        : Optional.of(LoopDefect.leftOut(loops.name(worst), loops.value[worst], loops.unit(worst)));
  }

  /** Returns the length of what {@link #save} writes. */
  int stateLength() {
    return ofPositions.stateLength()
        + ofVelocities.stateLength()
        + acceptedJacobian.value.length
        + acceptedOffset.length
        + 1
        + watch.stateLength();
  }

  /** Writes the choice of coordinates and what the next states are compared with. */
  void save(double[] state, int at) {
    int next = at;
    ofPositions.save(state, next);
    next += ofPositions.stateLength();
    ofVelocities.save(state, next);
    next += ofVelocities.stateLength();
    System.arraycopy(acceptedJacobian.value, 0, state, next, acceptedJacobian.value.length);
    next += acceptedJacobian.value.length;
    System.arraycopy(acceptedOffset, 0, state, next, acceptedOffset.length);
    next += acceptedOffset.length;
    state[next] = acceptedSpeed;
    watch.save(state, next + 1);
  }

  /** Takes up what {@link #save} wrote. */
  void restore(double[] state, int at) {
    int next = at;
    ofPositions.restore(state, next);
    next += ofPositions.stateLength();
    ofVelocities.restore(state, next);
    next += ofVelocities.stateLength();
    System.arraycopy(state, next, acceptedJacobian.value, 0, acceptedJacobian.value.length);
    next += acceptedJacobian.value.length;
    System.arraycopy(state, next, acceptedOffset, 0, acceptedOffset.length);
    next += acceptedOffset.length;
    acceptedSpeed = state[next];
    watch.restore(state, next + 1);
  }

  private boolean keptAreClosed(double[] y) {
    for (int i = 0; i < ofVelocities.rank(); i++) {
      if (!(rounding.excess(ofVelocities.kept[i], y) <= LoopRounding.CLOSED)) {
        return false;
      }
    }
    return true;
  }

  /**
   * Takes note of an accepted state.
   *
   * @return whether other coordinates are independent from now on
   */
  boolean accepted(double t, double[] y) {
    work.place(t, y);
    differentiate(y);
    remember(y);
    boolean other = renew(ofPositions, positions.matrix);
    boolean others = renew(ofVelocities, loops.jacobian) || other;
    watch.accepted(t);
    return others;
  }

  /**
   * Takes note of a state to which an event has led; the choice of coordinates stays.
   *
   * @param closed whether the loops are closed there
   */
  void jumped(double t, double[] y, boolean closed) {
    work.place(t, y);
    differentiate(y);
    remember(y);
    ofVelocities.chooseBetter(loops.jacobian, Double.POSITIVE_INFINITY);
    watch.jumped(t, closed);
  }

  private static boolean renew(Partition partition, SparseMatrix matrix) {
    double pivot = partition.smallestPivot(matrix);
    return partition.chooseBetter(matrix, BETTER * pivot);
  }
}
