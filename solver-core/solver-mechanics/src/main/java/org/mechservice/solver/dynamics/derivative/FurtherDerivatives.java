package org.mechservice.solver.dynamics.derivative;

import java.util.Arrays;
import org.mechservice.solver.force.ForceSet;
import org.mechservice.solver.force.formula.FurtherRates;
import org.mechservice.solver.kinematics.StateCoordinates;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;

/**
 * Terms of further states s, s' = f(t, q, v, s), in the derivatives of the equations of motion: the
 * derivative of M v' + b − τ by s, and those of f by q (along the tangent), v and s. The
 * derivatives by s are analytic; those of f by q and v are central differences of two steps,
 * extrapolated, unless generated code has written them. Workspace of one thread.
 */
public final class FurtherDerivatives {
  private static final double STEP = 0x1p-16;

  private final int nq;
  private final int nv;
  private final int ns;

  /** ∂(M v' + b − τ)/∂s, nv × ns. */
  public final double[] forces;

  /** ∂f/∂q along the tangent, ns × nv. */
  public final double[] byPlace;

  /** ∂f/∂v, ns × nv. */
  public final double[] byVelocity;

  /** ∂f/∂s, ns × ns. */
  public final double[] byState;

  private final double[][] parts;
  private final double[] direction;
  private final double[] plus;
  private final double[] minus;
  private double[] moved = new double[0];

  /**
   * @param positions nq
   * @param velocities nv
   * @param states number of further states
   */
  public FurtherDerivatives(int positions, int velocities, int states) {
    nq = positions;
    nv = velocities;
    ns = states;
    forces = new double[nv * ns];
    byPlace = new double[ns * nv];
    byVelocity = new double[ns * nv];
    byState = new double[ns * ns];
    parts = new double[][] {forces, byPlace, byVelocity, byState};
    direction = new double[nv];
    plus = new double[ns];
    minus = new double[ns];
  }

  /** Returns the number of further states. */
  public int count() {
    return ns;
  }

  /** Returns how many numbers generated code writes for {@link #take}. */
  public static int numbers(int velocities, int states) {
    return states * (3 * velocities + states);
  }

  /**
   * Copies all four derivatives from generated code, in the order of the fields.
   *
   * @param values not modified
   */
  public void take(double[] values, int at) {
    int next = at;
    for (double[] part : parts) {
      System.arraycopy(values, next, part, 0, part.length);
      next += part.length;
    }
  }

  /** Returns whether all are finite. */
  public boolean isFinite() {
    double sum = 0;
    for (double[] part : parts) {
      for (double element : part) {
        sum += 0 * element;
      }
    }
    return sum == 0;
  }

  /**
   * Evaluates all four at a state. The motion is left at that state.
   *
   * @param motion swept here
   * @param applied the forces, applied at this state last
   * @param y state [q; v; s]; not modified
   */
  public void evaluate(
      TreeMotion motion,
      ForceSet applied,
      FurtherRates rates,
      StateCoordinates coordinates,
      double t,
      double[] y) {
    if (ns == 0) {
      return;
    }
    motion.sweep(t, y);
    ofForces(motion, applied);
    rates.evaluate(t, plus, 0);
    rates.byState(byState);
    if (moved.length != nq + nv + ns) {
      moved = new double[nq + nv + ns];
    }
    for (int j = 0; j < nv; j++) {
      double step = STEP * Math.max(1, Math.abs(y[nq + j]));
      differ(motion, rates, t, y, j, step, byVelocity, (h, at) -> moved[nq + at] += h);
      direction[j] = 1;
      differ(
          motion,
          rates,
          t,
          y,
          j,
          STEP,
          byPlace,
          (h, at) -> coordinates.move(moved, 0, direction, 0, h));
      direction[j] = 0;
    }
    motion.sweep(t, y);
    rates.evaluate(t, plus, 0);
  }

  /** Moves the state by a step in a direction. */
  private interface Move {
    void by(double step, int velocity);
  }

  private void differ(
      TreeMotion motion,
      FurtherRates rates,
      double t,
      double[] y,
      int column,
      double step,
      double[] into,
      Move move) {
    for (int pass = 0; pass < 2; pass++) {
      double h = pass == 0 ? step : step / 2;
      moved(motion, rates, t, y, h, column, move, plus);
      moved(motion, rates, t, y, -h, column, move, minus);
      for (int i = 0; i < ns; i++) {
        double slope = (plus[i] - minus[i]) / (2 * h);
        double coarse = into[i * nv + column];
        into[i * nv + column] = pass == 0 ? slope : slope + (slope - coarse) / 3;
      }
    }
  }

  private void moved(
      TreeMotion motion,
      FurtherRates rates,
      double t,
      double[] y,
      double h,
      int column,
      Move move,
      double[] values) {
    System.arraycopy(y, 0, moved, 0, moved.length);
    move.by(h, column);
    motion.sweep(t, moved);
    rates.evaluate(t, values, 0);
  }

  private void ofForces(TreeMotion motion, ForceSet applied) {
    TreeGeometry tree = motion.tree();
    double[] wrench = new double[6 * tree.linkCount];
    double[] tau = new double[tree.velocityCount];
    for (int k = 0; k < ns; k++) {
      Arrays.fill(wrench, 0);
      Arrays.fill(tau, 0);
      applied.addByState(k, wrench, tau);
      for (int link = 0; link < tree.linkCount; link++) {
        motion.wrenches.addRow(link, wrench, 6 * link, 1, tau);
      }
      for (int i = 0; i < nv; i++) {
        forces[i * ns + k] = -tau[i];
      }
    }
  }
}
