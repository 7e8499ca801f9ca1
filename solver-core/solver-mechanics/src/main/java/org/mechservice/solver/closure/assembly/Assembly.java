package org.mechservice.solver.closure.assembly;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.function.Predicate;
import org.mechservice.solver.closure.equations.CoordinateUnits;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.closure.equations.LoopRounding;
import org.mechservice.solver.kinematics.StateCoordinates;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.linear.Interruption;
import org.mechservice.solver.linear.SparseMatrix;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.joint.StartRole;

/**
 * Closes the loops at the start: positions by damped Gauss-Newton iteration, weighted by how far
 * each joint may move, and velocities by the least change (NUMERICS §3). A state that satisfies the
 * loops is not changed in any bit. Runs once at set-up and allocates memory.
 */
public final class Assembly {
  /** Relative residual beyond rounding below which a state is not changed. */
  private static final double CLOSED = 1e-13;

  /** Relative residual above which a correction is reported as a warning. */
  private static final double NOTEWORTHY = 1e-9;

  private static final int ITERATIONS = 60;

  /** Longest move of a coordinate in one iteration, rad or lengths of the mechanism. */
  private static final double LONGEST_STEP = 0.4;

  /** Sizes of random moves of the start with which a failed iteration is tried again. */
  private static final double[] KICKS = {0, 0.01, 0.1, 0.3, 0.6};

  /** Weight of a joint with a given start value; a free joint has weight 1. */
  private static final double RELUCTANCE = 1e-3;

  private final TreeMotion motion;
  private final LoopEquations loops;
  private final StateCoordinates coordinates;
  private final LoopRounding rounding;
  private final CoordinateUnits units;
  private final StartRole[] positionRoles;
  private final StartRole[] velocityRoles;

  /** Those of what is being assembled: positions or velocities. */
  private StartRole[] role;

  private final LeastMoves least;

  /** J, rows divided by their sizes and columns multiplied by their weights. */
  private final SparseMatrix matrix;

  private final double[] right;
  private final double[] step;
  private final int nq;
  private final int nv;

  /** Prepares the assembly of a tree's mechanism. */
  public Assembly(TreeGeometry tree) {
    this(tree, LoopEquations::isLargeToSetUp);
  }

  /**
   * As above, with matrices chosen by the caller.
   *
   * @param isLarge whether equations are solved with sparse matrices
   */
  public Assembly(TreeGeometry tree, Predicate<LoopEquations> isLarge) {
    motion = new TreeMotion(tree);
    loops = new LoopEquations(tree, true);
    Mechanism mechanism = tree.mechanism();
    coordinates = new StateCoordinates(mechanism);
    rounding = new LoopRounding(tree, loops, coordinates);
    units = new CoordinateUnits(mechanism, loops.length());
    nq = mechanism.positionCount();
    nv = mechanism.velocityCount();
    positionRoles = new StartRole[nv];
    velocityRoles = new StartRole[nv];
    role = positionRoles;
    for (int j = 0; j < mechanism.joints().size(); j++) {
      if (!mechanism.isDriven(j)) {
        int at = mechanism.velocityOffset(j);
        int count = mechanism.joints().get(j).type().velocityCount();
        StartRole given = mechanism.startRoles().get(j);
        Arrays.fill(positionRoles, at, at + count, given.ofPositions());
        Arrays.fill(velocityRoles, at, at + count, given.ofVelocities());
      }
    }
    matrix = loops.jacobian.sameShape();
    least =
        isLarge.test(loops)
            ? new SparseLeastMoves(matrix, nv)
            : new DenseLeastMoves(loops.count(), nv);
    right = new double[loops.count()];
    step = new double[nv];
  }

  /**
   * Closes the loops.
   *
   * @param t time of the start, s
   * @param y state [q; v]; overwritten where it does not obey the loops
   * @return findings: corrections, or the reason of a failure; empty if nothing was changed
   */
  public List<LoopFinding> assemble(double t, double[] y) {
    List<LoopFinding> findings = new ArrayList<>();
    assemblePositions(t, y, findings);
    if (findings.stream().allMatch(finding -> finding.kind().isWarning())) {
      assembleVelocities(t, y, findings);
    }
    return findings;
  }

  private void assemblePositions(double t, double[] y, List<LoopFinding> findings) {
    double residual = residual(t, y);
    if (residual <= CLOSED) {
      return;
    }
    int worst = loops.worst(loops.value);
    LoopFinding moved =
        finding(LoopFinding.Kind.START_MOVED, worst, Math.abs(loops.value[worst]), t);
    if (closePositions(t, y)) {
      if (!(residual <= NOTEWORTHY)) {
        findings.add(moved);
      }
      return;
    }
    residual(t, y);
    worst = loops.worst(loops.value);
    double least = Math.abs(loops.value[worst]);
    findings.add(finding(LoopFinding.Kind.NOT_CLOSED, worst, least, t));
  }

  private double residual(double t, double[] y) {
    motion.sweep(t, y);
    loops.place(motion, t);
    loops.differentiate(motion);
    return rounding.excess(y);
  }

  /** Moves only free joints if that suffices, otherwise given ones too; then tries other starts. */
  private boolean closePositions(double t, double[] y) {
    role = positionRoles;
    double[] best = y.clone();
    double least = residual(t, y);
    for (double kick : KICKS) {
      for (StartRole reluctant : new StartRole[] {StartRole.FREE, StartRole.PREFERRED}) {
        double[] tried = y.clone();
        kick(tried, kick, reluctant);
        double reached = iterate(t, tried, reluctant);
        if (reached < least) {
          least = reached;
          best = tried;
        }
        if (least <= (reluctant == StartRole.FREE ? CLOSED : NOTEWORTHY)) {
          System.arraycopy(best, 0, y, 0, y.length);
          return true;
        }
      }
    }
    System.arraycopy(best, 0, y, 0, y.length);
    return false;
  }

  private void kick(double[] y, double size, StartRole last) {
    Random random = new Random(271828);
    double[] move = new double[nv];
    for (int j = 0; j < nv; j++) {
      move[j] = (2 * random.nextDouble() - 1) * weight(j, last);
    }
    coordinates.move(y, 0, move, 0, size);
  }

  /** Returns the weight of a velocity's coordinate; 0 if it must not move. */
  private double weight(int velocity, StartRole last) {
    if (role[velocity] == StartRole.FREE) {
      return units.velocities[velocity];
    }
    boolean moves = last == StartRole.PREFERRED && role[velocity] == StartRole.PREFERRED;
    return moves ? RELUCTANCE * units.velocities[velocity] : 0;
  }

  /** Iterates from a state; returns the final residual. */
  private double iterate(double t, double[] y, StartRole last) {
    double merit = merit(t, y);
    double damping = 0;
    for (int i = 0; i < ITERATIONS && rounding.excess(y) > CLOSED; i++) {
      Interruption.check();
      differentiate(last, true);
      double[] tried = y.clone();
      least.solve(damping, right, step);
      advance(tried, last);
      double reached = merit(t, tried);
      if (reached < merit) {
        boolean slow = reached > 0.5 * merit;
        merit = reached;
        damping = slow ? damping : damping / 10;
        damping = damping < 1e-14 ? 0 : damping;
        System.arraycopy(tried, 0, y, 0, y.length);
      } else {
        damping = Math.max(10 * damping, 1e-8);
        if (damping > 1e3) {
          break;
        }
        merit(t, y);
      }
    }
    return residual(t, y);
  }

  private double merit(double t, double[] y) {
    residual(t, y);
    double sum = 0;
    for (int row = 0; row < loops.count(); row++) {
      double part = loops.value[row] / loops.size(row);
      right[row] = -part;
      sum += part * part;
    }
    return Double.isNaN(sum) ? Double.POSITIVE_INFINITY : sum;
  }

  /**
   * Forms J with rows divided by their sizes and columns multiplied by their weights relative to
   * the largest.
   *
   * @param ofPositions whether positions are to change, which non-holonomic equations do not
   *     restrict
   */
  private void differentiate(StartRole last, boolean ofPositions) {
    loops.differentiate(motion);
    double most = mostReady(last);
    for (int row = 0; row < loops.count(); row++) {
      for (int e = matrix.start[row]; e < matrix.start[row + 1]; e++) {
        int j = matrix.column[e];
        boolean counts = j < nv && (loops.isHolonomic(row) || !ofPositions);
        matrix.value[e] =
            counts ? loops.jacobian.value[e] * weight(j, last) / most / loops.size(row) : 0;
      }
    }
    least.take(matrix);
  }

  /** Returns the largest weight divided by its unit, so that moves are in units. */
  private double mostReady(StartRole last) {
    double most = 0;
    for (int j = 0; j < nv; j++) {
      most = Math.max(most, weight(j, last) / units.velocities[j]);
    }
    return most > 0 ? most : 1;
  }

  private void advance(double[] y, StartRole last) {
    double most = mostReady(last);
    double longest = 0;
    for (int j = 0; j < nv; j++) {
      double scale = weight(j, last) / most;
      longest = Math.max(longest, Math.abs(step[j]) * scale / units.velocities[j]);
      step[j] *= scale;
    }
    coordinates.move(y, 0, step, 0, longest > LONGEST_STEP ? LONGEST_STEP / longest : 1);
  }

  private void assembleVelocities(double t, double[] y, List<LoopFinding> findings) {
    double speed = Math.max(units.speed(y, nq), rateResidual(t, y));
    double residual = rateResidual(t, y);
    if (!(residual > CLOSED * speed)) {
      return;
    }
    int worst = loops.worst(loops.rate);
    LoopFinding changed =
        finding(LoopFinding.Kind.START_VELOCITY_CHANGED, worst, residual * loops.size(worst), t);
    double[] before = y.clone();
    role = velocityRoles;
    for (StartRole last : new StartRole[] {StartRole.FREE, StartRole.PREFERRED}) {
      System.arraycopy(before, 0, y, 0, y.length);
      if (fitVelocities(t, y, last) <= NOTEWORTHY * speed) {
        // velocities that nobody gave are chosen, not corrected
        if (last == StartRole.PREFERRED && residual > NOTEWORTHY * speed) {
          findings.add(changed);
        }
        return;
      }
    }
    double least = rateResidual(t, y);
    worst = loops.worst(loops.rate);
    findings.add(finding(LoopFinding.Kind.NO_VELOCITIES, worst, least * loops.size(worst), t));
  }

  private double rateResidual(double t, double[] y) {
    motion.sweep(t, y);
    loops.place(motion, t);
    loops.move(motion, t);
    int worst = loops.worst(loops.rate);
    return worst < 0 ? 0 : Math.abs(loops.rate[worst]) / loops.size(worst);
  }

  /**
   * Applies the least weighted change to the velocities; the second pass removes the rounding
   * errors of the first.
   */
  private double fitVelocities(double t, double[] y, StartRole last) {
    double reached = rateResidual(t, y);
    for (int pass = 0; pass < 2; pass++) {
      differentiate(last, false);
      for (int row = 0; row < loops.count(); row++) {
        right[row] = -loops.rate[row] / loops.size(row);
      }
      least.solve(0, right, step);
      double most = mostReady(last);
      for (int j = 0; j < nv; j++) {
        y[nq + j] += step[j] * weight(j, last) / most;
      }
      reached = rateResidual(t, y);
    }
    return reached;
  }

  private LoopFinding finding(LoopFinding.Kind kind, int row, double amount, double t) {
    boolean rates =
        kind == LoopFinding.Kind.START_VELOCITY_CHANGED || kind == LoopFinding.Kind.NO_VELOCITIES;
    return new LoopFinding(kind, loops.name(row), amount, loops.unit(row) + (rates ? "/s" : ""), t);
  }
}
