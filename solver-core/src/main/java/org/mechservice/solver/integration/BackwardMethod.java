package org.mechservice.solver.integration;

import java.util.Optional;
import org.mechservice.solver.integration.IntegrationFailure.Cause;
import org.mechservice.solver.integration.IntegratorSettings.Mode;

/**
 * Numerical or backward differentiation formulas of variable order and step. What the programs
 * built on it differ in is the form of the equations they are given and the care with which they
 * start.
 *
 * <p>One step is told by {@link #step}: it tries a step of size h and order k until the iteration
 * converges and the error test passes, accepts it, and chooses k and h anew.
 */
abstract class BackwardMethod extends SteppingIntegrator {
  /** Reduction of a step whose iteration did not converge although the derivatives were new. */
  private static final double UNSOLVED_REDUCTION = 0.3;

  /** Part of the tolerances for systems with algebraic components. */
  private static final double ALGEBRAIC_PART = 1.0 / 3;

  private final BackwardFormulas formulas;
  private final Mode mode;
  private final MaximumNorm norm = new MaximumNorm();
  private final ErrorAllowance allowance;
  private final StepSize step = new StepSize();
  private final BackwardOrderControl control;
  private final JumpWatch jumps = new JumpWatch();
  private final JumpSearch search = new JumpSearch();

  /** Relative tolerance of the norm. */
  private double relativeTolerance;

  private StepEquations equations = StepEquations.none();
  private BackwardDifferences differences = new BackwardDifferences(0);

  /** End of the step being tried. */
  private double triedTime;

  /** End of the problem. */
  private double tEnd;

  /** Whether state and derivative of a start are still to be completed. */
  private boolean startDue;

  /** Whether a step is begun. */
  private boolean begun;

  /**
   * @param progress shared if the method takes turns with another
   * @param takesTurns whether another takes the steps in which nothing is stiff
   * @throws IllegalArgumentException if a setting is out of range
   */
  BackwardMethod(
      IntegratorSettings settings,
      Progress progress,
      BackwardFormulas formulas,
      boolean takesTurns) {
    super(settings, progress);
    this.formulas = formulas;
    mode = settings.mode();
    boolean turns = takesTurns && mode != Mode.FAITHFUL;
    allowance = turns ? ErrorAllowance.full() : ErrorAllowance.of(mode);
    control = new BackwardOrderControl(formulas, mode == Mode.TUNED || turns);
  }

  /**
   * {@inheritDoc}
   *
   * @throws IllegalArgumentException also if the problem's band is wider than its matrix
   */
  @Override
  public final StepResult start(OdeSystem system, double t0, double[] y0, double tEnd) {
    IntegratorSettings.requireUsable(t0, tEnd, y0, system.dimension());
    return begin(explicit(system, t0, tEnd), t0, y0, tEnd);
  }

  private StepEquations explicit(OdeSystem system, double t0, double tEnd) {
    RightHandSide rightHandSide = new RightHandSide(system, settings.stop());
    rightHandSide.breakpoints().begin(system, t0, tEnd);
    return new ExplicitEquations(rightHandSide, settings.smallSizes(system.dimension()));
  }

  /** Begins a problem. */
  final StepResult begin(StepEquations equations, double t0, double[] y0, double tEnd) {
    prepare(equations, t0, tEnd);
    beginProgress(t0);
    return beginAt(t0, y0, settings.initialStep(), false);
  }

  private void prepare(StepEquations equations, double t0, double tEnd) {
    int n = equations.manifold().dimension();
    this.equations = equations;
    equations.follow(mode);
    this.tEnd = tEnd;
    differences = new BackwardDifferences(n);
    boolean standard = mode != Mode.FAITHFUL && toleranceFactor == 1;
    boolean tighter = standard && equations.manifold().anyAlgebraic();
    IntegratorSettings tested = tighter ? settings.tightened(ALGEBRAIC_PART) : settings;
    relativeTolerance = tested.relativeTolerance();
    norm.begin(relativeTolerance, tested.absoluteTolerances(n), equations.manifold());
    allowance.begin(relativeTolerance, toleranceFactor);
    step.begin(n, t0, tEnd, settings.maxStep());
  }

  private void beginProgress(double t0) {
    progress.begin(t0, equations.manifold().dimension(), settings.relativeTolerance());
  }

  @Override
  public final StepResult restart(double t, double[] y, double longestFirstStep) {
    progress.requireInLastStep(t);
    IntegratorSettings.requireUsable(y, differences.state().length);
    if (equations.breakpoints().reachedAt(t)) {
      equations.breakpoints().pass();
    }
    StepResult result = beginAnew(t, y);
    step.boundFirst(longestFirstStep);
    return result;
  }

  /** Takes a problem over that another method has begun. */
  final StepResult takeOver(OdeSystem system, double t, double[] y, double tEnd) {
    double t0 = progress.start();
    prepare(explicit(system, t0, tEnd), t0, tEnd);
    return takeOver(t, y);
  }

  @Override
  final StepResult takeOver(double t, double[] y) {
    equations.breakpoints().passUpTo(t);
    progress.beginAgain(t);
    return beginAt(t, y, 0, false);
  }

  /** Returns how fast the solution can change, by the Jacobian formed last. */
  final double fastestRate() {
    return equations.fastestRate(norm);
  }

  private StepResult beginAnew(double t, double[] y) {
    progress.beginAgain(t);
    return beginAt(t, y, 0, true);
  }

  /** Begins at order 1, with a step of the given size or, if that is 0, of the method's choice. */
  private StepResult beginAt(double t, double[] y, double initialStep, boolean restarted) {
    control.begin(settings.highestOrder(BackwardFormulas.HIGHEST_ORDER), restarted);
    jumps.begin();
    search.clear();
    step.beginAt(initialStep, restarted);
    step.stopAt(equations.breakpoints().next());
    triedTime = t;
    begun = false;
    differences.begin(y);
    norm.allow(1);
    norm.weigh(differences.state());
    equations.beginAnew();
    startDue = true;
    return findStart();
  }

  /** Completes state and derivative of a start. */
  private StepResult findStart() {
    double t = progress.time();
    Attempt attempt = equations.findStart(t, differences.state(), differences.slope());
    if (attempt == Attempt.STOPPED) {
      progress.goOn(false);
      return StepResult.STOPPED;
    }
    startDue = false;
    norm.weigh(differences.state());
    return attempt == Attempt.PASSED
        ? progress.goOn(step.endsAt(t))
        : fail(equations.causeAtStart(attempt), equations.componentAtStart(attempt));
  }

  /** Returns the norm that errors are judged by. */
  final ErrorNorm norm() {
    return norm;
  }

  @Override
  public final StepResult step() {
    progress.requireRunning();
    StepResult result = startDue ? findStart() : StepResult.ADVANCED;
    if (result == StepResult.ADVANCED && equations.breakpoints().reachedAt(progress.time())) {
      result = passBreakpoint();
    }
    return result == StepResult.ADVANCED ? advance() : result;
  }

  /** Begins anew on the other side of a jump. */
  private StepResult passBreakpoint() {
    if (equations.stopped()) {
      return StepResult.STOPPED;
    }
    equations.breakpoints().pass();
    return beginAnew(progress.time(), differences.state());
  }

  /** Tries steps until one is accepted. */
  private StepResult advance() {
    while (progress.tries() < settings.maxSteps()) {
      Attempt attempt = tryStep();
      if (attempt == Attempt.STOPPED) {
        return StepResult.STOPPED;
      }
      if (attempt == Attempt.PASSED) {
        accept();
        return progress.goOn(step.endsAt(progress.time()));
      }
      Optional<Cause> cause = repair(attempt);
      if (cause.isPresent()) {
        return fail(cause.get(), limitingComponent(attempt));
      }
    }
    return fail(Cause.TOO_MANY_STEPS, norm.largest(differences.correction));
  }

  /** Linearise, solve, test; what was stopped is taken up where it stood. */
  private Attempt tryStep() {
    Attempt attempt = linearise();
    if (attempt == Attempt.PASSED) {
      attempt = solve();
    }
    return attempt == Attempt.PASSED ? test() : attempt;
  }

  /** Brings Jacobian, size, differences and factors to those of the step being tried. */
  private Attempt linearise() {
    Attempt attempt =
        step.chosen() && equations.looksAhead()
            ? lineariseAhead()
            : equations.linearise(progress.time(), differences.state(), hGamma());
    if (attempt != Attempt.PASSED) {
      return attempt;
    }
    return placeStep() ? equations.factor(hGamma()) : Attempt.STOPPED;
  }

  /** Forms derivatives at the prediction if new ones are wanted. */
  private Attempt lineariseAhead() {
    if (equations.begun()) {
      return Attempt.PASSED;
    }
    placeStep();
    double end = step.endOf(progress.time());
    if (!equations.wantsAhead(end)) {
      return Attempt.PASSED;
    }
    differences.predict(control.order(), formulas);
    return equations.lineariseAhead(end, hGamma(), differences);
  }

  /** Brings size and differences to those of the step; returns false if told to stop instead. */
  private boolean placeStep() {
    if (!begun && !beginStep()) {
      return false;
    }
    if (step.write(differences, control.order())) {
      control.rescaled();
      equations.changeStep();
    }
    return true;
  }

  /** Bounds the step, the first one being chosen before; returns false if told to stop instead. */
  private boolean beginStep() {
    if (!step.prepare(
        progress.time(), equations, differences, norm, relativeTolerance, allowance)) {
      return false;
    }
    control.beginStep();
    begun = true;
    return true;
  }

  private double hGamma() {
    return step.size() / formulas.leading(control.order());
  }

  /** Predicts and iterates. */
  private Attempt solve() {
    if (!equations.begun()) {
      norm.allow(allowance.part(step.size(), equations));
      triedTime = step.endOf(progress.time());
      differences.predict(control.order(), formulas);
      norm.weigh(differences.state(), differences.predicted);
      equations.begin(triedTime, differences, control.order(), norm);
    }
    return equations.solve(triedTime, hGamma(), differences, norm);
  }

  private Attempt test() {
    control.estimate(differences, norm);
    if (control.error() <= 1) {
      return search.inside(step.size(), discrepancy()) ? Attempt.TOO_INACCURATE : Attempt.PASSED;
    }
    jumps.failed(step.size(), control.error());
    boolean jumped = equations.solutionMayJump() && jumps.solutionJumped(control.error());
    return jumped ? Attempt.PASSED : Attempt.TOO_INACCURATE;
  }

  /** Returns the norm of what y' differs by from its prediction. */
  private double discrepancy() {
    return norm.of(differences.correction) / Math.abs(hGamma());
  }

  private void accept() {
    int k = control.order();
    double size = step.size();
    double error = control.error();
    differences.accept(k);
    progress.accepted(step.size(), triedTime, k, control.error());
    jumps.accepted(control.error());
    equations.moveOn(hGamma(), differences);
    step.propose(control.accept(differences, norm));
    boolean jumpPassed = search.accepted(size, triedTime, error);
    if (error > 1 || jumpPassed) {
      control.restart();
    }
    if (search.active()) {
      towardsJump();
    }
    begun = false;
    equations.manifold().restoreUnitGroups(differences.state(), differences);
    if (equations.manifold().accepted(triedTime, differences.state())) {
      equations.demandNew();
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
  private Optional<Cause> repair(Attempt attempt) {
    boolean inaccurate = attempt == Attempt.TOO_INACCURATE;
    double error = inaccurate ? control.error() : Double.NaN;
    progress.rejected(step.size(), control.order(), error, attempt, limitingComponent(attempt));
    if (progress.notFiniteTooOften()) {
      return Optional.of(Cause.NOT_FINITE);
    }
    if (!inaccurate && equations.renew(hGamma())) {
      return Optional.empty();
    }
    if (!step.canBeReduced(progress.time())) {
      return Optional.of(equations.cause(attempt, tEnd - progress.start(), norm));
    }
    reduce(inaccurate);
    return Optional.empty();
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
    double factor = inaccurate ? control.reject(differences, norm) : UNSOLVED_REDUCTION;
    step.reduce(factor, progress.time());
    if (inaccurate && jumps.derivativeJumped(step.size())) {
      control.restart();
    }
  }

  private int limitingComponent(Attempt attempt) {
    return attempt == Attempt.TOO_INACCURATE
        ? norm.largest(differences.correction)
        : equations.limitingComponent(attempt, norm);
  }

  private StepResult fail(Cause cause, int component) {
    return progress.fail(cause, step.size(), control.order(), component, norm);
  }

  @Override
  public final void interpolate(double t, double[] y, double[] yDot) {
    progress.requireInLastStep(t);
    boolean atStart = progress.order() == 0;
    double size = atStart ? 1 : progress.stepSize();
    int k = atStart ? 1 : progress.order();
    BackwardInterpolant.evaluate((t - progress.time()) / size, size, k, differences, y, yDot);
  }

  @Override
  public final byte[] save() {
    progress.requireBetweenSteps(begun || startDue);
    return StateTransfer.save(state -> transfer(state, (t0, tEnd) -> equations));
  }

  @Override
  public final StepResult resume(OdeSystem system, byte[] saved) {
    return resume(saved, (t0, tEnd) -> explicit(system, t0, tEnd));
  }

  /** Goes on with an integration that was saved. */
  final StepResult resume(byte[] saved, Problem problem) {
    StateTransfer.restore(saved, state -> transfer(state, problem));
    return progress.result();
  }

  /** Carries the integration between two steps over. */
  private void transfer(StateTransfer state, Problem problem) {
    state.require("method", getClass().getSimpleName());
    settings.transfer(state);
    state.require("family of formulas", formulas == BackwardFormulas.BDF ? "BDF" : "NDF");
    double t0 = state.number(progress.start());
    double end = state.number(tEnd);
    StepEquations posed = problem.equations(t0, end);
    int n = posed.manifold().dimension();
    state.require("number of unknowns", n);
    if (state.restoring()) {
      prepare(posed, t0, end);
      beginProgress(t0);
      control.begin(settings.highestOrder(BackwardFormulas.HIGHEST_ORDER), false);
      startDue = false;
      begun = false;
    }
    equations.transfer(state);
    step.stopAt(equations.breakpoints().next());
    progress.transfer(state);
    differences.transfer(state);
    control.transfer(state);
    jumps.transfer(state);
    search.transfer(state);
    triedTime = state.number(triedTime);
    step.transfer(state);
  }

  /** A problem given anew, of which nothing is known yet. */
  interface Problem {
    /** Returns its equations for an interval. */
    StepEquations equations(double t0, double tEnd);
  }

  @Override
  final long evaluations() {
    return equations.evaluations();
  }

  @Override
  public final IntegrationStatistics statistics() {
    double part = relativeTolerance / settings.relativeTolerance();
    return equations.statistics(progress, toleranceFactor * part);
  }
}
