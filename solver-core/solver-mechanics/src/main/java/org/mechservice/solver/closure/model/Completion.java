package org.mechservice.solver.closure.model;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.IntFunction;
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
 * dependent block becomes ill-conditioned.
 *
 * <p>A solution near the prediction is taken if it plainly continues the last accepted state: the
 * determinant of the dependent block has kept its sign, and positions and velocities fit together
 * over the time between. Otherwise {@link LoopContinuation} follows the positions from that state.
 * An attempted step is accepted only if it leads to the same solution; at a time within the last
 * step its solution is the one. Workspace of one thread.
 */
public final class Completion {
  /** Largest correction of one iteration, in the units of positions. */
  private static final double TOO_FAR = 0.5;

  /**
   * Largest difference, in the units of positions, of a solution from its prediction, and from the
   * trapezoidal rule over the time since the last accepted state, that is taken without following
   * the positions. Assemblies of a loop far from a change point are many times farther apart; near
   * one, the sign of the determinant tells them apart.
   */
  private static final double NEAR = 0.05;

  /** Largest difference of two solutions that are the same one, in the units of positions. */
  private static final double SAME = 1e-6;

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
   * Relative difference from the predicted velocities above which a solution is not taken without
   * following the positions.
   */
  private static final double OTHER_BRANCH = 0.25;

  /**
   * Scaled speed, 1/s, below which a mechanism is at rest: a radian in thirty thousand years. The
   * velocities of a structure that cannot move are rounding errors, and change by as much as their
   * own size.
   */
  private static final double AT_REST = 1e-12;

  /** How far ahead of a state near a singular position this is searched for, s or parts of t. */
  private static final double AHEAD = 1e-2;

  /** Ratio of the golden section; its multiples modulo 1 are spread evenly. */
  private static final double GOLDEN = 0.6180339887498949;

  /** Part of the largest move between two assemblies with which a coordinate is named. */
  private static final double PART_OF_WAY = 0.1;

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
  private final LoopContinuation continuation;

  /** The last accepted state, or the one after an event since then. */
  private Reached reached;

  /** The last accepted state if an event has changed the state since then. */
  private Reached beforeEvent;

  private boolean changedByEvent;

  /** Sign of the determinant of the dependent block at the last solution for positions. */
  private int orientation;

  /** Positions that {@link #complete} was given, those that were followed to, and rates there. */
  private final double[] given;

  private final double[] followed;
  private final double[] rates;

  /** State [q; v; s] with the positions that are being followed. */
  private final double[] state;

  /** Largest change of velocities by the last {@link #completeVelocities}, scaled, 1/s. */
  private double velocityChange;

  /** Where the positions could not be followed any further in the last {@link #complete}. */
  private Optional<Obstacle> obstacle = Optional.empty();

  /** A state that closes the loops, from which others are found. */
  private static final class Reached {
    double time;

    /** Time of the accepted state before: the last step is between the two. */
    double timeBefore;

    /** Positions, and their rates. */
    final double[] positions;

    final double[] rates;

    /** Largest scaled velocity, 1/s. */
    double speed;

    /** Sign of the determinant of the dependent block. */
    int orientation;

    Reached(int nq) {
      positions = new double[nq];
      rates = new double[nq];
    }

    /** Returns whether a time is within the last step. */
    boolean hasPassed(double t) {
      return (t - timeBefore) * (t - time) <= 0;
    }

    int stateLength() {
      return 2 * positions.length + 4;
    }

    void save(double[] state, int at) {
      int n = positions.length;
      System.arraycopy(positions, 0, state, at, n);
      System.arraycopy(rates, 0, state, at + n, n);
      state[at + 2 * n] = time;
      state[at + 2 * n + 1] = timeBefore;
      state[at + 2 * n + 2] = speed;
      state[at + 2 * n + 3] = orientation;
    }

    void restore(double[] state, int at) {
      int n = positions.length;
      System.arraycopy(state, at, positions, 0, n);
      System.arraycopy(state, at + n, rates, 0, n);
      time = state[at + 2 * n];
      timeBefore = state[at + 2 * n + 1];
      speed = state[at + 2 * n + 2];
      orientation = (int) state[at + 2 * n + 3];
    }
  }

  /** End of the positions that can be followed. */
  private static final class Obstacle {
    final LoopContinuation.End end;
    final double time;
    final double[] positions;

    Obstacle(LoopContinuation.End end, double time, double[] positions) {
      this.end = end;
      this.time = time;
      this.positions = positions.clone();
    }
  }

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
    continuation = new LoopContinuation(new DependentPositions());
    reached = new Reached(nq);
    beforeEvent = new Reached(nq);
    given = new double[nq];
    followed = new double[nq];
    rates = new double[nq];
    state = new double[work.stateCount];
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

  /** Gives dependent positions and velocities the size of the largest, in their units. */
  void enlarge(double[] sizes) {
    double farthest = 0;
    for (int i = 0; i < nq; i++) {
      farthest = Math.max(farthest, sizes[i] / units.positions[i]);
    }
    double fastest = units.speed(sizes, nq);
    for (int i : ofPositions.dependent) {
      sizes[i] = farthest * units.positions[i];
    }
    for (int j : ofVelocities.dependent) {
      sizes[nq + j] = fastest * units.velocities[j];
    }
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
    boolean positionsChosen = ofPositions.choose(positions.matrix);
    boolean velocitiesChosen = ofVelocities.choose(loops.jacobian);
    reached.time = t;
    remember(t, y, positionsChosen);
    return watch.begin(t) && positionsChosen && velocitiesChosen;
  }

  private void differentiate(double[] y) {
    positions.evaluate(y);
    positions.differentiate(y);
  }

  /** Overwrites dependent positions and velocities; returns false if there is no solution. */
  boolean complete(double t, double[] y) {
    obstacle = Optional.empty();
    boolean done = !watch.stallsAtSingularity() && find(t, y);
    watch.tried(done);
    return done;
  }

  private boolean find(double t, double[] y) {
    Reached from = reachedBefore(t);
    System.arraycopy(y, 0, given, 0, nq);
    boolean solved = completePositions(t, y);
    orientation = ofPositions.orientation();
    if (solved && isNear(given, y, NEAR)) {
      if (!completeVelocities(t, y)) {
        return false;
      }
      if (continuesPlainly(from, t, y)) {
        return true;
      }
    }
    System.arraycopy(given, 0, followed, 0, nq);
    LoopContinuation.End end =
        continuation.follow(from.time, from.positions, from.rates, from.orientation, t, followed);
    if (end != LoopContinuation.End.REACHED) {
      double time = from.time + continuation.reached() * (t - from.time);
      obstacle = Optional.of(new Obstacle(end, time, continuation.positions()));
      return false;
    }
    orientation = continuation.orientation();
    boolean same = solved && isNear(followed, y, SAME);
    if (!same && !from.hasPassed(t)) {
      return false;
    }
    if (!same) {
      System.arraycopy(followed, 0, y, 0, nq);
    }
    return completePositions(t, y) && completeVelocities(t, y);
  }

  /**
   * Returns whether a completed state continues the last accepted one without a doubt: the same
   * sign of the determinant, velocities as predicted, and positions q = q₀ + (t − t₀)(q₀' + q')/2.
   */
  private boolean continuesPlainly(Reached from, double t, double[] y) {
    double speed = Math.max(from.speed, units.speed(y, nq));
    if (orientation != from.orientation
        || !(velocityChange <= Math.max(AT_REST, OTHER_BRANCH * speed))) {
      return false;
    }
    work.coordinates.rates(y, 0, y, nq, rates, 0);
    double half = 0.5 * (t - from.time);
    for (int i = 0; i < nq; i++) {
      double expected = from.positions[i] + half * (from.rates[i] + rates[i]);
      if (!(Math.abs(y[i] - expected) <= NEAR * units.positions[i])) {
        return false;
      }
    }
    return true;
  }

  private boolean isNear(double[] q, double[] others, double distance) {
    for (int i = 0; i < nq; i++) {
      if (!(Math.abs(q[i] - others[i]) <= distance * units.positions[i])) {
        return false;
      }
    }
    return true;
  }

  /** Returns the state to begin from: rows before an event are asked for after it. */
  private Reached reachedBefore(double t) {
    boolean before =
        changedByEvent
            && t != reached.time
            && (t - beforeEvent.timeBefore) * (t - reached.time) <= 0;
    return before ? beforeEvent : reached;
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
   * Returns the reason why the motion cannot continue from the last accepted state: an end of the
   * positions that can be followed, a singular position, or a failed completion of the last
   * attempted state.
   *
   * @param names of the positions
   */
  Optional<Defect> obstacle(IntFunction<String> names) {
    return obstacle.or(this::ahead).map(where -> defect(where, names)).or(watch::obstacle);
  }

  /**
   * Returns where assemblies meet shortly after the last accepted state, if that is near a singular
   * position and drives alone move the mechanism.
   */
  private Optional<Obstacle> ahead() {
    if (!watch.isNearSingular() || ofPositions.freedom() > 0) {
      return Optional.empty();
    }
    double longest = AHEAD * Math.max(1, Math.abs(reached.time));
    for (double ahead = Math.ulp(reached.time); ahead < longest; ahead *= 2) {
      double t = reached.time + Math.copySign(ahead, reached.time - reached.timeBefore);
      System.arraycopy(reached.positions, 0, followed, 0, nq);
      LoopContinuation.End end =
          continuation.follow(
              reached.time, reached.positions, reached.rates, reached.orientation, t, followed);
      if (end != LoopContinuation.End.REACHED) {
        return Optional.of(new Obstacle(end, t, continuation.positions()));
      }
    }
    return Optional.empty();
  }

  /** Names the equations and the coordinates of the loops that meet another assembly. */
  private Defect defect(Obstacle where, IntFunction<String> names) {
    System.arraycopy(where.positions, 0, state, 0, nq);
    work.placeLoops(where.time, state);
    differentiate(state);
    double[] direction = new double[ofPositions.rank()];
    if (ofPositions.factor(positions.matrix)) {
      Arrays.fill(direction, 1);
      ofPositions.solve(direction);
    }
    for (int i = 0; i < direction.length; i++) {
      direction[i] /= units.positions[ofPositions.dependent[i]];
    }
    double largest = Arrays.stream(direction).map(Math::abs).max().orElse(0);
    List<LoopDefect.Way> ways = new ArrayList<>();
    for (int i = 0; i < direction.length; i++) {
      if (Math.abs(direction[i]) > PART_OF_WAY * largest) {
        int position = ofPositions.dependent[i];
        ways.add(
            new LoopDefect.Way(names.apply(position), where.positions[position], direction[i] > 0));
      }
    }
    boolean crossing = where.end == LoopContinuation.End.CHANGE_POINT;
    return LoopDefect.assembliesMeet(loops.name(watch.weakestRow()), where.time, ways, crossing);
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
      if (size <= LoopContinuation.CONVERGED) {
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
    velocityChange = 0;
    for (int i = 0; i < velocityCorrection.length; i++) {
      int j = ofVelocities.dependent[i];
      y[nq + j] -= velocityCorrection[i];
      velocityChange =
          larger(velocityChange, Math.abs(velocityCorrection[i]) / units.velocities[j]);
    }
    return velocityChange < Double.POSITIVE_INFINITY;
  }

  /** Stores the state that the next ones continue; the positions must be differentiated there. */
  private void remember(double t, double[] y, boolean otherChoice) {
    reached.timeBefore = reached.time;
    reached.time = t;
    reached.speed = units.speed(y, nq);
    System.arraycopy(y, 0, reached.positions, 0, nq);
    work.coordinates.rates(y, 0, y, nq, reached.rates, 0);
    if (otherChoice && ofPositions.factor(positions.matrix)) {
      orientation = ofPositions.orientation();
    }
    reached.orientation = orientation;
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
        + reached.stateLength()
        + watch.stateLength();
  }

  /** Writes the choice of coordinates and the values that the next states are compared with. */
  void save(double[] state, int at) {
    int next = at;
    ofPositions.save(state, next);
    next += ofPositions.stateLength();
    ofVelocities.save(state, next);
    next += ofVelocities.stateLength();
    reached.save(state, next);
    next += reached.stateLength();
    watch.save(state, next);
  }

  /** Restores what {@link #save} wrote. */
  void restore(double[] state, int at) {
    int next = at;
    ofPositions.restore(state, next);
    next += ofPositions.stateLength();
    ofVelocities.restore(state, next);
    next += ofVelocities.stateLength();
    reached.restore(state, next);
    changedByEvent = false;
    next += reached.stateLength();
    watch.restore(state, next);
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
    changedByEvent = false;
    boolean other = ofPositions.renew(positions.matrix, BETTER);
    remember(t, y, other);
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
    if (closed) {
      Reached before = changedByEvent ? beforeEvent : reached;
      reached = changedByEvent ? reached : beforeEvent;
      beforeEvent = before;
      changedByEvent = true;
      reached.time = t;
      remember(t, y, true);
    }
    ofVelocities.chooseBetter(loops.jacobian, Double.POSITIVE_INFINITY);
    watch.jumped(t, closed);
  }

  /** The equations of the dependent positions along a path of the independent ones. */
  private final class DependentPositions implements LoopContinuation.Equations {
    @Override
    public int positionCount() {
      return nq;
    }

    @Override
    public boolean isGiven(int position) {
      return ofPositions.isIndependent(position);
    }

    @Override
    public double unit(int position) {
      return units.positions[position];
    }

    @Override
    public double correct(double t, double[] q) {
      System.arraycopy(q, 0, state, 0, nq);
      work.placeLoops(t, state);
      differentiate(state);
      if (!ofPositions.factor(positions.matrix)) {
        return Double.NaN;
      }
      double change = Completion.this.correct(state);
      System.arraycopy(state, 0, q, 0, nq);
      return change;
    }

    @Override
    public int orientation() {
      return ofPositions.orientation();
    }

    /**
     * {@inheritDoc} With B of the positions last corrected, w = B⁻ᵀ z is the combination of
     * equations that no correction changes in the change point, up to the distance from it: the
     * smallest pivot is about that distance. So w·Φ is the misfit there, and Σ |w| δΦ its rounding.
     */
    @Override
    public boolean crosses(double t, double[] q) {
      if (ofPositions.freedom() == 0) {
        return false;
      }
      for (int k = 0; k < correction.length; k++) {
        // no right null vector of a symmetric mechanism is orthogonal to it
        correction[k] = units.positions[ofPositions.dependent[k]] * (0.5 + (k + 1) * GOLDEN % 1);
      }
      ofPositions.solveTransposed(correction);
      System.arraycopy(q, 0, state, 0, nq);
      work.placeLoops(t, state);
      differentiate(state);
      double misfit = 0;
      double ofRounding = 0;
      for (int k = 0; k < correction.length; k++) {
        int row = ofPositions.kept[k];
        misfit += correction[k] * positions.value[row];
        ofRounding += Math.abs(correction[k]) * positions.rounding(row, rounding, state);
      }
      return Math.abs(misfit) <= ofRounding;
    }
  }
}
