package org.mechservice.solver.closure.model;

import java.util.Arrays;
import java.util.Optional;
import java.util.function.Consumer;
import org.mechservice.solver.api.capability.Defects.Defect;
import org.mechservice.solver.closure.ClosedTree;
import org.mechservice.solver.closure.assembly.ClosedStart;
import org.mechservice.solver.closure.assembly.LoopDefect;
import org.mechservice.solver.closure.assembly.LoopFinding;
import org.mechservice.solver.closure.assembly.PositionEquations;
import org.mechservice.solver.closure.equations.CoordinateUnits;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.closure.equations.LoopRounding;
import org.mechservice.solver.kinematics.StateCoordinates;
import org.mechservice.solver.linear.SparseMatrix;

/**
 * Computes dependent positions and velocities from independent ones: positions by Newton's method,
 * velocities by the differentiated equations. Chooses other independent coordinates when the
 * dependent block becomes ill-conditioned. Workspace of one thread.
 */
public final class Completion {
  /**
   * Correction at which Newton's method has converged: the next one would be its square, below
   * round-off.
   */
  private static final double CONVERGED = 1e-8;

  /**
   * Largest total move of a coordinate; beyond half a radian the solution may belong to another
   * assembly.
   */
  private static final double TOO_FAR = 0.5;

  private static final int ITERATIONS = 12;

  /** Relative residual above which an omitted equation is no longer redundant. */
  private static final double LEFT_OUT = 1e-7;

  /**
   * Factor by which the smallest pivot of another choice must be larger for the choice to change.
   * Dependent coordinates then never move much faster than independent ones. Waiting until a pivot
   * has fallen to 1e-3 makes the error of a pendulum in crossed slides 1500 times larger, at 1e-10.
   */
  private static final double BETTER = 2;

  /**
   * Relative difference from the expected velocities above which dependent velocities belong to
   * another branch. Expected velocities are the predicted ones in the argument, and those that the
   * equations of the last accepted state give.
   */
  private static final double OTHER_BRANCH = 0.25;

  /**
   * Scaled speed, 1/s, below which a mechanism is at rest: a radian in thirty thousand years. The
   * velocities of a structure that cannot move are rounding errors, and change by as much as their
   * own size.
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
   * @param start ranks of the equations of the loops
   * @param formulation label of the formulation
   * @param notes receives a finding for each singular position passed
   */
  Completion(ClosedTree work, ClosedStart start, String formulation, Consumer<LoopFinding> notes) {
    int rank = start.rank();
    this.work = work;
    loops = work.loops;
    units = work.units;
    rounding = new LoopRounding(work.tree, loops, work.coordinates);
    StateCoordinates coordinates = work.coordinates;
    positions = new PositionEquations(loops, coordinates);
    nq = work.nq;
    nv = work.nv;
    boolean large = loops.isLarge();
    ofPositions =
        Partition.of(positions.matrix, nq, start.positionRank() + coordinates.ballCount(), large);
    ofVelocities = Partition.of(loops.jacobian, nv, rank, large);
    correction = new double[ofPositions.rank()];
    velocityCorrection = new double[rank];
    SingularityMonitor.Method method = new SingularityMonitor.Method(formulation, false);
    watch = new SingularityMonitor(loops, ofVelocities, method, notes);
    before = Partition.of(loops.jacobian, nv, rank, large);
    acceptedJacobian = loops.jacobian.sameShape();
    acceptedOffset = new double[loops.count()];
  }

  /** Returns the partition of the velocities; factored by {@link #complete}. */
  public Partition ofVelocities() {
    return ofVelocities;
  }

  /** Returns the partition of the positions. */
  Partition ofPositions() {
    return ofPositions;
  }

  /** Forms the Jacobian of the position equations at the placed state. */
  void formPositionMatrix(double[] y) {
    positions.differentiate(y);
  }

  /** Returns the Jacobian of the position equations as last formed. */
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
   * @return false if fewer equations than expected are independent
   */
  boolean begin(double t, double[] y) {
    work.place(t, y);
    differentiate(y);
    double[] rows = new double[positions.count];
    Arrays.setAll(rows, row -> 1 / positions.size(row));
    ofPositions.scale(rows, units.positions);
    double[] loopRows = new double[loops.count()];
    Arrays.setAll(loopRows, row -> 1 / loops.size(row));
    ofVelocities.scale(loopRows, units.velocities);
    remember(y);
    boolean positionsChosen = ofPositions.choose(positions.matrix);
    boolean velocitiesChosen = ofVelocities.choose(loops.jacobian);
    return watch.begin(t) && positionsChosen && velocitiesChosen;
  }

  private void differentiate(double[] y) {
    positions.evaluate(y);
    positions.differentiate(y);
  }

  /** Overwrites dependent positions and velocities; returns false if there is no solution. */
  boolean complete(double t, double[] y) {
    boolean done =
        !watch.stallsAtSingularity() && completePositions(t, y) && completeVelocities(t, y);
    watch.tried(done);
    return done;
  }

  /** Returns the defect of a failed {@link #begin}. */
  Defect startsSingular() {
    return LoopDefect.singularStart(loops.name(watch.weakestRow()));
  }

  /** Returns the defect that the last attempted state has no dependent velocities. */
  Defect locked() {
    return watch.singular(0);
  }

  /**
   * Returns the reason why the motion cannot continue from the last accepted state: a singular
   * position, or a failed completion of the last attempted state.
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

  /** Corrects the dependent positions once; returns the largest scaled change. */
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

  /** Returns whether the equations of the last accepted state give nearly the same velocities. */
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

  /** Returns the end of the elements of a row of J that belong to velocities of the state. */
  private int endOfState(int row) {
    int end = loops.jacobian.start[row + 1];
    while (end > loops.jacobian.start[row] && loops.jacobian.column[end - 1] >= nv) {
      end--;
    }
    return end;
  }

  /** Stores J and Φ_t = Φ' − J v for comparison with the next state. */
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
   * Returns the defect of an omitted equation that is no longer redundant, if there is one.
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

  /** Writes the choice of coordinates and the values that the next states are compared with. */
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

  /** Restores what {@link #save} wrote. */
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
   * Records an accepted state.
   *
   * @return whether other coordinates are independent from now on
   */
  boolean accepted(double t, double[] y) {
    work.place(t, y);
    differentiate(y);
    remember(y);
    boolean other = ofPositions.renew(positions.matrix, BETTER);
    boolean others = ofVelocities.renew(loops.jacobian, BETTER) || other;
    watch.accepted(t);
    return others;
  }

  /**
   * Records a state after an event; the choice of coordinates stays.
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
}
