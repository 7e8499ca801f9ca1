package org.mechservice.solver.ode.jumps;

import org.mechservice.solver.ode.step.RightHandSide;

/** Looks whether a right-hand side jumps a little ahead, or is steep only. */
final class JumpProbe {
  /** Halvings of a way after which its ends are neighbours in double precision. */
  private static final int HALVINGS = 60;

  /** What is left of a difference across a real jump. */
  private static final double LASTING = 0.1;

  /** How often the way ahead is doubled to meet what the solution slides along. */
  private static final int DOUBLINGS = 12;

  /** Change of a derivative, as a part of it, that is no smooth one's within so short a way. */
  private static final double MUCH = 0.1;

  private final RightHandSide equations;
  private final double t;
  private final double[] here;
  private final double[] slope;
  private final double[] between;
  private final double[] slopeBetween;

  /** 1, or 0 while time is held. */
  private double timeMoves = 1;

  /**
   * @param here the state at {@code t}; kept, not modified
   */
  JumpProbe(RightHandSide equations, double t, double[] here) {
    this.equations = equations;
    this.t = t;
    this.here = here;
    slope = new double[here.length];
    between = new double[here.length];
    slopeBetween = new double[here.length];
    equations.evaluateAlways(t, here, slope);
  }

  /**
   * Returns whether the right-hand side jumps with the state alone, at the time as it is, on the
   * tangent ahead.
   *
   * @param step of which on the way ahead is looked at
   */
  boolean foundInState(double step) {
    timeMoves = 0;
    boolean found = lookAhead(step) == Finding.JUMP;
    timeMoves = 1;
    return found;
  }

  /**
   * Returns whether the right-hand side jumps where the solution slides, unless it is proved to be
   * steep only: along the tangent ahead derivatives change much within a short way, and by halving
   * that way until no number lies between, their changes get smaller. Of a real jump an implicit
   * method could make a slope that is not there.
   *
   * @param step of which on the way ahead is looked at
   */
  boolean found(double step) {
    return lookAhead(step) != Finding.STEEP;
  }

  private enum Finding {
    NOTHING,
    STEEP,
    JUMP
  }

  private Finding lookAhead(double step) {
    double[] slopeAhead = new double[here.length];
    boolean[] looked = new boolean[here.length];
    boolean steep = false;
    double h = step;
    for (int i = 0; i < DOUBLINGS; i++, h *= 2) {
      evaluate(h, slopeAhead);
      for (int l = 0; l < here.length; l++) {
        double size = Math.max(Math.abs(slope[l]), Math.abs(slopeAhead[l]));
        if (!looked[l] && Math.abs(slopeAhead[l] - slope[l]) > MUCH * size) {
          looked[l] = true;
          steep = true;
          if (changeLasts(l, h, slopeAhead[l])) {
            return Finding.JUMP;
          }
        }
      }
    }
    return steep ? Finding.STEEP : Finding.NOTHING;
  }

  /** Returns whether a derivative still changes as much when its ends are neighbours. */
  private boolean changeLasts(int l, double h, double slopeAhead) {
    double from = 0;
    double to = h;
    double before = slope[l];
    double behind = slopeAhead;
    for (int i = 0; i < HALVINGS; i++) {
      double middle = 0.5 * (from + to);
      evaluate(middle, slopeBetween);
      if (Math.abs(slopeBetween[l] - before) < Math.abs(slopeBetween[l] - behind)) {
        from = middle;
        before = slopeBetween[l];
      } else {
        to = middle;
        behind = slopeBetween[l];
      }
    }
    return !(Math.abs(behind - before) < LASTING * Math.abs(slopeAhead - slope[l]));
  }

  /** Evaluates the right-hand side a way ahead along the tangent. */
  private void evaluate(double way, double[] derivative) {
    for (int l = 0; l < here.length; l++) {
      between[l] = here[l] + way * slope[l];
    }
    equations.evaluateAlways(t + timeMoves * way, between, derivative);
  }
}
