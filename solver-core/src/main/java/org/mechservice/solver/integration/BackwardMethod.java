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
  private final StepsToEnd bounds = new StepsToEnd();
  private final BackwardOrderControl control;
  private final JumpWatch jumps = new JumpWatch();

  /** Relative tolerance of the norm. */
  private double relativeTolerance;

  private StepEquations equations = StepEquations.none();
  private BackwardDifferences differences = new BackwardDifferences(0);
  private FirstStep firstStep = new FirstStep(0);

  /** Size and end of the step being tried; size 0 as long as the first is not chosen. */
  private double h;

  private double triedTime;

  /** End of the problem. */
  private double tEnd;

  /** First step asked for; 0 for the method's choice. */
  private double initialStep;

  private double longestFirstStep;

  /** Whether the problem went on from another state, or across a declared jump. */
  private boolean restarted;

  /** Whether state and derivative of a start are still to be completed. */
  private boolean startDue;

  /** Whether a step is begun. */
  private boolean begun;

  /** Size and order that the differences are written for. */
  private double writtenSize;

  private int writtenOrder;

  /**
   * @throws IllegalArgumentException if a setting is out of range
   */
  BackwardMethod(IntegratorSettings settings, Progress progress, BackwardFormulas formulas) {
    super(settings, progress);
    this.formulas = formulas;
    mode = settings.mode();
    control = new BackwardOrderControl(formulas, mode == Mode.TUNED);
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
    return new ExplicitEquations(rightHandSide, smallSizes(system.dimension()));
  }

  /** Begins a problem. */
  final StepResult begin(StepEquations equations, double t0, double[] y0, double tEnd) {
    prepare(equations, t0, tEnd);
    beginProgress(t0);
    restarted = false;
    return beginAt(t0, y0, settings.initialStep());
  }

  private void prepare(StepEquations equations, double t0, double tEnd) {
    int n = equations.manifold().dimension();
    this.equations = equations;
    if (mode == Mode.TUNED) {
      equations.follow(equations.sparingRules());
    }
    this.tEnd = tEnd;
    differences = new BackwardDifferences(n);
    firstStep = new FirstStep(n);
    relativeTolerance = settings.relativeTolerance();
    double[] absoluteTolerances = settings.absoluteTolerances(n);
    boolean standard = mode != Mode.FAITHFUL && toleranceFactor == 1;
    if (standard && equations.manifold().anyAlgebraic()) {
      tighten(absoluteTolerances);
    }
    norm.begin(relativeTolerance, absoluteTolerances, equations.manifold());
    bounds.begin(t0, tEnd, settings.maxStep());
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
    this.longestFirstStep = longestFirstStep;
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
    restarted = false;
    return beginAt(t, y, 0);
  }

  /** Returns how fast the solution can change, by the Jacobian formed last. */
  final double fastestRate() {
    return equations.fastestRate(norm);
  }

  private StepResult beginAnew(double t, double[] y) {
    progress.beginAgain(t);
    restarted = true;
    return beginAt(t, y, 0);
  }

  /** Begins at order 1, with a step of the given size or, if that is 0, of the method's choice. */
  private StepResult beginAt(double t, double[] y, double initialStep) {
    control.begin(settings.highestOrder(BackwardFormulas.HIGHEST_ORDER), restarted);
    jumps.begin();
    bounds.stopAt(equations.breakpoints().next());
    this.initialStep = initialStep;
    longestFirstStep = Double.POSITIVE_INFINITY;
    h = 0;
    triedTime = t;
    begun = false;
    writtenSize = 1;
    writtenOrder = 1;
    differences.begin(y);
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
        ? progress.goOn(bounds.reachedAt(t))
        : fail(equations.causeAtStart(attempt), equations.componentAtStart(attempt));
  }

  private void tighten(double[] absoluteTolerances) {
    double smallest = IntegratorSettings.SMALLEST_RELATIVE_TOLERANCE;
    relativeTolerance = Math.max(ALGEBRAIC_PART * relativeTolerance, smallest);
    for (int l = 0; l < absoluteTolerances.length; l++) {
      absoluteTolerances[l] = Math.max(ALGEBRAIC_PART * absoluteTolerances[l], Double.MIN_NORMAL);
    }
  }

  /** Returns the size at which the absolute tolerance takes over from the relative one. */
  final double[] smallSizes(int dimension) {
    double[] sizes = settings.absoluteTolerances(dimension);
    for (int l = 0; l < sizes.length; l++) {
      double size = sizes[l] / settings.relativeTolerance();
      sizes[l] = Double.isFinite(size) ? size : sizes[l];
    }
    return sizes;
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
        return progress.goOn(bounds.reachedAt(progress.time()));
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
    Attempt attempt = equations.linearise(progress.time(), differences.state());
    if (attempt != Attempt.PASSED) {
      return attempt;
    }
    if (!begun && !beginStep()) {
      return Attempt.STOPPED;
    }
    writeDifferences();
    return equations.factor(hGamma());
  }

  /** Bounds the step, the first one being chosen before; returns false if told to stop instead. */
  private boolean beginStep() {
    if (h == 0 && !chooseFirstStep()) {
      return false;
    }
    h = bounded(h);
    control.beginStep();
    begun = true;
    return true;
  }

  /**
   * Returns the step to try instead of a proposed one. The smallest size grows with t; a step that
   * was at it and was accepted keeps its size, lest it change at every step and never be outgrown.
   */
  private double bounded(double proposed) {
    double t = progress.time();
    double size = bounds.bounded(t, proposed);
    boolean raised = Math.abs(size) == bounds.smallest(t);
    return raised && proposed == writtenSize ? proposed : size;
  }

  private boolean chooseFirstStep() {
    double t0 = progress.time();
    double longest = bounds.bounded(t0, Math.copySign(Double.MAX_VALUE, tEnd - t0));
    double size = initialStep;
    if (size == 0) {
      double smallest = bounds.smallest(t0);
      double passing =
          firstStep.size(
              equations,
              t0,
              differences.state(),
              differences.slope(),
              norm,
              longest,
              smallest,
              relativeTolerance);
      double usual = equations.cautious(passing, Math.abs(tEnd - t0));
      double chosen = restarted ? firstStep.afterRestart(usual, differences.slope(), norm) : usual;
      double first = Math.min(longestFirstStep, chosen);
      size = passing == 0 ? 0 : Math.max(smallest, first);
    }
    h = Math.copySign(size, longest);
    return size > 0;
  }

  /** Rewrites the differences if size or order has changed. */
  private void writeDifferences() {
    int k = control.order();
    if (h == writtenSize && k == writtenOrder) {
      return;
    }
    differences.rescale(h / writtenSize, k);
    writtenSize = h;
    writtenOrder = k;
    control.rescaled();
    equations.changeStep();
  }

  private double hGamma() {
    return h / formulas.leading(control.order());
  }

  /** Predicts and iterates. */
  private Attempt solve() {
    if (!equations.begun()) {
      triedTime = bounds.endOf(progress.time(), h);
      differences.predict(control.order(), formulas);
      norm.weigh(differences.state(), differences.predicted);
      equations.begin(differences, norm);
    }
    return equations.solve(triedTime, hGamma(), differences, norm);
  }

  private Attempt test() {
    control.estimate(differences, norm);
    if (control.error() <= 1) {
      return Attempt.PASSED;
    }
    jumps.failed(h, control.error());
    boolean jumped = equations.solutionMayJump() && jumps.solutionJumped(control.error());
    return jumped ? Attempt.PASSED : Attempt.TOO_INACCURATE;
  }

  private void accept() {
    int k = control.order();
    differences.accept(k);
    progress.accepted(h, triedTime, k, control.error());
    jumps.accepted(control.error());
    equations.moveOn(hGamma(), differences);
    h *= control.accept(differences, norm);
    if (control.error() > 1) {
      control.restart();
    }
    begun = false;
    equations.manifold().restoreUnitGroups(differences.state(), differences);
    if (equations.manifold().accepted(triedTime, differences.state())) {
      equations.demandNew();
    }
  }

  /**
   * Asks for a new Jacobian if that may help, else reduces the step; returns a cause if neither is
   * possible.
   */
  private Optional<Cause> repair(Attempt attempt) {
    boolean inaccurate = attempt == Attempt.TOO_INACCURATE;
    double error = inaccurate ? control.error() : Double.NaN;
    progress.rejected(h, control.order(), error, attempt, limitingComponent(attempt));
    if (progress.notFiniteTooOften()) {
      return Optional.of(Cause.NOT_FINITE);
    }
    if (!inaccurate && equations.renew(hGamma())) {
      return Optional.empty();
    }
    double smallest = bounds.smallest(progress.time());
    if (Math.abs(h) <= smallest) {
      return Optional.of(inaccurate ? Cause.STEP_TOO_SMALL : equations.cause(attempt));
    }
    double factor = inaccurate ? control.reject(differences, norm) : UNSOLVED_REDUCTION;
    h = Math.copySign(Math.max(factor * Math.abs(h), smallest), h);
    if (inaccurate && jumps.derivativeJumped(h)) {
      control.restart();
    }
    return Optional.empty();
  }

  private int limitingComponent(Attempt attempt) {
    return attempt == Attempt.TOO_INACCURATE
        ? norm.largest(differences.correction)
        : equations.limitingComponent(attempt, norm);
  }

  private StepResult fail(Cause cause, int component) {
    return progress.fail(cause, h, control.order(), component, norm);
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
    bounds.stopAt(equations.breakpoints().next());
    progress.transfer(state);
    differences.transfer(state);
    control.transfer(state);
    jumps.transfer(state);
    h = state.number(h);
    triedTime = state.number(triedTime);
    initialStep = state.number(initialStep);
    restarted = state.flag(restarted);
    longestFirstStep = state.number(longestFirstStep);
    writtenSize = state.number(writtenSize);
    writtenOrder = state.integer(writtenOrder);
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
