package org.mechservice.solver.integration;

import java.util.Optional;
import org.mechservice.solver.integration.IntegrationFailure.Cause;

/**
 * Adams methods of variable order and step in PECE form: predict, evaluate, correct, evaluate. The
 * two programs built on it differ in norm, bounds and start.
 *
 * <p>One step is told by {@link #step}: it tries a step of size h with the predictor of order k
 * until the error test passes and all values are finite, accepts it, and chooses k and h anew.
 */
abstract class AdamsPece implements Integrator {
  /** Tries in a row with values that are not finite before the integrator gives up. */
  private static final int NOT_FINITE_TRIES = 10;

  /** Share of the interval that the first step may cover: a start at rest says nothing about f. */
  private static final double FIRST_SHARE_OF_INTERVAL = 0.1;

  private static final int ALL_FINITE = -1;
  private static final double UNIT_ROUNDOFF = Math.ulp(1.0);

  /** What a try of a step came to. */
  private enum Attempt {
    PASSED,
    TOO_INACCURATE,
    NOT_FINITE,
    STOPPED
  }

  private final IntegratorSettings settings;
  private final ErrorNorm norm;
  private final StepBounds bounds;
  private final AdamsCoefficients coefficients = new AdamsCoefficients();
  private final AdamsOrderControl control = new AdamsOrderControl();
  private final AdamsInterpolant interpolant = new AdamsInterpolant();
  private final StiffnessMonitor stiffness = new StiffnessMonitor();
  private final RecentSteps recentSteps = new RecentSteps();

  private OdeSystem system = new NoUnknowns();
  private AdamsHistory history = new AdamsHistory(new double[0], new double[0], false);
  private Optional<IntegrationFailure> failure = Optional.empty();
  private boolean running;

  /** End, start, size and order of the last accepted step. */
  private double time;

  private double previousTime;
  private double lastSize;
  private int lastOrder;

  /** Size and end of the step being tried. */
  private double h;

  private double triedTime;

  /** Whether a step is begun, and whether the coefficients are those of the step being tried. */
  private boolean begun;

  private boolean prepared;

  private int notFiniteInARow;
  private int notFiniteComponent;
  private long steps;
  private long rejectedSteps;
  private long evaluations;

  /**
   * @throws IllegalArgumentException if a setting is out of range
   */
  AdamsPece(IntegratorSettings settings, ErrorNorm norm, StepBounds bounds) {
    settings.requireUsable();
    this.settings = settings;
    this.norm = norm;
    this.bounds = bounds;
  }

  /**
   * Returns the size of the first step.
   *
   * @param slope norm of f at the start; 0 if the solution starts at rest
   */
  abstract double firstStep(double slope);

  /**
   * Returns whether to carry round-off along.
   *
   * @param roundOff norm of the round-off of the state at the start
   */
  abstract boolean compensates(double roundOff);

  @Override
  public final StepResult start(OdeSystem system, double t0, double[] y0, double tEnd) {
    IntegratorSettings.requireUsable(t0, tEnd, y0, system.dimension());
    double[] tolerances = settings.absoluteTolerances(y0.length);
    this.system = system;
    clear(t0);
    norm.begin(settings.relativeTolerance(), tolerances);
    norm.weigh(y0);
    bounds.begin(t0, tEnd, settings.maxStep());
    double[] derivative = new double[y0.length];
    system.derivative(t0, y0.clone(), derivative);
    evaluations = 1;
    history = new AdamsHistory(y0, derivative, compensates(roundOff(y0)));
    int component = firstNotFinite(derivative);
    if (component != ALL_FINITE) {
      return fail(Cause.NOT_FINITE, component);
    }
    running = t0 != tEnd;
    h = firstStep(derivative, tEnd - t0);
    return running ? StepResult.ADVANCED : StepResult.REACHED_END;
  }

  private void clear(double t0) {
    coefficients.clear();
    control.begin(settings.highestOrder(AdamsCoefficients.HIGHEST_ORDER));
    stiffness.clear();
    recentSteps.clear();
    failure = Optional.empty();
    running = false;
    time = t0;
    previousTime = t0;
    triedTime = t0;
    lastSize = 0;
    lastOrder = 0;
    h = 0;
    begun = false;
    prepared = false;
    notFiniteInARow = 0;
    steps = 0;
    rejectedSteps = 0;
  }

  private double firstStep(double[] derivative, double interval) {
    double size =
        settings.initialStep() > 0
            ? settings.initialStep()
            : Math.min(
                FIRST_SHARE_OF_INTERVAL * Math.abs(interval), firstStep(norm.of(derivative)));
    return Math.copySign(size, interval);
  }

  @Override
  public final StepResult step() {
    requireRunning();
    beginStep();
    if (roundOff(history.state()) > 0.5) {
      return fail(Cause.TOLERANCE_TOO_TIGHT, norm.largest(history.state()));
    }
    while (steps + rejectedSteps < settings.maxSteps()) {
      prepare();
      Attempt attempt = attempt();
      if (attempt == Attempt.STOPPED) {
        return StepResult.STOPPED;
      }
      if (attempt == Attempt.PASSED) {
        accept();
        running = !bounds.reachedAt(time);
        return running ? StepResult.ADVANCED : StepResult.REACHED_END;
      }
      Optional<Cause> cause = reject(attempt);
      if (cause.isPresent()) {
        return fail(cause.get(), limitingComponent(attempt));
      }
    }
    return fail(Cause.TOO_MANY_STEPS, norm.largest(history.discrepancy));
  }

  /** Sets weights and bounds of a step; one that was stopped is taken up where it stood. */
  private void beginStep() {
    if (!begun) {
      norm.weigh(history.state());
      control.beginStep();
      h = bounds.bounded(time, h);
      begun = true;
    }
  }

  private void prepare() {
    if (!prepared) {
      coefficients.prepare(h, control.order());
      triedTime = bounds.endOf(time, h);
      prepared = true;
    }
  }

  /** Predict, evaluate, estimate, correct, evaluate. */
  private Attempt attempt() {
    int k = control.order();
    history.predict(h, k, coefficients.beta, coefficients.g);
    if (!evaluate(history.predicted)) {
      return Attempt.STOPPED;
    }
    history.compareDerivative();
    control.estimate(Math.abs(h), coefficients, history, norm);
    if (!(control.error() <= 1)) {
      return finite(history.derivative) ? Attempt.TOO_INACCURATE : Attempt.NOT_FINITE;
    }
    history.correct(h * coefficients.g[k + 1]);
    if (!evaluate(history.corrected())) {
      return Attempt.STOPPED;
    }
    return finite(history.corrected()) && finite(history.derivative)
        ? Attempt.PASSED
        : Attempt.NOT_FINITE;
  }

  private void accept() {
    int k = control.order();
    history.accept(k);
    coefficients.accept(h, k);
    recentSteps.record(time, h, k, control.error());
    stiffness.record(k, control.error());
    previousTime = time;
    time = triedTime;
    lastSize = h;
    lastOrder = k;
    steps++;
    notFiniteInARow = 0;
    h *= control.accept(Math.abs(h), coefficients.equalSteps(), history, norm);
    begun = false;
    prepared = false;
  }

  /** Reduces the step; returns a cause if that is not possible. */
  private Optional<Cause> reject(Attempt attempt) {
    boolean notFinite = attempt == Attempt.NOT_FINITE;
    recentSteps.record(time, h, control.order(), notFinite ? Double.NaN : control.error());
    rejectedSteps++;
    notFiniteInARow = notFinite ? notFiniteInARow + 1 : 0;
    double smallest = bounds.smallest(time);
    if (notFiniteInARow == NOT_FINITE_TRIES || Math.abs(h) <= smallest) {
      return Optional.of(notFinite ? Cause.NOT_FINITE : Cause.STEP_TOO_SMALL);
    }
    double factor = notFinite ? control.rejectNotFinite() : control.reject();
    h = Math.copySign(Math.max(factor * Math.abs(h), smallest), h);
    prepared = false;
    return Optional.empty();
  }

  /** Evaluates f at the end of the step being tried; returns false if told to stop instead. */
  private boolean evaluate(double[] y) {
    if (settings.stop().getAsBoolean()) {
      return false;
    }
    system.derivative(triedTime, y, history.derivative);
    evaluations++;
    return true;
  }

  /** Returns the norm of the rounding errors that a state of this size cannot avoid. */
  private double roundOff(double[] y) {
    return 2 * UNIT_ROUNDOFF * norm.of(y);
  }

  /** Returns whether all components are finite; if not, remembers the first that is not. */
  private boolean finite(double[] x) {
    notFiniteComponent = firstNotFinite(x);
    return notFiniteComponent == ALL_FINITE;
  }

  private static int firstNotFinite(double[] x) {
    for (int l = 0; l < x.length; l++) {
      if (!Double.isFinite(x[l])) {
        return l;
      }
    }
    return ALL_FINITE;
  }

  private int limitingComponent(Attempt attempt) {
    return attempt == Attempt.NOT_FINITE ? notFiniteComponent : norm.largest(history.discrepancy);
  }

  private StepResult fail(Cause cause, int component) {
    running = false;
    int order = h == 0 ? 0 : control.order();
    failure =
        Optional.of(new IntegrationFailure(cause, time, h, order, component, recentSteps.list()));
    return StepResult.FAILED;
  }

  private void requireRunning() {
    if (!running) {
      throw new IllegalStateException(
          failure.isPresent()
              ? "the integration failed at t = " + time + "; start a new one"
              : "nothing to integrate: the end is reached, or start was not called");
    }
  }

  @Override
  public final double time() {
    return time;
  }

  @Override
  public final double previousTime() {
    return previousTime;
  }

  @Override
  public final double stepSize() {
    return lastSize;
  }

  @Override
  public final int order() {
    return lastOrder;
  }

  @Override
  public final void interpolate(double t, double[] y, double[] yDot) {
    if (!((previousTime <= t && t <= time) || (time <= t && t <= previousTime))) {
      throw new IllegalArgumentException(
          "t = " + t + " lies outside the last step, " + previousTime + " to " + time);
    }
    interpolant.evaluate(t - time, lastOrder, coefficients.psi, history, y, yDot);
  }

  @Override
  public final IntegrationStatistics statistics() {
    return new IntegrationStatistics(
        steps, rejectedSteps, evaluations, stiffness.suspectsStiffness());
  }

  @Override
  public final IntegrationFailure failure() {
    return failure.orElseThrow(() -> new IllegalStateException("the integration has not failed"));
  }

  /** Stands in until a problem is given. */
  private static final class NoUnknowns implements OdeSystem {
    @Override
    public int dimension() {
      return 0;
    }

    @Override
    public void derivative(double t, double[] y, double[] yDot) {}
  }
}
