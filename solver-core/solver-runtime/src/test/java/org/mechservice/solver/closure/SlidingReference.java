package org.mechservice.solver.closure;

import java.util.Arrays;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.closure.JumpingLoops.Law;
import org.mechservice.solver.closure.JumpingLoops.Side;
import org.mechservice.solver.closure.model.ProjectionModel;

/**
 * The motion of a loop with one jump in the sense of Filippov 1988, §4: on either side as the
 * equations there say; where both lead back to the jump, along it, by the mean of both that stays
 * on it. In steps of the classical Runge-Kutta method, of which one that changes sides ends where
 * it does, found by halving.
 */
final class SlidingReference implements ExactMotion {
  private static final double STEP = 1e-3;
  private static final int HALVINGS = 45;
  private static final double ON_THE_JUMP = 1e-9;
  private static final double[] PLACES = {0, 0.5, 0.5, 1};
  private static final double[] WEIGHTS = {1, 2, 2, 1};

  private final JumpingLoops scene;
  private final ProjectionModel[] sides;
  private final double[][] slopes;
  private final int n;

  /** −1 before the jump, 1 behind it, 0 on it. */
  private int mode;

  /** Part of the slope behind the jump in that along it. */
  private double share;

  private double t;
  private double[] y;

  SlidingReference(JumpingLoops scene, RunSettings settings) {
    this.scene = scene;
    sides =
        new ProjectionModel[] {
          (ProjectionModel) LoopModels.of(scene.mechanism(Side.BEFORE), "DSR", settings),
          (ProjectionModel) LoopModels.of(scene.mechanism(Side.BEHIND), "DSR", settings)
        };
    n = sides[0].description().stateCount();
    slopes = new double[2][n];
    y = new double[n];
  }

  @Override
  public double[] after(double start, double[] state, double end) {
    t = start;
    y = state.clone();
    complete(t, y);
    double behind = scene.behind(t, y);
    mode = Math.abs(behind) > ON_THE_JUMP ? sign(behind) : leadingFrom(1);
    advance(end);
    return y.clone();
  }

  private static int sign(double x) {
    return x > 0 ? 1 : -1;
  }

  /** Returns the side to which a jump reached leads on. */
  private int leadingFrom(int side) {
    if (scene.law() == Law.BANG_BANG) {
      return -side;
    }
    evaluate(t, y);
    double before = scene.velocity(slopes[0]);
    double behind = scene.velocity(slopes[1]);
    return before > 0 && behind < 0 ? 0 : sign(before);
  }

  private void evaluate(double time, double[] state) {
    complete(time, state);
    for (int side = 0; side < 2; side++) {
      require(sides[side].derivative(time, state, slopes[side]) == ExplicitModel.REGULAR);
    }
  }

  private void complete(double time, double[] state) {
    for (ProjectionModel side : sides) {
      require(side.complete(time, state));
    }
  }

  private static void require(boolean regular) {
    if (!regular) {
      throw new IllegalStateException("the loop comes to a place where it is not regular");
    }
  }

  private double[] slope(double time, double[] state) {
    evaluate(time, state);
    if (mode != 0) {
      return slopes[mode > 0 ? 1 : 0].clone();
    }
    double before = scene.velocity(slopes[0]);
    share = before / (before - scene.velocity(slopes[1]));
    double[] mean = new double[n];
    for (int i = 0; i < n; i++) {
      mean[i] = slopes[0][i] + share * (slopes[1][i] - slopes[0][i]);
    }
    return mean;
  }

  private double[] stepped(double h) {
    double[] next = y.clone();
    double[] slope = new double[n];
    for (int stage = 0; stage < PLACES.length; stage++) {
      double[] at = new double[n];
      for (int i = 0; i < n; i++) {
        at[i] = y[i] + PLACES[stage] * h * slope[i];
      }
      slope = slope(t + PLACES[stage] * h, at);
      for (int i = 0; i < n; i++) {
        next[i] += h / 6 * WEIGHTS[stage] * slope[i];
      }
    }
    complete(t + h, next);
    return next;
  }

  private boolean leaves(double time, double[] next) {
    if (mode != 0) {
      return mode * scene.behind(time, next) < 0;
    }
    slope(time, next.clone());
    return share < 0 || share > 1;
  }

  private void advance(double end) {
    while (t < end) {
      double h = Math.min(STEP, end - t);
      double[] next = stepped(h);
      if (leaves(t + h, next)) {
        changeSides(h);
      } else {
        move(h < end - t ? t + h : end, next);
      }
    }
  }

  private void changeSides(double h) {
    double stays = 0;
    double leaves = h;
    for (int i = 0; i < HALVINGS; i++) {
      double middle = (stays + leaves) / 2;
      if (leaves(t + middle, stepped(middle))) {
        leaves = middle;
      } else {
        stays = middle;
      }
    }
    double[] next = stepped(leaves);
    slope(t + leaves, next.clone());
    int loose = share > 1 ? 1 : -1;
    move(t + leaves, next);
    mode = mode == 0 ? loose : leadingFrom(mode);
  }

  private void move(double time, double[] next) {
    t = time;
    y = next;
    for (ProjectionModel side : sides) {
      side.accepted(t, Arrays.copyOf(y, n));
    }
  }
}
