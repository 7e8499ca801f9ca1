package org.mechservice.solver.ode.newton;

import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.TrialOutcome;
import org.mechservice.solver.ode.step.ErrorNorm;
import org.mechservice.solver.ode.step.RightHandSide;

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

  /** Part of a first step by which passive components are looked at to find their derivative. */
  private static final double LOOK_AHEAD = 0x1p-10;

  private final ResidualEquations equations;
  private final ErrorNorm norm;
  private final double relativeTolerance;
  private final double[] tolerances;
  private final double tEnd;

  /** State and slope under way, the change of y_a and y'_d, and the same a trial step further. */
  private final double[] y;

  private final double[] yDot;
  private final double[] change;
  private final double[] triedState;
  private final double[] triedSlope;
  private final double[] triedChange;

  private double t0;

  /** A first step, and the short one for which a singular matrix is replaced. */
  private double firstStep;

  private double shortStep;

  /** Where the search stands: not begun, to be linearised, to be judged, or to be damped. */
  private Stage stage = Stage.BEGIN;

  private int iteration;

  /** Whether the guess of y' belongs to a state before a jump. */
  private boolean slopeIsOfAnother;

  private double size;
  private double part;

  /**
   * Whether values right to the error allowed were found with a longer short step, or, of a
   * restart, any; and these.
   */
  private boolean kept;

  private final double[] keptState;
  private final double[] keptSlope;

  private enum Stage {
    BEGIN,
    LINEARISE,
    JUDGE,
    DAMP
  }

  /**
   * @param norm by which the errors of the problem are judged
   * @param tEnd end of the problem
   */
  ConsistentStart(
      ResidualEquations equations, ErrorNorm norm, IntegratorSettings settings, double tEnd) {
    int n = equations.manifold().dimension();
    this.equations = equations;
    this.norm = norm;
    this.tEnd = tEnd;
    relativeTolerance = settings.relativeTolerance();
    tolerances = settings.absoluteTolerances(n);
    y = new double[n];
    yDot = new double[n];
    change = new double[n];
    triedState = new double[n];
    triedSlope = new double[n];
    triedChange = new double[n];
    keptState = new double[n];
    keptSlope = new double[n];
  }

  /**
   * Takes note that the state has been changed, so that the guess of its derivative is that of
   * another motion: a correction found is taken over even if it is small.
   */
  void stateChanged() {
    slopeIsOfAnother = true;
  }

  /** Forgets a search that was stopped. */
  void abandon() {
    stage = Stage.BEGIN;
  }

  /**
   * Searches to the end, or until stopped; the next call then goes on.
   *
   * @param y0 state at the start; completed, and its algebraic part overwritten
   * @param yDot0 guess of its derivative; overwritten, its algebraic part by zeros
   */
  TrialOutcome find(double t0, double[] y0, double[] yDot0) {
    if (stage == Stage.BEGIN && !begin(t0, y0, yDot0)) {
      return TrialOutcome.NOT_COMPLETED;
    }
    TrialOutcome attempt = search();
    if (attempt == TrialOutcome.STOPPED) {
      return attempt;
    }
    stage = Stage.BEGIN;
    slopeIsOfAnother = false;
    if (attempt == TrialOutcome.PASSED) {
      System.arraycopy(y, 0, y0, 0, y.length);
      System.arraycopy(yDot, 0, yDot0, 0, y.length);
    }
    return attempt;
  }

  private boolean begin(double t0, double[] y0, double[] yDot0) {
    this.t0 = t0;
    System.arraycopy(y0, 0, y, 0, y.length);
    System.arraycopy(yDot0, 0, yDot, 0, y.length);
    measure();
    shortStep = SHORT_STEP * firstStep;
    kept = false;
    iteration = 0;
    stage = Stage.LINEARISE;
    return equations.manifold().complete(t0, y);
  }

  private TrialOutcome search() {
    while (iteration < ITERATIONS) {
      TrialOutcome attempt =
          switch (stage) {
            case JUDGE -> judge();
            case DAMP -> damp();
            default -> linearise();
          };
      if (attempt != TrialOutcome.PASSED || stage == Stage.BEGIN) {
        return attempt;
      }
    }
    return end();
  }

  /**
   * Ends a search that gets no further. Multipliers of stiff forces have the rounding of these, so
   * that the accuracy sought may be out of reach; what is right to the error allowed is kept. Where
   * y_d misses its constraints by an error r, of rounding or of the steps before a restart, no y'
   * but r/h closes them, so that shorter steps ask for more and more: a restart then goes on with
   * the y' before, and the error test judges the steps.
   */
  private TrialOutcome end() {
    stage = Stage.BEGIN;
    if (size > 1 && kept) {
      System.arraycopy(keptState, 0, y, 0, y.length);
      System.arraycopy(keptSlope, 0, yDot, 0, y.length);
      return settle(0);
    }
    return size <= 1 ? settle(0) : TrialOutcome.NOT_CONVERGING;
  }

  /** Finds the length of a first step that the slope would allow. */
  private void measure() {
    // a problem of no length has no scale of its own, and asks for consistent values all the same
    double longest = LARGEST_SHARE_OF_INTERVAL * (tEnd == t0 ? 1 : tEnd - t0);
    firstStep = InitialStepSize.bySlope(yDot, norm, longest, relativeTolerance);
    equations.linearisation().knowRate(Math.sqrt(relativeTolerance) / firstStep);
  }

  private TrialOutcome linearise() {
    equations.place(yDot);
    equations.derivatives().demandNew();
    TrialOutcome attempt = equations.derivatives().form(t0, y, 0);
    if (attempt != TrialOutcome.PASSED) {
      return attempt;
    }
    stage = Stage.JUDGE;
    boolean regular = equations.factorForStart(Math.copySign(shortStep, tEnd - t0));
    return regular ? TrialOutcome.PASSED : TrialOutcome.SINGULAR_MATRIX;
  }

  /** Ends the search if the change is small, else begins to damp it. */
  private TrialOutcome judge() {
    TrialOutcome attempt = changeAt(y, yDot, change);
    if (attempt != TrialOutcome.PASSED) {
      return attempt;
    }
    size = size(change);
    if (size <= ACCURACY) {
      stage = Stage.BEGIN;
      return settle(iteration == 0 && !slopeIsOfAnother ? 0 : 1);
    }
    part = 1;
    stage = Stage.DAMP;
    return TrialOutcome.PASSED;
  }

  private TrialOutcome changeAt(double[] state, double[] slope, double[] target) {
    if (!equations.residual().evaluateCompleted(t0, state, slope, target)) {
      return TrialOutcome.STOPPED;
    }
    for (int l = 0; l < target.length; l++) {
      target[l] = -target[l];
    }
    if (RightHandSide.firstNotFinite(target) >= 0) {
      return TrialOutcome.NOT_FINITE;
    }
    equations.solveForStart(target);
    return TrialOutcome.PASSED;
  }

  /** Goes along the change as far as it makes the next one smaller. */
  private TrialOutcome damp() {
    for (; part >= SHORTEST_PART; part *= 0.5) {
      move(part);
      TrialOutcome attempt = changeAt(triedState, triedSlope, triedChange);
      if (attempt == TrialOutcome.STOPPED) {
        return attempt;
      }
      if (attempt == TrialOutcome.PASSED && size(triedChange) <= (1 - SUFFICIENT * part) * size) {
        takeOver();
        measure();
        return goOn();
      }
    }
    if (!equations.startsApproximately()) {
      return end();
    }
    if (size <= 1 || (slopeIsOfAnother && !kept)) {
      kept = true;
      System.arraycopy(y, 0, keptState, 0, y.length);
      System.arraycopy(yDot, 0, keptSlope, 0, y.length);
    }
    shortStep *= SHORTER;
    return goOn();
  }

  private TrialOutcome goOn() {
    iteration++;
    stage = Stage.LINEARISE;
    return TrialOutcome.PASSED;
  }

  private void takeOver() {
    System.arraycopy(triedState, 0, y, 0, y.length);
    System.arraycopy(triedSlope, 0, yDot, 0, y.length);
  }

  private void move(double part) {
    for (int l = 0; l < y.length; l++) {
      boolean algebraic = equations.linearisation().algebraic(l);
      triedState[l] = y[l] + (algebraic ? part * change[l] : 0);
      triedSlope[l] = yDot[l] + (algebraic ? 0 : part * change[l]);
    }
  }

  /** Takes the last change to a part; the passive components follow. */
  private TrialOutcome settle(double part) {
    move(part);
    takeOver();
    for (int l = 0; l < y.length; l++) {
      if (equations.linearisation().algebraic(l)) {
        yDot[l] = 0;
      }
    }
    if (!equations.manifold().complete(t0, y)) {
      return TrialOutcome.NOT_COMPLETED;
    }
    differencePassive();
    return TrialOutcome.PASSED;
  }

  /** Finds the derivatives of passive components by completing the state a little further on. */
  private void differencePassive() {
    double stretch = LOOK_AHEAD * Math.copySign(firstStep, tEnd - t0);
    if (!equations.manifold().completes() || stretch == 0) {
      return;
    }
    for (int l = 0; l < y.length; l++) {
      triedState[l] = y[l] + stretch * yDot[l];
    }
    if (!equations.manifold().complete(t0 + stretch, triedState)) {
      return;
    }
    for (int l = 0; l < y.length; l++) {
      if (!equations.manifold().independent(l)) {
        yDot[l] = (triedState[l] - y[l]) / stretch;
      }
    }
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

  /** Carries over what a search to come is to know. */
  void transfer(SavedState state) {
    slopeIsOfAnother = state.flag(slopeIsOfAnother);
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
