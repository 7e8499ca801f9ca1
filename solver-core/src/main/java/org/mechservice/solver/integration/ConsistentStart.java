package org.mechservice.solver.integration;

/**
 * Finds y'_d and y_a with F(t0, y0, y'0) = 0, the differential part y_d being given, by a damped
 * Newton iteration.
 *
 * <p>What y'_d is wrong by enters the integration with the first step; so a change of it counts by
 * what it would move y over a first step, h y'_d, in units of the error allowed. Values that are
 * right to a small part of that are left as they are. A step of the iteration is shortened until
 * the next one, with the same matrix, would be smaller. Brown, Hindmarsh and Petzold 1998.
 */
final class ConsistentStart {
  private static final int ITERATIONS = 20;

  /** Part of the error allowed by which the values may be wrong. */
  private static final double ACCURACY = 0.01;

  private static final double SHORTEST_PART = 1e-3;

  /** Share of a reduction promised by the linear equations that is asked for. */
  private static final double SUFFICIENT = 0.25;

  /**
   * Factor of the short step for which a singular matrix is replaced, if that does not converge.
   */
  private static final double SHORTER = 1e-2;

  private static final double SHORT_STEP = 0.1;
  private static final double LARGEST_SHARE_OF_INTERVAL = 1e-3;

  private final ResidualEquations equations;
  private final ErrorNorm norm;
  private final double relativeTolerance;
  private final double[] tolerances;
  private final double t0;
  private final double interval;

  /** State and slope under way, the change of y_a and y'_d, and the same a trial step further. */
  private final double[] y;

  private final double[] yDot;
  private final double[] change;
  private final double[] triedState;
  private final double[] triedSlope;
  private final double[] triedChange;

  /** A first step, and the short one for which a singular matrix is replaced. */
  private double firstStep;

  private double shortStep;

  /**
   * @param norm weighed at the start
   * @param y state at the start; its algebraic part is overwritten
   * @param yDot guess of its derivative; its differential part is overwritten, the algebraic one
   *     set to zero
   * @param interval length of the problem, signed
   */
  ConsistentStart(
      ResidualEquations equations,
      ErrorNorm norm,
      IntegratorSettings settings,
      double t0,
      double[] y,
      double[] yDot,
      double interval) {
    int n = y.length;
    this.equations = equations;
    this.norm = norm;
    relativeTolerance = settings.relativeTolerance();
    tolerances = settings.absoluteTolerances(n);
    this.t0 = t0;
    this.interval = interval;
    this.y = y;
    this.yDot = yDot;
    change = new double[n];
    triedState = new double[n];
    triedSlope = new double[n];
    triedChange = new double[n];
  }

  /** Iterates to the end; what it has reached stands in the arrays given. */
  Attempt find() {
    measure();
    shortStep = SHORT_STEP * firstStep;
    for (int i = 0; i < ITERATIONS; i++) {
      Attempt attempt = linearise();
      if (attempt == Attempt.PASSED) {
        attempt = changeAt(y, yDot, change);
      }
      if (attempt != Attempt.PASSED) {
        return attempt;
      }
      double size = size(change);
      if (size <= ACCURACY) {
        return i == 0 ? settle(0) : settle(1);
      }
      attempt = damped(size);
      if (attempt == Attempt.NOT_CONVERGING && equations.startsApproximately()) {
        shortStep *= SHORTER;
      } else if (attempt != Attempt.PASSED) {
        return attempt;
      }
    }
    return Attempt.NOT_CONVERGING;
  }

  /** Finds the length of a first step that the slope would allow. */
  private void measure() {
    double longest = LARGEST_SHARE_OF_INTERVAL * interval;
    firstStep = FirstStep.bySlope(yDot, norm, longest, relativeTolerance);
    equations.linearisation().knowStep(firstStep);
  }

  private Attempt linearise() {
    equations.demandNew();
    Attempt attempt = equations.linearise(t0, y);
    if (attempt != Attempt.PASSED) {
      return attempt;
    }
    boolean regular = equations.factorForStart(Math.copySign(shortStep, interval));
    return regular ? Attempt.PASSED : Attempt.SINGULAR_MATRIX;
  }

  private Attempt changeAt(double[] state, double[] slope, double[] target) {
    if (!equations.residual().evaluateCompleted(t0, state, slope, target)) {
      return Attempt.STOPPED;
    }
    for (int l = 0; l < target.length; l++) {
      target[l] = -target[l];
    }
    if (RightHandSide.firstNotFinite(target) >= 0) {
      return Attempt.NOT_FINITE;
    }
    equations.solveForStart(target);
    return Attempt.PASSED;
  }

  /** Goes along the change as far as it makes the next one smaller. */
  private Attempt damped(double size) {
    for (double part = 1; part >= SHORTEST_PART; part *= 0.5) {
      move(part);
      Attempt attempt = changeAt(triedState, triedSlope, triedChange);
      if (attempt == Attempt.STOPPED) {
        return attempt;
      }
      if (attempt == Attempt.PASSED && size(triedChange) <= (1 - SUFFICIENT * part) * size) {
        System.arraycopy(triedState, 0, y, 0, y.length);
        System.arraycopy(triedSlope, 0, yDot, 0, y.length);
        measure();
        return Attempt.PASSED;
      }
    }
    return Attempt.NOT_CONVERGING;
  }

  private void move(double part) {
    for (int l = 0; l < y.length; l++) {
      boolean algebraic = equations.linearisation().algebraic(l);
      triedState[l] = y[l] + (algebraic ? part * change[l] : 0);
      triedSlope[l] = yDot[l] + (algebraic ? 0 : part * change[l]);
    }
  }

  /** Takes the last change to a part; the passive components follow. */
  private Attempt settle(double part) {
    move(part);
    System.arraycopy(triedState, 0, y, 0, y.length);
    System.arraycopy(triedSlope, 0, yDot, 0, y.length);
    for (int l = 0; l < y.length; l++) {
      if (equations.linearisation().algebraic(l)) {
        yDot[l] = 0;
      }
    }
    return equations.manifold().complete(t0, y) ? Attempt.PASSED : Attempt.NOT_COMPLETED;
  }

  /** Returns the largest change in units of the error allowed. */
  private double size(double[] change) {
    double largest = 0;
    for (int l = 0; l < change.length; l++) {
      double moved = equations.linearisation().algebraic(l) ? change[l] : firstStep * change[l];
      double allowed = Math.max(relativeTolerance * Math.abs(y[l]), tolerances[l]);
      largest = Math.max(largest, Math.abs(moved) / allowed);
    }
    return largest;
  }

  /** Returns the row whose equation is violated most, by the size of its terms if that is known. */
  int worstRow() {
    equations.residual().evaluateAlways(t0, y, yDot, change);
    int notFinite = RightHandSide.firstNotFinite(change);
    if (notFinite >= 0) {
      return notFinite;
    }
    int worst = -1;
    double most = 0;
    for (int i = 0; i < change.length; i++) {
      double magnitude = equations.linearisation().magnitude(i);
      double violation = Math.abs(change[i]) / (magnitude > 0 ? magnitude : 1);
      if (violation > most) {
        most = violation;
        worst = i;
      }
    }
    return worst;
  }
}
