package org.mechservice.solver.closure.assembly;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Predicate;
import org.mechservice.solver.closure.equations.CoordinateUnits;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.closure.equations.LoopRounding;
import org.mechservice.solver.kinematics.StateCoordinates;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.linear.SparseMatrix;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.joint.StartRole;

/**
 * Closes the loops at the start: positions by the nearest ones that satisfy them, and velocities by
 * the least change (docs/theory/loops.md#assembly). Joints without given start values move first;
 * given ones move, as little as possible, only if these do not suffice. A state that satisfies the
 * loops is not changed in any bit. Runs once at set-up and allocates memory.
 *
 * <p>A residual counts as closed below the rounding errors of the mechanism ({@link LoopRounding}).
 * What no motion reduces is the misfit of redundant equations; it is accepted up to {@link
 * LoopRounding#MISFIT} of the size of the mechanism.
 */
public final class Assembly {
  /** Rate over the speed below which velocities are not changed. */
  private static final double FITTING = 1e-13;

  private final TreeMotion motion;
  private final LoopEquations loops;
  private final CoordinateUnits units;
  private final StartRole[] positionRoles;
  private final StartRole[] velocityRoles;

  private final LeastMoves least;
  private final NearestPositions nearest;

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
    units = new CoordinateUnits(mechanism, loops.length());
    nq = mechanism.positionCount();
    nv = mechanism.velocityCount();
    positionRoles = new StartRole[nv];
    velocityRoles = new StartRole[nv];
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
    least = LeastMoves.of(loops, nv, isLarge.test(loops));
    StateCoordinates coordinates = new StateCoordinates(mechanism);
    LoopRounding rounding = new LoopRounding(tree, loops, coordinates);
    nearest = new NearestPositions(motion, loops, coordinates, units, rounding, least);
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

  /**
   * Closes the loops near a state by the first positions found, whatever the roles of the joints.
   *
   * @param t s
   * @param y state [q; v]; its positions are overwritten
   */
  void closeNear(double t, double[] y) {
    nearest.close(t, y);
  }

  private void assemblePositions(double t, double[] y, List<LoopFinding> findings) {
    double residual = nearest.place(t, y);
    if (residual <= NearestPositions.CLOSED) {
      return;
    }
    int worst = loops.worst(loops.value);
    LoopFinding moved =
        finding(LoopFinding.Kind.START_MOVED, worst, Math.abs(loops.value[worst]), t);
    if (nearest.closeInTurn(t, y, willing(positionRoles, StartRole.PREFERRED))) {
      if (!(residual <= LoopRounding.MISFIT)) {
        findings.add(moved);
      }
      return;
    }
    nearest.place(t, y);
    worst = loops.worst(loops.value);
    double least = Math.abs(loops.value[worst]);
    findings.add(finding(LoopFinding.Kind.NOT_CLOSED, worst, least, t));
  }

  /** Returns how willingly coordinates move: 0 if they must not. */
  private static double[] willing(StartRole[] role, StartRole last) {
    double[] willing = new double[role.length];
    for (int j = 0; j < willing.length; j++) {
      boolean moves = last == StartRole.PREFERRED && role[j] == StartRole.PREFERRED;
      willing[j] = role[j] == StartRole.FREE ? 1 : moves ? NearestPositions.RELUCTANT : 0;
    }
    return willing;
  }

  private void assembleVelocities(double t, double[] y, List<LoopFinding> findings) {
    double speed = Math.max(units.speed(y, nq), rateResidual(t, y));
    double residual = rateResidual(t, y);
    if (!(residual > FITTING * speed)) {
      return;
    }
    int worst = loops.worst(loops.rate);
    LoopFinding changed =
        finding(LoopFinding.Kind.START_VELOCITY_CHANGED, worst, residual * loops.size(worst), t);
    double[] before = y.clone();
    for (StartRole last : new StartRole[] {StartRole.FREE, StartRole.PREFERRED}) {
      System.arraycopy(before, 0, y, 0, y.length);
      if (fitVelocities(t, y, last) <= LoopRounding.MISFIT * speed) {
        // velocities that nobody gave are chosen, not corrected
        if (last == StartRole.PREFERRED && residual > LoopRounding.MISFIT * speed) {
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
    double[] unit = willing(velocityRoles, last);
    double most = Arrays.stream(unit).max().orElse(0);
    for (int j = 0; j < nv; j++) {
      unit[j] *= most > 0 ? units.velocities[j] / most : 0;
    }
    double reached = rateResidual(t, y);
    for (int pass = 0; pass < 2; pass++) {
      loops.differentiate(motion);
      for (int row = 0; row < loops.count(); row++) {
        for (int e = matrix.start[row]; e < matrix.start[row + 1]; e++) {
          int j = matrix.column[e];
          matrix.value[e] = j < nv ? loops.jacobian.value[e] * unit[j] / loops.size(row) : 0;
        }
        right[row] = -loops.rate[row] / loops.size(row);
      }
      least.take(matrix);
      least.solve(0, right, step);
      for (int j = 0; j < nv; j++) {
        y[nq + j] += step[j] * unit[j];
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
