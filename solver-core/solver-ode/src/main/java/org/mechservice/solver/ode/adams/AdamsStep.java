package org.mechservice.solver.ode.adams;

import java.util.Arrays;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;
import org.mechservice.solver.ode.IntegrationFailure.Cause;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.TrialOutcome;
import org.mechservice.solver.ode.step.ErrorNorm;
import org.mechservice.solver.ode.step.ExtrapolatedStep;
import org.mechservice.solver.ode.step.IntegrationProgress;
import org.mechservice.solver.ode.step.Manifold;
import org.mechservice.solver.ode.step.RightHandSide;
import org.mechservice.solver.ode.step.StepBounds;
import org.mechservice.solver.ode.step.StepWatch;

/**
 * One step of an Adams method after the other: {@link #attempt} predicts, evaluates, tests,
 * corrects and evaluates it, {@link #accept} chooses order and size of the next, {@link #repair}
 * makes one that failed shorter.
 */
final class AdamsStep implements ExtrapolatedStep {
  /** Share of the interval that the first step may cover: a start at rest says nothing about f. */
  private static final double FIRST_SHARE_OF_INTERVAL = 0.1;

  private static final double UNIT_ROUNDOFF = Math.ulp(1.0);

  private final IntegrationProgress progress;
  private final ErrorNorm norm;
  private final StepBounds bounds;
  private final DoubleUnaryOperator firstStep;
  private final int highestOrder;
  private final AdamsCoefficients coefficients = new AdamsCoefficients();
  private final AdamsOrderControl control = new AdamsOrderControl();
  private final StiffnessMonitor stiffness = new StiffnessMonitor();
  private final AdamsInterpolant interpolant = new AdamsInterpolant();
  private StepWatch watch = StepWatch.NONE;

  /**
   * By how much completions changed the predicted and the corrected state of the step: the error of
   * the corrector in the passive components.
   */
  private double[] completion = new double[0];

  /** Whether that error alone rejects the step: f, in which jumps are searched for, shows none. */
  private boolean passiveInaccurate;

  private AdamsProblem problem = AdamsProblem.none();
  private AdamsHistory history = problem.history();

  /** Size and end of the step being tried. */
  private double h;

  private double triedTime;

  /** Whether a step is begun, and whether the coefficients are those of the step being tried. */
  private boolean begun;

  private boolean prepared;

  /** Whether the step being tried is predicted, and f known there. */
  private boolean foreseen;

  private int notFiniteComponent;

  /**
   * @param firstStep size of the first step by the norm of f at the start, which is 0 if the
   *     solution starts at rest
   */
  AdamsStep(
      IntegrationProgress progress,
      ErrorNorm norm,
      StepBounds bounds,
      DoubleUnaryOperator firstStep,
      IntegratorSettings settings) {
    this.progress = progress;
    this.norm = norm;
    this.bounds = bounds;
    this.firstStep = firstStep;
    highestOrder = settings.highestOrder(AdamsCoefficients.HIGHEST_ORDER);
  }

  /** Has the steps of all problems to come watched. */
  void watch(StepWatch watch) {
    this.watch = watch;
  }

  /** Makes ready for a problem, for which norm and bounds are begun. */
  void prepare(AdamsProblem problem) {
    this.problem = problem;
    history = problem.history();
    completion = new double[problem.manifold().completes() ? problem.dimension() : 0];
    watch.prepare(this);
  }

  /** Forgets what steps towards another state have told. */
  void beginAgain() {
    stiffness.beginAgain();
  }

  /**
   * Begins at order 1.
   *
   * @param initialStep size of the first step; 0 for the method's choice
   * @return {@link TrialOutcome#PASSED} unless the state cannot be completed, or f is not finite
   */
  TrialOutcome beginAt(double t, double[] y, double initialStep) {
    coefficients.clear();
    control.begin(highestOrder);
    watch.begin(t);
    bounds.stopAt(problem.equations().breakpoints().next());
    triedTime = t;
    h = 0;
    abandon();
    history.begin(y);
    boolean complete = problem.manifold().complete(t, history.state());
    norm.weigh(history.state());
    problem.equations().evaluateAlways(t, history.state(), history.derivative);
    history.beginDerivative();
    if (!complete) {
      return TrialOutcome.NOT_COMPLETED;
    }
    if (!finite(history.derivative)) {
      return TrialOutcome.NOT_FINITE;
    }
    h = Math.copySign(initialStep > 0 ? initialStep : firstStepFrom(t), problem.end() - t);
    return TrialOutcome.PASSED;
  }

  private double firstStepFrom(double t) {
    return Math.min(
        FIRST_SHARE_OF_INTERVAL * Math.abs(problem.end() - t),
        firstStep.applyAsDouble(norm.of(history.derivative)));
  }

  /** Makes the first step no longer than this. */
  void boundFirst(double longest) {
    h = Math.copySign(Math.min(Math.abs(h), longest), h);
  }

  /**
   * Sets bounds, coefficients and weights of a step, the coefficients first, since their divisions
   * take long and nothing waits for them yet; one that was stopped is taken up where it stood.
   */
  void begin() {
    if (!begun) {
      h = bounds.bounded(progress.time(), h);
      control.beginStep();
      prepare();
      norm.weigh(history.state());
      begun = true;
    }
  }

  private void prepare() {
    if (!prepared) {
      coefficients.prepare(h, control.order());
      triedTime = bounds.endOf(progress.time(), h);
      prepared = true;
    }
  }

  /** Predicts the first step; returns false if told to stop instead. */
  boolean foresee() {
    begin();
    TrialOutcome prediction = predict(control.order());
    foreseen = prediction == TrialOutcome.PASSED;
    return prediction != TrialOutcome.STOPPED;
  }

  /** Returns whether a first step is foreseen. */
  boolean foreseen() {
    return foreseen;
  }

  /** Gives a step up that was begun. */
  void abandon() {
    begun = false;
    prepared = false;
    foreseen = false;
  }

  /** Predict, complete, evaluate, estimate, correct, complete and project, evaluate. */
  TrialOutcome attempt() {
    prepare();
    passiveInaccurate = false;
    int k = control.order();
    TrialOutcome prediction = foreseen ? TrialOutcome.PASSED : predict(k);
    foreseen = false;
    if (prediction != TrialOutcome.PASSED) {
      return prediction;
    }
    control.estimate(Math.abs(h), coefficients, history, norm);
    if (!watch.passes(control.error())) {
      return finite(history.derivative) ? TrialOutcome.TOO_INACCURATE : TrialOutcome.NOT_FINITE;
    }
    if (!correct(h * coefficients.g[k + 1])) {
      return TrialOutcome.NOT_COMPLETED;
    }
    passiveInaccurate = !(control.error() <= 1);
    if (passiveInaccurate) {
      return TrialOutcome.TOO_INACCURATE;
    }
    if (!evaluate(history.corrected())) {
      return TrialOutcome.STOPPED;
    }
    return finite(history.corrected()) && finite(history.derivative)
        ? TrialOutcome.PASSED
        : TrialOutcome.NOT_FINITE;
  }

  /** Predict, complete, evaluate. */
  private TrialOutcome predict(int k) {
    history.predict(h, k, coefficients.beta, coefficients.g);
    Arrays.fill(completion, 0);
    if (!complete(history.predicted)) {
      return TrialOutcome.NOT_COMPLETED;
    }
    if (!evaluate(history.predicted)) {
      return TrialOutcome.STOPPED;
    }
    history.compareDerivative();
    return TrialOutcome.PASSED;
  }

  /** Forms the corrected state, moved onto the manifold: f there enters the history. */
  private boolean correct(double weight) {
    Manifold manifold = problem.manifold();
    double[] corrected = history.corrected();
    history.correct(weight);
    boolean found = complete(corrected);
    if (completion.length > 0) {
      control.include(norm.of(completion));
    }
    found = found && manifold.project(triedTime, corrected);
    history.carry(weight);
    return found;
  }

  /** Completes a state; adds what that changes to the completion of the step. */
  private boolean complete(double[] y) {
    for (int l = 0; l < completion.length; l++) {
      completion[l] -= y[l];
    }
    boolean found = problem.manifold().complete(triedTime, y);
    for (int l = 0; l < completion.length; l++) {
      completion[l] += y[l];
    }
    return found;
  }

  /** Returns the component that grows beyond every bound in the step that passed, or −1. */
  int componentWithPole() {
    return watch.componentWithPole();
  }

  /** Returns whether the step that passed is to be tried shorter; it is then cut off. */
  boolean cutShort() {
    double part = watch.partToTake();
    if (part == 1) {
      return false;
    }
    progress.rejected(h, control.order(), Double.NaN, TrialOutcome.TOO_INACCURATE, -1);
    h *= part;
    prepared = false;
    return true;
  }

  /** Goes on to the end of the step that passed. */
  void accept() {
    int k = control.order();
    history.accept(k);
    coefficients.accept(h, k);
    progress.accepted(h, triedTime, k, control.error());
    boolean historyIsOfNoUse = watch.accepted();
    stiffness.accepted(h, k, control.error(), coefficients.g[k + 1], history, norm);
    h *= control.accept(Math.abs(h), coefficients.equalSteps(), history, norm);
    problem.manifold().restoreUnitGroups(history.state(), history);
    problem.manifold().accepted(triedTime, history.state());
    if (historyIsOfNoUse) {
      forgetHistory();
    }
    double aim = watch.aim();
    if (Double.isFinite(aim)) {
      h = aimedAt(aim, h);
    }
    h = Math.copySign(Math.min(Math.abs(h), watch.longest()), h);
    begun = false;
    prepared = false;
  }

  /** Begins at order 1 behind a jump, where f is known. */
  private void forgetHistory() {
    stiffness.beginAgain();
    coefficients.beginAgain();
    control.begin(highestOrder);
    h = Math.copySign(firstStepFrom(triedTime), h);
  }

  /** Returns the step that the watch aims at, no longer than given. */
  private double aimedAt(double aim, double longest) {
    if (watch.atOrderOne()) {
      control.fallToOrderOne();
    }
    return Math.abs(aim) < Math.abs(longest) ? aim : longest;
  }

  /** Returns whether the solution slides along a jump and would have to cross it for ever. */
  boolean slides() {
    return watch.slides(h);
  }

  /** Reduces the step; returns a cause if that is not possible. */
  Optional<Cause> repair(TrialOutcome attempt) {
    boolean inaccurate = attempt == TrialOutcome.TOO_INACCURATE;
    double error = inaccurate ? control.error() : Double.NaN;
    progress.rejected(h, control.order(), error, attempt, limitingComponent(attempt));
    double smallest = bounds.smallest(progress.time());
    boolean hopeless = Math.abs(h) <= smallest || watch.rejected(attempt);
    if (progress.notFiniteTooOften() || hopeless) {
      return Optional.of(attempt.cause());
    }
    double size = Math.abs(inaccurate ? retry() : control.rejectNotFinite() * h);
    h = Math.copySign(Math.max(size, smallest), h);
    prepared = false;
    return Optional.empty();
  }

  /** Returns the step to try after one that failed the error test. */
  private double retry() {
    if (passiveInaccurate) {
      return control.reject() * h;
    }
    double aim = watch.aim();
    return Double.isFinite(aim) ? aimedAt(aim, h) : control.reject() * h;
  }

  /** Evaluates f at the end of the step being tried; returns false if told to stop instead. */
  private boolean evaluate(double[] y) {
    return problem.equations().evaluate(triedTime, y, history.derivative);
  }

  /** Returns whether all components are finite; if not, remembers the first that is not. */
  private boolean finite(double[] x) {
    notFiniteComponent = RightHandSide.firstNotFinite(x);
    return notFiniteComponent < 0;
  }

  /** Returns the component that made a try fail, or would have. */
  int limitingComponent(TrialOutcome attempt) {
    return switch (attempt) {
      case NOT_FINITE -> notFiniteComponent;
      case NOT_COMPLETED -> -1;
      default -> norm.largest(history.discrepancy);
    };
  }

  /** Ends the integration at the last accepted step. */
  StepResult fail(Cause cause, int component) {
    return progress.fail(cause, h, control.order(), component, norm);
  }

  /** Returns the norm of the rounding errors that a state cannot avoid. */
  double roundOff(double[] y) {
    return 2 * UNIT_ROUNDOFF * norm.of(y);
  }

  /** Returns whether something steep lies ahead that only an implicit method sees as a slope. */
  boolean steepAhead() {
    return watch.steepAhead();
  }

  /** Returns whether the problem's end is reached. */
  boolean atEnd() {
    return bounds.reachedAt(progress.time());
  }

  /** Returns whether a step is begun that was stopped or foreseen. */
  boolean begun() {
    return begun;
  }

  @Override
  public Optional<RightHandSide> rightHandSide() {
    return Optional.of(problem.equations());
  }

  @Override
  public Manifold manifold() {
    return problem.manifold();
  }

  @Override
  public ErrorNorm norm() {
    return norm;
  }

  @Override
  public IntegrationProgress progress() {
    return progress;
  }

  @Override
  public double problemEnd() {
    return problem.end();
  }

  @Override
  public double size() {
    return h;
  }

  @Override
  public double end() {
    return triedTime;
  }

  @Override
  public int order() {
    return control.order();
  }

  @Override
  public double error() {
    return control.error();
  }

  @Override
  public double discrepancy() {
    return control.discrepancy();
  }

  @Override
  public int worstComponent() {
    return norm.largest(history.discrepancy);
  }

  @Override
  public double[] state() {
    return history.state();
  }

  @Override
  public double[] stateAtEnd() {
    return history.corrected();
  }

  @Override
  public double[] slope() {
    return history.difference(1);
  }

  @Override
  public double[] slopeAtEnd() {
    return history.derivative;
  }

  @Override
  public double[] foreseenSlope() {
    return history.foreseen();
  }

  @Override
  public double difference(int i, int component) {
    if (i > control.order()) {
      return i <= progress.order() + 1 ? Math.abs(history.difference(i)[component]) : 0;
    }
    return Math.abs(coefficients.beta[i] * history.difference(i)[component]);
  }

  @Override
  public void extrapolate(double part, double[] y, double[] yDot) {
    interpolant.evaluate(part * h, control.order() - 1, coefficients.psi, history, y, yDot);
  }

  /** Returns the problem. */
  AdamsProblem problem() {
    return problem;
  }

  /** Evaluates state and derivative inside the last step. */
  void interpolate(double t, double[] y, double[] yDot) {
    double back = t - progress.time();
    interpolant.evaluate(back, progress.order(), coefficients.psi, history, y, yDot);
  }

  /** Returns ψ of the last step, as its interpolation needs it. */
  double[] psi() {
    return coefficients.psi;
  }

  /** Returns what the steps tell of stiffness. */
  StiffnessMonitor stiffness() {
    return stiffness;
  }

  /** Carries over by what the steps are watched; refuses another watch than that saved. */
  void requireWatch(SavedState state) {
    state.require("watch of the steps", watch.name());
  }

  /** Carries the state between two steps over; the problem's own is carried over before. */
  void transfer(SavedState state) {
    if (state.restoring()) {
      control.begin(highestOrder);
      bounds.stopAt(problem.equations().breakpoints().next());
      begun = false;
      prepared = false;
    }
    progress.transfer(state);
    history.transfer(state);
    coefficients.transfer(state);
    control.transfer(state);
    watch.transfer(state);
    stiffness.transfer(state);
    h = state.number(h);
    triedTime = state.number(triedTime);
  }
}
