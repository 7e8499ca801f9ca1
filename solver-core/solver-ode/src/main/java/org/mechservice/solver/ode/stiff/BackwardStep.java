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
import org.mechservice.solver.ode.jumps.JumpMonitor;
import org.mechservice.solver.ode.jumps.JumpSearch;
import org.mechservice.solver.ode.jumps.PulseProbe;
import org.mechservice.solver.ode.jumps.SlidingMonitor;
import org.mechservice.solver.ode.newton.StepEquations;
import org.mechservice.solver.ode.newton.StepSolver;
import org.mechservice.solver.ode.step.IntegrationProgress;
import org.mechservice.solver.ode.step.MaximumNorm;

/**
 * One step of a backward method after the other: {@link #attempt} linearises, solves and tests it,
 * {@link #accept} chooses order and size of the next, {@link #repair} finds out what to do about
 * one that failed.
 */
final class BackwardStep {
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
  private final JumpMonitor jumps = new JumpMonitor();
  private final JumpSearch search = new JumpSearch();
  private final SlidingMonitor slide = new SlidingMonitor();
  private PulseProbe pulses = new PulseProbe(0);

  private StepEquations equations;
  private StepSolver solver;
  private BackwardDifferences differences = new BackwardDifferences(0);

  /** Whether the error that the last test judged is the part of the correction that follows. */
  private boolean judgedAlongManifold;

  private double[] alongManifold = new double[0];

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
    pulses = new PulseProbe(n);
    relativeTolerance = tested.relativeTolerance();
    norm.begin(relativeTolerance, tested.absoluteTolerances(n), equations.manifold());
    allowance.begin(relativeTolerance, toleranceFactor);
    step.begin(n, t0, tEnd, tested.maxStep());
  }

  /**
   * Begins at order 1.
   *
   * @param initialStep size of the first step; 0 for the method's choice
   * @param restarted whether the problem goes on from another state
   */
  void beginAt(double t, double[] y, int highestOrder, double initialStep, boolean restarted) {
    control.begin(highestOrder, restarted);
    jumps.begin();
    search.clear();
    slide.clear();
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
    if (control.error() <= 1) {
      boolean jumpInside = search.active() && search.inside(step.size(), discrepancy());
      return jumpInside ? TrialOutcome.TOO_INACCURATE : TrialOutcome.PASSED;
    }
    jumps.failed(step.size(), control.error());
    boolean jumped = equations.solutionMayJump() && jumps.solutionJumped(control.error());
    return jumped ? TrialOutcome.PASSED : TrialOutcome.TOO_INACCURATE;
  }

  /** Judges the error of the step by its part along the manifold of the system, if it has one. */
  private void leaveOutProjected() {
    System.arraycopy(differences.correction, 0, alongManifold, 0, alongManifold.length);
    if (equations.manifold().projectError(triedTime, differences.corrected(), alongManifold)) {
      judgedAlongManifold = true;
      control.estimate(norm.of(alongManifold));
    }
  }

  /** Returns the norm of what y' differs by from its prediction. */
  private double discrepancy() {
    return norm.of(differences.correction) / Math.abs(hGamma());
  }

  /** Returns whether there is a pulse in the step that passed; it is then cut off in front. */
  boolean cutAtPulse() {
    if (mode == Mode.FAITHFUL
        || control.error() >= PulseProbe.ERROR_OF_STRAIGHT_STEP
        || !pulses.wanted(
            step.size(), progress.stepSize(), tEnd - progress.start(), search.shortestDistance())) {
      return false;
    }
    double part =
        equations.partToPulse(pulses, progress.time(), step.size(), hGamma(), differences, norm);
    if (pulses.sawStraightLine()) {
      search.straightFrom(progress.start());
    }
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
    double size = step.size();
    double error = control.error();
    differences.accept(k);
    progress.accepted(size, triedTime, k, error);
    jumps.accepted(error);
    solver.moveOn(hGamma(), differences);
    followOscillation();
    step.propose(control.accept(differences, norm));
    boolean jumpPassed = search.accepted(size, triedTime, error);
    if (error > 1 || jumpPassed) {
      control.restart();
    }
    if (search.active()) {
      towardsJump();
    }
    step.bound(search.longestStep(triedTime));
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

  /** Proposes a step that halves the stretch with a jump, or crosses it, if that is shorter. */
  private void towardsJump() {
    double size = search.step(progress.time());
    if (search.crossing()) {
      control.restart();
    }
    step.propose(Math.min(1, Math.abs(size / step.size())));
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
    if (!step.canBeReduced(progress.time()) || slides(attempt)) {
      return Optional.of(solver.cause(attempt, tEnd - progress.start(), norm));
    }
    reduce(inaccurate);
    return Optional.empty();
  }

  private boolean slides(TrialOutcome attempt) {
    return attempt == TrialOutcome.NOT_CONVERGING
        && mode != Mode.FAITHFUL
        && slide.unsolved(progress.time(), tEnd);
  }

  /** A search for a jump may ask once for the same step at order 1, not more often. */
  private void reduce(boolean inaccurate) {
    boolean crossed = search.crossing();
    boolean searches = inaccurate && mode != Mode.FAITHFUL && !equations.solutionMayJump();
    if (searches && Double.isFinite(control.error())) {
      search.rejected(step.size(), control.order(), triedTime, control.error(), discrepancy());
    }
    if (search.active()) {
      double tried = Math.abs(step.size());
      towardsJump();
      boolean again = Math.abs(step.size()) >= tried && (crossed || !inaccurate);
      step.reduce(again ? UNSOLVED_REDUCTION : 1, progress.time());
      return;
    }
    followOscillation();
    double factor = inaccurate ? control.reject(differences, norm) : UNSOLVED_REDUCTION;
    step.reduce(factor, progress.time());
    if (inaccurate && jumps.derivativeJumped(step.size())) {
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

  /** Returns the norm that errors are judged by. */
  MaximumNorm norm() {
    return norm;
  }

  /** Returns the relative tolerance of that norm. */
  double relativeTolerance() {
    return relativeTolerance;
  }

  /** Returns the end of the problem. */
  double end() {
    return tEnd;
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
    jumps.transfer(state);
    search.transfer(state);
    slide.transfer(state);
    triedTime = state.number(triedTime);
    step.transfer(state);
    if (state.restoring()) {
      norm.allow(1);
      norm.weigh(differences.state());
    }
  }
}
