package org.mechservice.solver.ode.adams;

import java.util.Optional;
import org.mechservice.solver.ode.IntegrationFailure.Cause;
import org.mechservice.solver.ode.IntegrationStatistics;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.IntegratorSettings.Mode;
import org.mechservice.solver.ode.OdeSystem;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.StepPolynomial;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.TrialOutcome;
import org.mechservice.solver.ode.jumps.ChatterMonitor;
import org.mechservice.solver.ode.jumps.JumpProbe;
import org.mechservice.solver.ode.jumps.JumpSearch;
import org.mechservice.solver.ode.jumps.PoleProbe;
import org.mechservice.solver.ode.jumps.PulseProbe;
import org.mechservice.solver.ode.step.ErrorNorm;
import org.mechservice.solver.ode.step.IntegrationProgress;
import org.mechservice.solver.ode.step.Manifold;
import org.mechservice.solver.ode.step.RightHandSide;
import org.mechservice.solver.ode.step.StepBounds;
import org.mechservice.solver.ode.step.SteppingIntegrator;

/**
 * Adams methods of variable order and step in PECE form: predict, evaluate, correct, evaluate. The
 * two programs built on it differ in norm, bounds and start.
 *
 * <p>One step is told by {@link #step}: it tries a step of size h with the predictor of order k
 * until the error test passes and all values are finite, accepts it, and chooses k and h anew.
 */
abstract class AdamsPece extends SteppingIntegrator {
  /** Share of the interval that the first step may cover: a start at rest says nothing about f. */
  private static final double FIRST_SHARE_OF_INTERVAL = 0.1;

  /** Parts into which looks for pulses divide a step at most. */
  private static final double MOST_LOOKS = 16;

  private static final double UNIT_ROUNDOFF = Math.ulp(1.0);

  private static final StepPolynomial KEPT = AdamsInterpolant::evaluateKept;

  private final ErrorNorm norm;
  private final StepBounds bounds;
  private final AdamsCoefficients coefficients = new AdamsCoefficients();
  private final AdamsOrderControl control = new AdamsOrderControl();
  private final AdamsInterpolant interpolant = new AdamsInterpolant();
  private final StiffnessMonitor stiffness = new StiffnessMonitor();
  private final JumpSearch jumps = new JumpSearch();
  private final ChatterMonitor chatter = new ChatterMonitor();

  private RightHandSide equations = RightHandSide.none();
  private Manifold manifold = new Manifold(equations.system());
  private PoleProbe poles = new PoleProbe(0);
  private PulseProbe pulses = new PulseProbe(0);
  private UnforeseenJump unforeseen = new UnforeseenJump(0);
  private AdamsHistory history = new AdamsHistory(0, false);

  /** End of the problem. */
  private double tEnd;

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
    equations = new RightHandSide(system, settings.stop());
    begin(t0, tEnd);
    manifold = new Manifold(system);
    norm.begin(settings.relativeTolerance(), tolerances, manifold);
    norm.weigh(y0);
    history = new AdamsHistory(y0.length, compensates(roundOff(y0)));
    poles = new PoleProbe(y0.length);
    pulses = new PulseProbe(y0.length);
    unforeseen = new UnforeseenJump(y0.length);
    stiffness.clear();
    StepResult result = beginAt(t0, y0, settings.initialStep());
    jumps.beginsAt(t0);
    return result;
  }

  private void begin(double t0, double tEnd) {
    equations.breakpoints().begin(equations.system(), t0, tEnd);
    bounds.begin(t0, tEnd, settings.maxStep());
    progress.begin(t0, equations.system().dimension(), settings.relativeTolerance());
    this.tEnd = tEnd;
  }

  @Override
  public final StepResult restart(double t, double[] y, double longestFirstStep) {
    progress.requireInLastStep(t);
    IntegratorSettings.requireUsable(y, history.state().length);
    if (equations.breakpoints().reachedAt(t)) {
      equations.breakpoints().pass();
    }
    StepResult result = beginAnew(t, y);
    h = Math.copySign(Math.min(Math.abs(h), longestFirstStep), h);
    return result;
  }

  @Override
  public final StepResult takeOver(double t, double[] y) {
    equations.breakpoints().passUpTo(t);
    return beginAnew(t, y);
  }

  /** Returns whether stability, not accuracy, has limited the latest steps. */
  public final boolean atStabilityLimit() {
    return stiffness.nowAtStabilityLimit();
  }

  /** Returns whether it did in some of them at least. */
  public final boolean nearStabilityLimit() {
    return stiffness.nearStabilityLimit();
  }

  /**
   * Returns how many times longer the latest step was than 1 / L, L the rate at which f changes.
   */
  public final double rateTimesStep() {
    return stiffness.latestProduct();
  }

  /**
   * Returns for how many steps a motion that is hardly damped has been followed at the edge of
   * stability.
   */
  public final long stepsAtEdge() {
    return stiffness.stepsAtEdge();
  }

  /** Returns the size of that motion at the first of them over the error allowed, at most. */
  public final double sizeAtEdge() {
    return stiffness.sizeAtEdge();
  }

  /** Returns the state reached; not to be modified. */
  public final double[] state() {
    return history.state();
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
    beginStep();
    prepare();
    TrialOutcome prediction = predict(control.order());
    foreseen = prediction == TrialOutcome.PASSED;
    return prediction != TrialOutcome.STOPPED;
  }

  /** Returns whether a first step is foreseen. */
  public final boolean foreseen() {
    return foreseen;
  }

  /** Returns the size of the step foreseen, signed. */
  public final double foreseenStep() {
    return h;
  }

  /** Gives a step up that was foreseen. */
  public final void abandonStep() {
    begun = false;
    prepared = false;
    foreseen = false;
  }

  /**
   * Returns by how much f at the prediction differed from its extrapolation: the direction of the
   * fastest motion where stability is near; not to be modified.
   */
  public final double[] discrepancy() {
    return history.discrepancy;
  }

  /** Returns f at the state reached; not to be modified. */
  public final double[] slope() {
    return history.difference(1);
  }

  /** Returns how many jumps lie ahead; {@link JumpSearch#ahead}. */
  public final double jumpsAhead() {
    return jumps.ahead(progress.time(), tEnd);
  }

  /** Returns whether it crosses what looks like jumps again and again. */
  public final boolean crossesOften() {
    return jumps.crossesOften(progress.time(), tEnd);
  }

  private StepResult beginAnew(double t, double[] y) {
    stiffness.beginAgain();
    poles.clear();
    progress.beginAgain(t);
    return beginAt(t, y, 0);
  }

  /** Begins at order 1, with a step of the given size or, if that is 0, of the method's choice. */
  private StepResult beginAt(double t, double[] y, double initialStep) {
    coefficients.clear();
    control.begin(settings.highestOrder(AdamsCoefficients.HIGHEST_ORDER));
    jumps.clear();
    chatter.begin(t, progress.steps(), progress.rejectedSteps());
    bounds.stopAt(equations.breakpoints().next());
    triedTime = t;
    h = 0;
    begun = false;
    prepared = false;
    foreseen = false;
    history.begin(y);
    boolean complete = manifold.complete(t, history.state());
    norm.weigh(history.state());
    equations.evaluateAlways(t, history.state(), history.derivative);
    history.beginDerivative();
    if (!complete) {
      return fail(Cause.NOT_COMPLETED, -1);
    }
    if (!finite(history.derivative)) {
      return fail(Cause.NOT_FINITE, notFiniteComponent);
    }
    h = Math.copySign(initialStep > 0 ? initialStep : firstStepFrom(t), tEnd - t);
    return progress.goOn(bounds.reachedAt(t));
  }

  private double firstStepFrom(double t) {
    return Math.min(
        FIRST_SHARE_OF_INTERVAL * Math.abs(tEnd - t), firstStep(norm.of(history.derivative)));
  }

  @Override
  public final StepResult step() {
    progress.requireRunning();
    if (equations.breakpoints().reachedAt(progress.time())) {
      StepResult result = passBreakpoint();
      if (result != StepResult.ADVANCED) {
        return result;
      }
    }
    beginStep();
    if (roundOff(history.state()) > 0.5) {
      return fail(Cause.TOLERANCE_TOO_TIGHT, norm.largest(history.state()));
    }
    while (progress.mayTry(settings.maxSteps(), tEnd)) {
      prepare();
      TrialOutcome attempt = tryStep();
      if (attempt == TrialOutcome.STOPPED) {
        return StepResult.STOPPED;
      }
      if (attempt == TrialOutcome.PASSED) {
        int pole = componentWithPole();
        if (pole >= 0) {
          return fail(Cause.UNBOUNDED, pole);
        }
        double part = partToPulse();
        if (part < 1) {
          progress.rejected(h, control.order(), Double.NaN, TrialOutcome.TOO_INACCURATE, -1);
          h *= part;
          prepared = false;
          continue;
        }
        accept();
        if (slides()) {
          return fail(Cause.STEP_TOO_SMALL, norm.largest(history.discrepancy));
        }
        return progress.goOn(bounds.reachedAt(progress.time()));
      }
      Optional<Cause> cause = reject(attempt);
      if (cause.isPresent()) {
        return fail(cause.get(), limitingComponent(attempt));
      }
    }
    return fail(Cause.TOO_MANY_STEPS, norm.largest(history.discrepancy));
  }

  /** Begins anew on the other side of a jump. */
  private StepResult passBreakpoint() {
    if (equations.stopped()) {
      return StepResult.STOPPED;
    }
    equations.breakpoints().pass();
    return beginAnew(progress.time(), history.state());
  }

  /** Sets weights and bounds of a step; one that was stopped is taken up where it stood. */
  private void beginStep() {
    if (!begun) {
      norm.weigh(history.state());
      control.beginStep();
      h = bounds.bounded(progress.time(), h);
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

  /** Predict, complete, evaluate, estimate, correct, complete and project, evaluate. */
  private TrialOutcome tryStep() {
    int k = control.order();
    TrialOutcome prediction = foreseen ? TrialOutcome.PASSED : predict(k);
    foreseen = false;
    if (prediction != TrialOutcome.PASSED) {
      return prediction;
    }
    control.estimate(Math.abs(h), coefficients, history, norm);
    if (control.error() <= 1 && crossesUnseen(k)) {
      jumps.found(h, k, triedTime, control.error(), control.discrepancy());
    }
    if (!(control.error() <= 1) || jumps.inside(h, control.discrepancy())) {
      return finite(history.derivative) ? TrialOutcome.TOO_INACCURATE : TrialOutcome.NOT_FINITE;
    }
    if (!correct(h * coefficients.g[k + 1])) {
      return TrialOutcome.NOT_COMPLETED;
    }
    if (!evaluate(history.corrected())) {
      return TrialOutcome.STOPPED;
    }
    return finite(history.corrected()) && finite(history.derivative)
        ? TrialOutcome.PASSED
        : TrialOutcome.NOT_FINITE;
  }

  /** Returns whether a step that passes has a jump inside. */
  private boolean crossesUnseen(int k) {
    double discrepancy = control.discrepancy();
    if (settings.mode() == Mode.FAITHFUL
        || manifold.completes()
        || !jumps.wouldMatter(h, discrepancy)) {
      return false;
    }
    int component = norm.largest(history.discrepancy);
    boolean suspected =
        jumps.suspects(h, k, control.error())
            || unforeseen.suspected(history, k, progress.order(), component, jumps.anyKnown());
    return suspected
        && unforeseen.found(equations, history, progress.time(), h, k, coefficients.psi, component);
  }

  /** Predict, complete, evaluate. */
  private TrialOutcome predict(int k) {
    history.predict(h, k, coefficients.beta, coefficients.g);
    if (!manifold.complete(triedTime, history.predicted)) {
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
    double[] corrected = history.corrected();
    history.correct(weight);
    boolean found =
        manifold.complete(triedTime, corrected) && manifold.project(triedTime, corrected);
    history.carry(weight);
    return found;
  }

  /** Returns the component that has a pole inside the step that passed, −1 if none has. */
  private int componentWithPole() {
    return settings.mode() == Mode.FAITHFUL
        ? -1
        : poles.component(
            equations,
            norm,
            progress.time(),
            triedTime,
            history.state(),
            history.corrected(),
            history.difference(1),
            history.foreseen(),
            history.derivative);
  }

  /** Returns the part of the step that passed up to a pulse inside of it; 1 if none is seen. */
  private double partToPulse() {
    if (settings.mode() == Mode.FAITHFUL || manifold.completes()) {
      return 1;
    }
    double t = progress.time();
    if (pulses.wanted(h, progress.stepSize(), tEnd - progress.start(), jumps.shortestDistance())) {
      pulses.place(h, history.state(), history.corrected(), norm);
      if (pulses.straight(h, history.difference(1), norm)
          && pulses.straight(h, history.derivative, norm)) {
        jumps.straightFrom(progress.start());
        return pulses.partToPulse(equations, t, h, history.state(), norm);
      }
    }
    int parts = (int) Math.min(MOST_LOOKS, Math.ceil(Math.abs(h) / jumps.distanceOfLooks(t)));
    return parts > 1
        ? unforeseen.partToPulse(
            equations, history, norm, t, h, control.order(), coefficients.psi, parts)
        : 1;
  }

  private void accept() {
    int k = control.order();
    poles.accepted(progress.time(), history.difference(1));
    history.accept(k);
    coefficients.accept(h, k);
    progress.accepted(h, triedTime, k, control.error());
    stiffness.accepted(h, k, control.error(), coefficients.g[k + 1], history, norm);
    double size = h;
    double error = control.error();
    h *= control.accept(Math.abs(h), coefficients.equalSteps(), history, norm);
    manifold.restoreUnitGroups(history.state(), history);
    manifold.accepted(triedTime, history.state());
    if (jumps.accepted(size, triedTime, error)) {
      forgetHistory();
    } else if (jumps.active()) {
      h = towardsJump(h);
    }
    h = Math.copySign(Math.min(Math.abs(h), jumps.longestStep(triedTime)), h);
    begun = false;
    prepared = false;
  }

  /** Returns whether the solution slides along a jump and would have to cross it for ever. */
  private boolean slides() {
    double t = progress.time();
    return chatter.suspects(t, tEnd, progress.steps(), progress.rejectedSteps())
        && !manifold.completes()
        && new JumpProbe(equations.system(), t, history.state()).foundInState(h);
  }

  /** Begins at order 1 behind a jump, where f is known. */
  private void forgetHistory() {
    stiffness.beginAgain();
    coefficients.beginAgain();
    control.begin(settings.highestOrder(AdamsCoefficients.HIGHEST_ORDER));
    h = Math.copySign(firstStepFrom(triedTime), h);
  }

  /** Returns the step that halves the stretch with a jump, or crosses it, no longer than given. */
  private double towardsJump(double longest) {
    double step = jumps.step(progress.time());
    if (jumps.crossing()) {
      control.fallToOrderOne();
    }
    return Math.abs(step) < Math.abs(longest) ? step : longest;
  }

  /** Reduces the step; returns a cause if that is not possible. */
  private Optional<Cause> reject(TrialOutcome attempt) {
    boolean inaccurate = attempt == TrialOutcome.TOO_INACCURATE;
    double error = inaccurate ? control.error() : Double.NaN;
    progress.rejected(h, control.order(), error, attempt, limitingComponent(attempt));
    double smallest = bounds.smallest(progress.time());
    boolean hopeless = Math.abs(h) <= smallest || jumpsAhead() > JumpSearch.MOST;
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
    if (settings.mode() != Mode.FAITHFUL && Double.isFinite(control.error())) {
      jumps.rejected(h, control.order(), triedTime, control.error(), control.discrepancy());
    }
    return jumps.active() ? towardsJump(h) : control.reject() * h;
  }

  /** Evaluates f at the end of the step being tried; returns false if told to stop instead. */
  private boolean evaluate(double[] y) {
    return equations.evaluate(triedTime, y, history.derivative);
  }

  /** Returns the norm of the rounding errors that a state of this size cannot avoid. */
  private double roundOff(double[] y) {
    return 2 * UNIT_ROUNDOFF * norm.of(y);
  }

  /** Returns whether all components are finite; if not, remembers the first that is not. */
  private boolean finite(double[] x) {
    notFiniteComponent = RightHandSide.firstNotFinite(x);
    return notFiniteComponent < 0;
  }

  private int limitingComponent(TrialOutcome attempt) {
    return switch (attempt) {
      case NOT_FINITE -> notFiniteComponent;
      case NOT_COMPLETED -> -1;
      default -> norm.largest(history.discrepancy);
    };
  }

  private StepResult fail(Cause cause, int component) {
    return progress.fail(cause, h, control.order(), component, norm);
  }

  @Override
  public final double time() {
    return bounds.inProblem(progress.time());
  }

  @Override
  public final void interpolate(double t, double[] y, double[] yDot) {
    progress.requireInLastStep(t);
    interpolant.evaluate(t - progress.time(), progress.order(), coefficients.psi, history, y, yDot);
  }

  @Override
  public final int keptLength() {
    return AdamsInterpolant.keptLength(progress.order(), history.state().length);
  }

  @Override
  public final StepPolynomial keepStep(double[] kept, int from) {
    progress.requireStep();
    AdamsInterpolant.keep(progress.time(), progress.order(), coefficients.psi, history, kept, from);
    return KEPT;
  }

  @Override
  public final byte[] save() {
    progress.requireBetweenSteps(begun);
    return SavedState.save(this::transfer);
  }

  @Override
  public final StepResult resume(OdeSystem system, byte[] saved) {
    equations = new RightHandSide(system, settings.stop());
    SavedState.restore(saved, this::transfer);
    return progress.result();
  }

  /** Carries the integration between two steps over. */
  private void transfer(SavedState state) {
    state.require("method", getClass().getSimpleName());
    settings.transfer(state);
    int n = equations.system().dimension();
    state.require("number of unknowns", n);
    double t0 = state.number(progress.start());
    double end = state.number(tEnd);
    boolean compensated = state.flag(history.compensated());
    if (state.restoring()) {
      begin(t0, end);
      history = new AdamsHistory(n, compensated);
      poles = new PoleProbe(n);
      pulses = new PulseProbe(n);
      unforeseen = new UnforeseenJump(n);
    }
    equations.transfer(state);
    if (state.restoring()) {
      manifold = new Manifold(equations.system());
      norm.begin(settings.relativeTolerance(), settings.absoluteTolerances(n), manifold);
      control.begin(settings.highestOrder(AdamsCoefficients.HIGHEST_ORDER));
      bounds.stopAt(equations.breakpoints().next());
      begun = false;
      prepared = false;
    }
    progress.transfer(state);
    history.transfer(state);
    coefficients.transfer(state);
    control.transfer(state);
    jumps.transfer(state);
    chatter.transfer(state);
    poles.transfer(state);
    stiffness.transfer(state);
    h = state.number(h);
    triedTime = state.number(triedTime);
  }

  @Override
  public final long evaluations() {
    return equations.evaluations();
  }

  @Override
  public final IntegrationStatistics statistics() {
    return new IntegrationStatistics(
        progress.steps(),
        progress.rejectedSteps(),
        equations.evaluations(),
        0,
        0,
        0,
        stiffness.suspectsStiffness(),
        toleranceFactor,
        progress.limits());
  }
}
