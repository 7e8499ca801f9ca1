package org.mechservice.solver.ode.stiff;

import java.util.Optional;
import org.mechservice.solver.ode.IntegrationFailure.Cause;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.IntegratorSettings.Mode;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.TrialOutcome;
import org.mechservice.solver.ode.backward.BackwardDifferences;
import org.mechservice.solver.ode.backward.BackwardFormulas;
import org.mechservice.solver.ode.backward.BackwardOrderControl;
import org.mechservice.solver.ode.newton.ColumnTest;
import org.mechservice.solver.ode.newton.StepEquations;
import org.mechservice.solver.ode.newton.StepSolver;
import org.mechservice.solver.ode.step.ErrorNorm;
import org.mechservice.solver.ode.step.IntegrationProgress;
import org.mechservice.solver.ode.step.Manifold;
import org.mechservice.solver.ode.step.MaximumNorm;
import org.mechservice.solver.ode.step.RightHandSide;
import org.mechservice.solver.ode.step.StepWatch;
import org.mechservice.solver.ode.step.TriedStep;

/**
 * One step of a backward method after the other: {@link #attempt} linearises, solves and tests it,
 * {@link #accept} chooses order and size of the next, {@link #repair} finds out what to do about
 * one that failed.
 */
final class BackwardStep implements TriedStep {
  /** Reduction of a step whose iteration did not converge although the derivatives were new. */
  private static final double UNSOLVED_REDUCTION = 0.3;

  private final IntegrationProgress progress;
  private final BackwardFormulas usual;
  private final Mode mode;

  /** Whether formulas that make the fastest oscillation grow are avoided. */
  private final boolean watchesOscillations;

  /** Whether formulas are changed for that, too. */
  private final boolean changesFormulas;

  private final ErrorAllowance allowance;
  private final BackwardOrderControl control;

  /** Formulas of the step being tried. */
  private BackwardFormulas formulas;

  private final MaximumNorm norm = new MaximumNorm();
  private final StepSize step = new StepSize();
  private StepWatch watch = StepWatch.NONE;

  private StepEquations equations;
  private StepSolver solver;
  private BackwardDifferences differences = new BackwardDifferences(0);

  /** Whether the error that the last test judged is the part of the correction that follows. */
  private boolean judgedAlongManifold;

  private double[] alongManifold = new double[0];

  /** y' at the end of the step, where it is asked for, length n. */
  private double[] slope = new double[0];

  /** Relative tolerance of the norm. */
  private double relativeTolerance;

  /** End of the step being tried. */
  private double triedTime;

  /** End of the problem. */
  private double tEnd;

  /** Whether a step is begun. */
  private boolean begun;

  /**
   * @param turns whether another method takes the steps in which nothing is stiff
   */
  BackwardStep(IntegrationProgress progress, BackwardFormulas formulas, Mode mode, boolean turns) {
    this.progress = progress;
    usual = formulas;
    this.formulas = formulas;
    this.mode = mode;
    watchesOscillations = mode != Mode.FAITHFUL;
    changesFormulas = watchesOscillations && !turns;
    allowance = turns ? ErrorAllowance.full() : ErrorAllowance.of(mode);
    control = new BackwardOrderControl(formulas, turns);
    equations = StepEquations.none();
    solver = new StepSolver(equations, mode);
  }

  /** Has the steps of all problems to come watched. */
  void watch(StepWatch watch) {
    this.watch = watch;
  }

  /**
   * Makes ready for a problem.
   *
   * @param tested settings with the tolerances of its error tests
   * @param toleranceFactor those over the ones asked for, as far as the mode makes them
   */
  void prepare(
      StepEquations equations,
      double t0,
      double tEnd,
      IntegratorSettings tested,
      double toleranceFactor) {
    int n = equations.manifold().dimension();
    this.equations = equations;
    control.cautious(watchesOscillations && equations.allowsCaution());
    this.tEnd = tEnd;
    solver = new StepSolver(equations, mode);
    differences = new BackwardDifferences(n);
    alongManifold = new double[n];
    judgedAlongManifold = false;
    slope = new double[n];
    relativeTolerance = tested.relativeTolerance();
    norm.begin(relativeTolerance, tested.absoluteTolerances(n), equations.manifold());
    allowance.begin(relativeTolerance, toleranceFactor);
    step.begin(n, t0, tEnd, tested.maxStep());
    watch.part(ColumnTest.Maker.class).ifPresent(equations::testColumns);
    watch.prepare(this);
  }

  /**
   * Begins at order 1.
   *
   * @param initialStep size of the first step; 0 for the method's choice
   * @param restarted whether the problem goes on from another state
   */
  void beginAt(double t, double[] y, int highestOrder, double initialStep, boolean restarted) {
    control.begin(highestOrder, restarted);
    watch.begin(t);
    step.beginAt(initialStep, restarted);
    step.stopAt(equations.breakpoints().next());
    triedTime = t;
    begun = false;
    differences.begin(y);
    norm.allow(1);
    norm.weigh(differences.state());
    solver.beginAnew();
  }

  /** Completes state and derivative of a start. */
  TrialOutcome findStart(double t) {
    TrialOutcome attempt = equations.findStart(t, differences.state(), differences.slope());
    if (attempt != TrialOutcome.STOPPED) {
      norm.weigh(differences.state());
    }
    return attempt;
  }

  /** Linearise, solve, test; what was stopped is taken up where it stood. */
  TrialOutcome attempt() {
    TrialOutcome attempt = linearise();
    if (attempt == TrialOutcome.PASSED) {
      attempt = solve();
    }
    return attempt == TrialOutcome.PASSED ? test() : attempt;
  }

  /** Brings Jacobian, size, differences and factors to those of the step being tried. */
  private TrialOutcome linearise() {
    TrialOutcome attempt =
        step.chosen() && equations.derivatives().lookAhead()
            ? lineariseAhead()
            : solver.linearise(progress.time(), differences.state(), hGamma());
    if (attempt != TrialOutcome.PASSED) {
      return attempt;
    }
    return place() ? solver.factor(hGamma()) : TrialOutcome.STOPPED;
  }

  /** Forms derivatives at the prediction if new ones are wanted. */
  private TrialOutcome lineariseAhead() {
    if (solver.begun()) {
      return TrialOutcome.PASSED;
    }
    place();
    double end = step.endOf(progress.time());
    if (!equations.derivatives().wantedAhead(end)) {
      return TrialOutcome.PASSED;
    }
    differences.predict(control.order(), formulas);
    return solver.lineariseAhead(end, hGamma(), differences);
  }

  /** Brings size and differences to those of the step; returns false if told to stop instead. */
  private boolean place() {
    if (!begun && !begin()) {
      return false;
    }
    if (step.write(differences, control.order())) {
      control.rescaled();
      equations.factors().changeStep();
    }
    return true;
  }

  /** Bounds the step, the first one being chosen before; returns false if told to stop instead. */
  private boolean begin() {
    if (!step.prepare(
        progress.time(), equations, differences, norm, relativeTolerance, allowance)) {
      return false;
    }
    control.beginStep();
    if (changesFormulas) {
      chooseFormulas();
    }
    begun = true;
    return true;
  }

  /**
   * Chooses formulas for a step: those of backward differentiation are stable for less damping at
   * orders 3 and 4.
   */
  private void chooseFormulas() {
    BackwardFormulas chosen = equations.dampingOfFastest() > 0 ? BackwardFormulas.BDF : usual;
    // Collectors make it cost more to store a reference than to compare it.
    if (formulas != chosen) {
      formulas = chosen;
      control.use(chosen);
    }
  }

  private double hGamma() {
    return step.size() / formulas.leading(control.order());
  }

  /** Predicts and iterates. */
  private TrialOutcome solve() {
    if (!solver.begun()) {
      norm.allow(allowance.part(step.size(), equations));
      triedTime = step.endOf(progress.time());
      differences.predict(control.order(), formulas);
      norm.weigh(differences.state(), differences.predicted);
      solver.begin(triedTime, differences, control.order(), norm);
    }
    return solver.solve(triedTime, hGamma(), differences, norm);
  }

  private TrialOutcome test() {
    judgedAlongManifold = false;
    control.estimate(solver.sizeOfCorrection(differences, norm));
    if (control.error() > 1) {
      leaveOutProjected();
    }
    return watch.passes(control.error()) ? TrialOutcome.PASSED : TrialOutcome.TOO_INACCURATE;
  }

  /** Judges the error of the step by its part along the manifold of the system, if it has one. */
  private void leaveOutProjected() {
    System.arraycopy(differences.correction, 0, alongManifold, 0, alongManifold.length);
    if (equations.manifold().projectError(triedTime, differences.corrected(), alongManifold)) {
      judgedAlongManifold = true;
      control.estimate(norm.of(alongManifold));
    }
  }

  /** Returns whether the step that passed is to be tried shorter; it is then cut off. */
  boolean cutShort() {
    double part = watch.partToTake();
    if (part == 1) {
      return false;
    }
    progress.rejected(step.size(), control.order(), Double.NaN, TrialOutcome.TOO_INACCURATE, -1);
    step.reduce(part, progress.time());
    return true;
  }

  /** Goes on to the end of the step that passed. */
  void accept() {
    int k = control.order();
    differences.accept(k);
    progress.accepted(step.size(), triedTime, k, control.error());
    boolean historyIsOfNoUse = watch.accepted();
    solver.moveOn(hGamma(), differences);
    followOscillation();
    step.propose(control.accept(differences, norm));
    if (historyIsOfNoUse) {
      control.restart();
    }
    aimAt(watch.aim());
    step.bound(watch.longest());
    begun = false;
    equations.manifold().restoreUnitGroups(differences.state(), differences);
    if (equations.manifold().accepted(triedTime, differences.state())) {
      equations.derivatives().demandNew();
    }
  }

  /** Tells the control how far the step goes on the fastest oscillation. */
  private void followOscillation() {
    if (watchesOscillations) {
      double advance = Math.abs(step.size()) * equations.rateOfFastest();
      control.follow(advance, equations.dampingOfFastest());
    }
  }

  /** Proposes the step that the watch aims at, if it does and if that is shorter. */
  private void aimAt(double size) {
    if (Double.isFinite(size)) {
      if (watch.atOrderOne()) {
        control.restart();
      }
      step.propose(Math.min(1, Math.abs(size / step.size())));
    }
  }

  /**
   * Asks for a new Jacobian if that may help, else reduces the step; returns a cause if neither is
   * possible.
   */
  Optional<Cause> repair(TrialOutcome attempt) {
    boolean inaccurate = attempt == TrialOutcome.TOO_INACCURATE;
    double error = inaccurate ? control.error() : Double.NaN;
    progress.rejected(step.size(), control.order(), error, attempt, limitingComponent(attempt));
    if (progress.notFiniteTooOften()) {
      return Optional.of(Cause.NOT_FINITE);
    }
    if (!inaccurate && solver.renew(hGamma())) {
      return Optional.empty();
    }
    boolean asked = watch.atOrderOne();
    if (!step.canBeReduced(progress.time()) || watch.rejected(attempt)) {
      return Optional.of(solver.cause(attempt, tEnd - progress.start(), norm));
    }
    reduce(inaccurate, asked);
    return Optional.empty();
  }

  /**
   * Reduces the step. A watch may ask once for the same step at order 1, not more often.
   *
   * @param asked whether it did for the step that failed
   */
  private void reduce(boolean inaccurate, boolean asked) {
    double aim = watch.aim();
    if (Double.isFinite(aim)) {
      double tried = Math.abs(step.size());
      aimAt(aim);
      boolean again = Math.abs(step.size()) >= tried && (asked || !inaccurate);
      step.reduce(again ? UNSOLVED_REDUCTION : 1, progress.time());
      return;
    }
    followOscillation();
    double factor = inaccurate ? control.reject(differences, norm) : UNSOLVED_REDUCTION;
    step.reduce(factor, progress.time());
    if (inaccurate && watch.forgets()) {
      control.restart();
    }
  }

  /** Returns the component that made a try fail, or would have. */
  int limitingComponent(TrialOutcome attempt) {
    return attempt == TrialOutcome.TOO_INACCURATE
        ? norm.largest(judgedAlongManifold ? alongManifold : differences.correction)
        : solver.limitingComponent(attempt, norm);
  }

  /** Ends the integration at the last accepted step. */
  StepResult fail(Cause cause, int component) {
    return progress.fail(cause, step.size(), control.order(), component, norm);
  }

  /** Sets the longest size that the first step may have if the method chooses it. */
  void boundFirst(double longest) {
    step.boundFirst(longest);
  }

  /** Returns whether the problem's end is reached. */
  boolean atEnd() {
    return step.endsAt(progress.time());
  }

  /** Returns whether a step is begun that was stopped. */
  boolean begun() {
    return begun;
  }

  /** Returns the equations of the problem. */
  StepEquations equations() {
    return equations;
  }

  /** Returns the history. */
  BackwardDifferences differences() {
    return differences;
  }

  @Override
  public Optional<RightHandSide> rightHandSide() {
    return equations.rightHandSide();
  }

  @Override
  public Manifold manifold() {
    return equations.manifold();
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
    return tEnd;
  }

  @Override
  public double size() {
    return step.size();
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
    return norm.of(differences.correction) / Math.abs(hGamma());
  }

  @Override
  public double[] state() {
    return differences.state();
  }

  @Override
  public double[] stateAtEnd() {
    return differences.corrected();
  }

  /** {@inheritDoc} The formula y_{n+1} − y_n = h y'_{n+1} makes every step look straight. */
  @Override
  public double[] slopeAtEnd() {
    double h = step.size();
    double hGamma = hGamma();
    for (int l = 0; l < slope.length; l++) {
      slope[l] =
          hGamma == h
              ? (differences.predicted[l] - differences.state()[l]) / h
              : (differences.psi[l] + differences.correction[l]) / hGamma;
    }
    return slope;
  }

  /** Returns the relative tolerance of that norm. */
  double relativeTolerance() {
    return relativeTolerance;
  }

  /** Carries over by what the steps are watched; refuses another watch than that saved. */
  void requireWatch(SavedState state) {
    state.require("watch of the steps", watch.name());
  }

  /** Carries the state between two steps over. */
  void transfer(SavedState state, int highestOrder) {
    if (state.restoring()) {
      control.begin(highestOrder, false);
      begun = false;
    }
    solver.transfer(state);
    step.stopAt(equations.breakpoints().next());
    progress.transfer(state);
    differences.transfer(state);
    control.transfer(state);
    watch.transfer(state);
    triedTime = state.number(triedTime);
    step.transfer(state);
    if (state.restoring()) {
      norm.allow(1);
      norm.weigh(differences.state());
    }
  }
}
