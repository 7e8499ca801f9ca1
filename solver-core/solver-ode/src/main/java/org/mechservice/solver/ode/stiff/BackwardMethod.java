package org.mechservice.solver.ode.stiff;

import java.util.Optional;
import java.util.function.Supplier;
import org.mechservice.solver.ode.IntegrationFailure.Cause;
import org.mechservice.solver.ode.IntegrationStatistics;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.IntegratorSettings.Mode;
import org.mechservice.solver.ode.OdeSystem;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.StepPolynomial;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.TrialOutcome;
import org.mechservice.solver.ode.backward.BackwardFormulas;
import org.mechservice.solver.ode.backward.BackwardInterpolant;
import org.mechservice.solver.ode.newton.ExplicitEquations;
import org.mechservice.solver.ode.newton.StepEquations;
import org.mechservice.solver.ode.step.ErrorNorm;
import org.mechservice.solver.ode.step.IntegrationProgress;
import org.mechservice.solver.ode.step.RightHandSide;
import org.mechservice.solver.ode.step.StepWatch;
import org.mechservice.solver.ode.step.SteppingIntegrator;

/**
 * Numerical or backward differentiation formulas of variable order and step. What the programs
 * built on it differ in is the form of the equations they are given and the care with which they
 * start.
 *
 * <p>{@link #step} tries a step of size h and order k until the iteration converges and the error
 * test passes, accepts it, and chooses k and h anew; {@link BackwardStep} tells how.
 */
abstract class BackwardMethod extends SteppingIntegrator {
  /** Part of the tolerances for systems with algebraic components. */
  private static final double ALGEBRAIC_PART = 1.0 / 3;

  private static final StepPolynomial KEPT = BackwardInterpolant::evaluateKept;

  private final BackwardFormulas formulas;
  private final BackwardStep step;

  /** Whether state and derivative of a start are still to be completed. */
  private boolean startDue;

  /**
   * @param progress shared if the method takes turns with another
   * @param takesTurns whether another takes the steps in which nothing is stiff
   * @throws IllegalArgumentException if a setting is out of range
   */
  BackwardMethod(
      IntegratorSettings settings,
      IntegrationProgress progress,
      BackwardFormulas formulas,
      boolean takesTurns) {
    super(settings, progress);
    this.formulas = formulas;
    Mode mode = settings.mode();
    step = new BackwardStep(progress, formulas, mode, takesTurns && mode != Mode.FAITHFUL);
  }

  @Override
  public final void watch(Supplier<StepWatch> watches) {
    step.watch(watches.get());
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
    // Other pivots round otherwise than those of the programs published.
    boolean condensing = settings.mode() != Mode.FAITHFUL;
    double[] smallSizes = settings.smallSizes(system.dimension());
    return new ExplicitEquations(rightHandSide, smallSizes, condensing);
  }

  /** Begins a problem. */
  final StepResult begin(StepEquations equations, double t0, double[] y0, double tEnd) {
    prepare(equations, t0, tEnd);
    beginProgress(t0);
    return beginAt(t0, y0, settings.initialStep(), false);
  }

  private void prepare(StepEquations equations, double t0, double tEnd) {
    boolean standard = settings.mode() != Mode.FAITHFUL && toleranceFactor == 1;
    boolean tighter = standard && equations.manifold().anyAlgebraic();
    IntegratorSettings tested = tighter ? settings.tightened(ALGEBRAIC_PART) : settings;
    step.prepare(equations, t0, tEnd, tested, toleranceFactor);
  }

  private void beginProgress(double t0) {
    progress.begin(t0, equations().manifold().dimension(), settings.relativeTolerance());
  }

  @Override
  public final StepResult restart(double t, double[] y, double longestFirstStep) {
    progress.requireInLastStep(t);
    IntegratorSettings.requireUsable(y, equations().manifold().dimension());
    if (equations().breakpoints().reachedAt(t)) {
      equations().breakpoints().pass();
    }
    equations().stateChanged();
    StepResult result = beginAnew(t, y);
    step.boundFirst(longestFirstStep);
    return result;
  }

  /** Takes a problem over that another method has begun. */
  public final StepResult takeOver(OdeSystem system, double t, double[] y, double tEnd) {
    double t0 = progress.start();
    prepare(explicit(system, t0, tEnd), t0, tEnd);
    return takeOver(t, y);
  }

  @Override
  public final StepResult takeOver(double t, double[] y) {
    equations().breakpoints().passUpTo(t);
    progress.beginAgain(t);
    return beginAt(t, y, 0, false);
  }

  /** Returns the rate of the fastest motion, by the Jacobian formed last. */
  public final double fastestRate() {
    double estimate = equations().fastestMotion();
    boolean known = estimate > 0 && Double.isFinite(estimate);
    return known ? estimate : equations().derivatives().fastestRate(step.norm());
  }

  /** Returns how many matrices were factored. */
  public final long factorisations() {
    return equations().factors().factorisations();
  }

  private StepResult beginAnew(double t, double[] y) {
    progress.beginAgain(t);
    return beginAt(t, y, 0, true);
  }

  /** Begins at order 1, with a step of the given size or, if that is 0, of the method's choice. */
  private StepResult beginAt(double t, double[] y, double initialStep, boolean restarted) {
    step.beginAt(t, y, highestOrder(), initialStep, restarted);
    startDue = true;
    return findStart();
  }

  private int highestOrder() {
    return settings.highestOrder(BackwardFormulas.HIGHEST_ORDER);
  }

  /** Completes state and derivative of a start. */
  private StepResult findStart() {
    TrialOutcome attempt = step.findStart(progress.time());
    if (attempt == TrialOutcome.STOPPED) {
      progress.goOn(false);
      return StepResult.STOPPED;
    }
    startDue = false;
    return attempt == TrialOutcome.PASSED
        ? progress.goOn(step.atEnd())
        : step.fail(equations().causeAtStart(attempt), equations().componentAtStart(attempt));
  }

  /** Returns the norm that errors are judged by. */
  final ErrorNorm norm() {
    return step.norm();
  }

  private StepEquations equations() {
    return step.equations();
  }

  @Override
  public final StepResult step() {
    progress.requireRunning();
    StepResult result = startDue ? findStart() : StepResult.ADVANCED;
    if (result == StepResult.ADVANCED && equations().breakpoints().reachedAt(progress.time())) {
      result = passBreakpoint();
    }
    return result == StepResult.ADVANCED ? advance() : result;
  }

  /** Begins anew on the other side of a jump. */
  private StepResult passBreakpoint() {
    if (equations().stopped()) {
      return StepResult.STOPPED;
    }
    equations().breakpoints().pass();
    return beginAnew(progress.time(), step.differences().state());
  }

  /** Tries steps until one is accepted. */
  private StepResult advance() {
    while (progress.mayTry(settings.maxSteps(), step.problemEnd())) {
      TrialOutcome attempt = step.attempt();
      if (attempt == TrialOutcome.STOPPED) {
        return StepResult.STOPPED;
      }
      if (attempt == TrialOutcome.PASSED && step.cutShort()) {
        continue;
      }
      if (attempt == TrialOutcome.PASSED) {
        step.accept();
        return progress.goOn(step.atEnd());
      }
      Optional<Cause> cause = step.repair(attempt);
      if (cause.isPresent()) {
        return step.fail(cause.get(), step.limitingComponent(attempt));
      }
    }
    return step.fail(Cause.TOO_MANY_STEPS, step.limitingComponent(TrialOutcome.TOO_INACCURATE));
  }

  @Override
  public final void interpolate(double t, double[] y, double[] yDot) {
    progress.requireInLastStep(t);
    boolean atStart = progress.order() == 0;
    double size = atStart ? 1 : progress.stepSize();
    int k = atStart ? 1 : progress.order();
    double place = (t - progress.time()) / size;
    BackwardInterpolant.evaluate(place, size, k, step.differences(), y, yDot);
  }

  @Override
  public final int keptLength() {
    return BackwardInterpolant.keptLength(progress.order(), equations().manifold().dimension());
  }

  @Override
  public final StepPolynomial keepStep(double[] kept, int from) {
    progress.requireStep();
    BackwardInterpolant.keep(
        progress.time(), progress.stepSize(), progress.order(), step.differences(), kept, from);
    return KEPT;
  }

  @Override
  public final byte[] save() {
    progress.requireBetweenSteps(step.begun() || startDue);
    return SavedState.save(state -> transfer(state, (t0, tEnd) -> equations()));
  }

  @Override
  public final StepResult resume(OdeSystem system, byte[] saved) {
    return resume(saved, (t0, tEnd) -> explicit(system, t0, tEnd));
  }

  /** Goes on with an integration that was saved. */
  final StepResult resume(byte[] saved, Problem problem) {
    SavedState.restore(saved, state -> transfer(state, problem));
    return progress.result();
  }

  /** Carries the integration between two steps over. */
  private void transfer(SavedState state, Problem problem) {
    state.require("method", getClass().getSimpleName());
    settings.transfer(state);
    step.requireWatch(state);
    state.require("family of formulas", formulas == BackwardFormulas.BDF ? "BDF" : "NDF");
    double t0 = state.number(progress.start());
    double end = state.number(step.problemEnd());
    StepEquations posed = problem.equations(t0, end);
    state.require("number of unknowns", posed.manifold().dimension());
    if (state.restoring()) {
      prepare(posed, t0, end);
      beginProgress(t0);
      startDue = false;
    }
    step.transfer(state, highestOrder());
  }

  /** A problem given anew, of which nothing is known yet. */
  interface Problem {
    /** Returns its equations for an interval. */
    StepEquations equations(double t0, double tEnd);
  }

  @Override
  public final long evaluations() {
    return equations().evaluations();
  }

  @Override
  public final IntegrationStatistics statistics() {
    double part = step.relativeTolerance() / settings.relativeTolerance();
    return new IntegrationStatistics(
        progress.steps(),
        progress.rejectedSteps(),
        evaluations(),
        equations().derivatives().formations(),
        equations().factors().factorisations(),
        equations().factors().solutions(),
        false,
        toleranceFactor * part,
        progress.limits());
  }
}
