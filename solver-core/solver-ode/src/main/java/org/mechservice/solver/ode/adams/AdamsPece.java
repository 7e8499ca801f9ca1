package org.mechservice.solver.ode.adams;

import java.util.Optional;
import java.util.function.Supplier;
import org.mechservice.solver.ode.IntegrationFailure.Cause;
import org.mechservice.solver.ode.IntegrationStatistics;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.OdeSystem;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.StepPolynomial;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.TrialOutcome;
import org.mechservice.solver.ode.step.ErrorNorm;
import org.mechservice.solver.ode.step.IntegrationProgress;
import org.mechservice.solver.ode.step.Manifold;
import org.mechservice.solver.ode.step.RightHandSide;
import org.mechservice.solver.ode.step.StepBounds;
import org.mechservice.solver.ode.step.StepWatch;
import org.mechservice.solver.ode.step.SteppingIntegrator;

/**
 * Adams methods of variable order and step in PECE form: predict, evaluate, correct, evaluate. The
 * two programs built on it differ in norm, bounds and start.
 *
 * <p>{@link #step} tries a step of size h with the predictor of order k until the error test passes
 * and all values are finite, accepts it, and chooses k and h anew; {@link AdamsStep} tells how.
 */
abstract class AdamsPece extends SteppingIntegrator {
  private static final StepPolynomial KEPT = AdamsInterpolant::evaluateKept;

  private final ErrorNorm norm;
  private final StepBounds bounds;
  private final AdamsStep step;

  /**
   * @throws IllegalArgumentException if a setting is out of range
   */
  AdamsPece(
      IntegratorSettings settings,
      IntegrationProgress progress,
      ErrorNorm norm,
      StepBounds bounds) {
    super(settings, progress);
    this.norm = norm;
    this.bounds = bounds;
    step = new AdamsStep(progress, norm, bounds, this::firstStep, this.settings);
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
  public final void watch(Supplier<StepWatch> watches) {
    step.watch(watches.get());
  }

  @Override
  public final StepResult start(OdeSystem system, double t0, double[] y0, double tEnd) {
    IntegratorSettings.requireUsable(t0, tEnd, y0, system.dimension());
    double[] tolerances = settings.absoluteTolerances(y0.length);
    RightHandSide equations = new RightHandSide(system, settings.stop());
    begin(equations, t0, tEnd);
    Manifold manifold = weighed(system, tolerances);
    norm.weigh(y0);
    AdamsHistory history = new AdamsHistory(y0.length, compensates(step.roundOff(y0)));
    step.prepare(new AdamsProblem(equations, manifold, history, tEnd));
    step.stiffness().clear();
    return beginAt(t0, y0, settings.initialStep());
  }

  private void begin(RightHandSide equations, double t0, double tEnd) {
    equations.breakpoints().begin(equations.system(), t0, tEnd);
    bounds.begin(t0, tEnd, settings.maxStep());
    progress.begin(t0, equations.system().dimension(), settings.relativeTolerance());
  }

  /** Begins to weigh errors by what is known of the states of a problem. */
  private Manifold weighed(OdeSystem system, double[] tolerances) {
    Manifold manifold = new Manifold(system);
    norm.begin(settings.relativeTolerance(), tolerances, manifold);
    return manifold;
  }

  @Override
  public final StepResult restart(double t, double[] y, double longestFirstStep) {
    progress.requireInLastStep(t);
    IntegratorSettings.requireUsable(y, step.problem().dimension());
    if (equations().breakpoints().reachedAt(t)) {
      equations().breakpoints().pass();
    }
    StepResult result = beginAnew(t, y);
    step.boundFirst(longestFirstStep);
    return result;
  }

  @Override
  public final StepResult takeOver(double t, double[] y) {
    equations().breakpoints().passUpTo(t);
    return beginAnew(t, y);
  }

  /** Returns whether stability, not accuracy, has limited the latest steps. */
  public final boolean atStabilityLimit() {
    return step.stiffness().nowAtStabilityLimit();
  }

  /** Returns whether it did in some of them at least. */
  public final boolean nearStabilityLimit() {
    return step.stiffness().nearStabilityLimit();
  }

  /**
   * Returns how many times longer the latest step was than 1 / L, L the rate at which f changes.
   */
  public final double rateTimesStep() {
    return step.stiffness().latestProduct();
  }

  /**
   * Returns for how many steps a motion that is hardly damped has been followed at the edge of
   * stability.
   */
  public final long stepsAtEdge() {
    return step.stiffness().stepsAtEdge();
  }

  /** Returns the size of that motion at the first of them over the error allowed, at most. */
  public final double sizeAtEdge() {
    return step.stiffness().sizeAtEdge();
  }

  /** Returns the state reached; not to be modified. */
  public final double[] state() {
    return history().state();
  }

  /** Returns the norm that errors are judged by. */
  public final ErrorNorm norm() {
    return norm;
  }

  /**
   * Predicts the first step after a start and evaluates f there; {@link #step} goes on from that.
   * Returns false if told to stop instead.
   */
  public final boolean foresee() {
    return step.foresee();
  }

  /** Returns whether a first step is foreseen. */
  public final boolean foreseen() {
    return step.foreseen();
  }

  /** Returns the size of the step foreseen, signed. */
  public final double foreseenStep() {
    return step.size();
  }

  /** Gives a step up that was foreseen. */
  public final void abandonStep() {
    step.abandon();
  }

  /**
   * Returns by how much f at the prediction differed from its extrapolation: the direction of the
   * fastest motion where stability is near; not to be modified.
   */
  public final double[] discrepancy() {
    return history().discrepancy;
  }

  /** Returns f at the state reached; not to be modified. */
  public final double[] slope() {
    return history().difference(1);
  }

  /** Returns whether a watch sees something steep ahead that an implicit method copes with. */
  public final boolean steepAhead() {
    return step.steepAhead();
  }

  private StepResult beginAnew(double t, double[] y) {
    step.beginAgain();
    progress.beginAgain(t);
    return beginAt(t, y, 0);
  }

  /** Begins at order 1, with a step of the given size or, if that is 0, of the method's choice. */
  private StepResult beginAt(double t, double[] y, double initialStep) {
    TrialOutcome start = step.beginAt(t, y, initialStep);
    return start == TrialOutcome.PASSED
        ? progress.goOn(step.atEnd())
        : step.fail(start.cause(), step.limitingComponent(start));
  }

  private RightHandSide equations() {
    return step.problem().equations();
  }

  private AdamsHistory history() {
    return step.problem().history();
  }

  @Override
  public final StepResult step() {
    progress.requireRunning();
    if (equations().breakpoints().reachedAt(progress.time())) {
      StepResult result = passBreakpoint();
      if (result != StepResult.ADVANCED) {
        return result;
      }
    }
    step.begin();
    if (step.roundOff(state()) > 0.5) {
      return step.fail(Cause.TOLERANCE_TOO_TIGHT, norm.largest(state()));
    }
    return advance();
  }

  /** Begins anew on the other side of a jump. */
  private StepResult passBreakpoint() {
    if (equations().stopped()) {
      return StepResult.STOPPED;
    }
    equations().breakpoints().pass();
    return beginAnew(progress.time(), state());
  }

  /** Tries steps until one is accepted. */
  private StepResult advance() {
    while (progress.mayTry(settings.maxSteps(), step.problem().end())) {
      TrialOutcome attempt = step.attempt();
      if (attempt == TrialOutcome.STOPPED) {
        return StepResult.STOPPED;
      }
      if (attempt == TrialOutcome.PASSED) {
        int pole = step.componentWithPole();
        if (pole >= 0) {
          return step.fail(Cause.UNBOUNDED, pole);
        }
        if (step.cutShort()) {
          continue;
        }
        step.accept();
        return step.slides()
            ? step.fail(Cause.STEP_TOO_SMALL, norm.largest(discrepancy()))
            : progress.goOn(step.atEnd());
      }
      Optional<Cause> cause = step.repair(attempt);
      if (cause.isPresent()) {
        return step.fail(cause.get(), step.limitingComponent(attempt));
      }
    }
    return step.fail(Cause.TOO_MANY_STEPS, norm.largest(discrepancy()));
  }

  @Override
  public final double time() {
    return bounds.inProblem(progress.time());
  }

  @Override
  public final void interpolate(double t, double[] y, double[] yDot) {
    progress.requireInLastStep(t);
    step.interpolate(t, y, yDot);
  }

  @Override
  public final int keptLength() {
    return AdamsInterpolant.keptLength(progress.order(), step.problem().dimension());
  }

  @Override
  public final StepPolynomial keepStep(double[] kept, int from) {
    progress.requireStep();
    AdamsInterpolant.keep(progress.time(), progress.order(), step.psi(), history(), kept, from);
    return KEPT;
  }

  @Override
  public final byte[] save() {
    progress.requireBetweenSteps(step.begun());
    return SavedState.save(state -> transfer(state, equations()));
  }

  @Override
  public final StepResult resume(OdeSystem system, byte[] saved) {
    RightHandSide equations = new RightHandSide(system, settings.stop());
    SavedState.restore(saved, state -> transfer(state, equations));
    return progress.result();
  }

  /** Carries the integration between two steps over. */
  private void transfer(SavedState state, RightHandSide equations) {
    state.require("method", getClass().getSimpleName());
    settings.transfer(state);
    step.requireWatch(state);
    int n = equations.system().dimension();
    state.require("number of unknowns", n);
    double t0 = state.number(progress.start());
    double end = state.number(step.problem().end());
    boolean compensated = state.flag(history().compensated());
    if (state.restoring()) {
      begin(equations, t0, end);
    }
    equations.transfer(state);
    if (state.restoring()) {
      AdamsHistory history = new AdamsHistory(n, compensated);
      Manifold manifold = weighed(equations.system(), settings.absoluteTolerances(n));
      step.prepare(new AdamsProblem(equations, manifold, history, end));
    }
    step.transfer(state);
  }

  @Override
  public final long evaluations() {
    return equations().evaluations();
  }

  @Override
  public final IntegrationStatistics statistics() {
    return new IntegrationStatistics(
        progress.steps(),
        progress.rejectedSteps(),
        equations().evaluations(),
        0,
        0,
        0,
        step.stiffness().suspectsStiffness(),
        toleranceFactor,
        progress.limits());
  }
}
