package org.mechservice.solver.ode.suite;

import org.mechservice.solver.ode.CompletedSystem;
import org.mechservice.solver.ode.OdeSystem;
import org.mechservice.solver.ode.SavedState;

/**
 * A point mass on a rod of length 1 in Cartesian coordinates, y = [x, y, x', y'], released at (1,
 * 0) with g = 9.81 (suite: pend_i1). As a closed loop would, it takes the coordinate that moves
 * faster as the independent one and finds the other from x² + y² = 1 and x x' + y y' = 0.
 */
public class LoopPendulum implements OdeSystem, CompletedSystem {
  private static final double[] START = {1, 0, 0, 0};

  private static final double[] AT_TEN = {
    0.2750874625761168, -0.9614192050991250, -4.175598101950732, -1.1947490545604753
  };

  private static final double GRAVITY = 9.81;

  /** The other coordinate is chosen when it moves this much faster than the present one. */
  private static final double HYSTERESIS = 2;

  private int independent = 1;
  private int changes;

  /** Returns how often the independent coordinate has changed. */
  public int changes() {
    return changes;
  }

  /** Carries the choice of the independent coordinate over. */
  public final void transferChoice(SavedState state) {
    independent = state.integer(independent);
    changes = state.integer(changes);
  }

  @Override
  public int dimension() {
    return 4;
  }

  @Override
  public void derivative(double t, double[] y, double[] yDot) {
    double tension = (y[2] * y[2] + y[3] * y[3] - GRAVITY * y[1]) / (y[0] * y[0] + y[1] * y[1]);
    yDot[0] = y[2];
    yDot[1] = y[3];
    yDot[2] = -tension * y[0];
    yDot[3] = -tension * y[1] - GRAVITY;
  }

  @Override
  public boolean independent(int component) {
    return component % 2 == independent;
  }

  @Override
  public boolean complete(double t, double[] y) {
    int passive = 1 - independent;
    double square = 1 - y[independent] * y[independent];
    if (!(square > 0)) {
      return false;
    }
    y[passive] = Math.copySign(Math.sqrt(square), y[passive]);
    y[2 + passive] = -y[independent] * y[2 + independent] / y[passive];
    return true;
  }

  @Override
  public boolean accepted(double t, double[] y) {
    int other = 1 - independent;
    // The coordinate whose direction is nearer to the circle's tangent: the other's lever is
    // larger.
    if (Math.abs(y[independent]) <= HYSTERESIS * Math.abs(y[other])) {
      return false;
    }
    independent = other;
    changes++;
    return true;
  }

  /** Returns the state at t = 0: x, y and their derivatives. */
  public static double[] start() {
    return START.clone();
  }

  /** Returns the state at t = 10, from elliptic functions. */
  public static double[] atTen() {
    return AT_TEN.clone();
  }
}
