package org.mechservice.solver.ode.jumps;

import java.util.Optional;
import org.mechservice.solver.linear.MatrixLayout;
import org.mechservice.solver.ode.IntegrationFailure.Cause;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.TrialOutcome;
import org.mechservice.solver.ode.newton.ColumnGroups;
import org.mechservice.solver.ode.newton.ColumnTest;
import org.mechservice.solver.ode.step.ErrorNorm;
import org.mechservice.solver.ode.step.ExtrapolatedStep;
import org.mechservice.solver.ode.step.IntegrationProgress;
import org.mechservice.solver.ode.step.RightHandSide;
import org.mechservice.solver.ode.step.StepWatch;
import org.mechservice.solver.ode.step.TriedStep;
import org.mechservice.solver.ode.step.WatchedIntegrator;

/**
 * Searches for jumps, pulses and poles of an f of which nothing is known but its values, in the
 * steps of any integrator.
 *
 * <pre>{@code
 * Integrator integrator = UndeclaredJumps.around(new Ode113(settings));
 * }</pre>
 *
 * <p>It guesses: from failed error tests, from a discrepancy that the steps before do not foretell,
 * from a derivative that grows or turns, from long straight steps. What it suspects it looks at by
 * further evaluations of f, narrows down and steps across at order 1. Who knows where f jumps does
 * better to say so ({@link org.mechservice.solver.ode.PiecewiseSystem}, events): nothing is then
 * left to find. An integrator without it meets a jump by failed error tests alone, at more cost,
 * and does not see what leaves no trace at the ends of a step.
 *
 * <p>Measured, by the tests of this package. A force that jumps between two values at random times,
 * 0.9 to 1.9 apart, beside a decay or an oscillation, from 1e-3 to 1e-6: at most one run of 60 is
 * off by more than ten tolerances, where 52 of 60 (ode113) were without. Jumps 0.05 to 0.5 apart,
 * in straight motion: one of 60; beside a decay 3 of 60, 6 of 60 with ode15s. A block that breaks
 * loose from a belt: at most one of 100 implicit runs misses it. Poles of order 1 to 5 at 60
 * places, 1e-2 to 1e-6: none is crossed. It costs evaluations where it suspects something: in the
 * suite of smooth problems with Adams methods none, over the example files 26 % in sum, all but 2 %
 * of that in two long runs.
 *
 * <p>Where both sides of a jump lead back to it, as with dry friction at rest, the solution slides
 * along it, and steps would cross it for ever; such a run is ended with {@link
 * Cause#STEP_TOO_SMALL}, and a step across a pole with {@link Cause#UNBOUNDED}. f is evaluated for
 * this at places that no step ends at. Systems whose states are completed, and problems in residual
 * form, are searched for less.
 */
public final class UndeclaredJumps implements StepWatch, ColumnTest.Maker {
  /** Parts into which looks for pulses divide a step at most where jumps are known. */
  private static final double MOST_LOOKS = 16;

  /** Jumps ahead that are worth the evaluations of a closer look at the next one. */
  private static final double MANY_JUMPS = 1e4;

  private final JumpSearch search = new JumpSearch();
  private final JumpMonitor errors = new JumpMonitor();
  private final ChatterMonitor chatter = new ChatterMonitor();
  private final SlidingMonitor slide = new SlidingMonitor();
  private PoleProbe poles = new PoleProbe(0);
  private PulseProbe pulses = new PulseProbe(0);
  private UnforeseenJump unforeseen = new UnforeseenJump(0);

  /** The step being tried; as one of a method that extrapolates f, if it does; and f. */
  private Optional<TriedStep> watched = Optional.empty();

  private Optional<ExtrapolatedStep> extrapolated = Optional.empty();
  private Optional<RightHandSide> function = Optional.empty();

  /** Whether f was found to jump, too often for any run, where the solution slides. */
  private boolean jumpsForEver;

  /** Whether that was asked since the last beginning because jumps are crossed often. */
  private boolean looked;

  private UndeclaredJumps() {}

  /**
   * Has the steps of an integrator searched, in all problems to come.
   *
   * @return the integrator
   */
  public static <I extends WatchedIntegrator> I around(I integrator) {
    integrator.watch(UndeclaredJumps::new);
    return integrator;
  }

  @Override
  public String name() {
    return "search for undeclared jumps";
  }

  @Override
  public ColumnTest of(MatrixLayout layout, ColumnGroups groups) {
    return new SteepColumns(layout, groups);
  }

  @Override
  public void prepare(TriedStep step) {
    int n = step.manifold().dimension();
    watched = Optional.of(step);
    extrapolated = step instanceof ExtrapolatedStep one ? Optional.of(one) : Optional.empty();
    function = step.rightHandSide();
    poles = new PoleProbe(n);
    pulses = new PulseProbe(n);
    unforeseen = new UnforeseenJump(n);
    jumpsForEver = false;
  }

  private TriedStep step() {
    return watched.orElseThrow(() -> new IllegalStateException("no problem was begun"));
  }

  private IntegrationProgress progress() {
    return step().progress();
  }

  @Override
  public void begin(double t) {
    search.clear();
    if (extrapolated.isPresent() && t == progress().start()) {
      search.beginsAt(t);
    }
    errors.begin();
    slide.clear();
    poles.clear();
    chatter.begin(t, progress().steps(), progress().rejectedSteps());
    looked = false;
  }

  @Override
  public boolean passes(double error) {
    TriedStep step = step();
    if (error <= 1) {
      if (extrapolated.isPresent() && crossesUnseen(extrapolated.get())) {
        search.found(step.size(), step.order(), step.end(), error, step.discrepancy());
      }
      return !search.active() || !search.inside(step.size(), step.discrepancy());
    }
    errors.failed(step.size(), error);
    return function.isEmpty() && errors.solutionJumped(error);
  }

  private boolean crossesUnseen(ExtrapolatedStep step) {
    if (step.manifold().completes() || !search.wouldMatter(step.size(), step.discrepancy())) {
      return false;
    }
    int component = step.worstComponent();
    boolean suspected =
        search.suspects(step.size(), step.order(), step.error())
            || unforeseen.suspected(step, component, search.anyKnown());
    return suspected && unforeseen.found(function.orElseThrow(), step, component);
  }

  @Override
  public int componentWithPole() {
    if (extrapolated.isEmpty()) {
      return -1;
    }
    ExtrapolatedStep step = extrapolated.get();
    double t = progress().time();
    if (!poles.suspected(t, step.end(), step.slope(), step.slopeAtEnd())) {
      return -1;
    }
    poles.place(t, step.end(), step.state(), step.stateAtEnd());
    return poles.component(
        function.orElseThrow(), step.norm(), step.slope(), step.foreseenSlope(), step.slopeAtEnd());
  }

  @Override
  public double partToTake() {
    double part = function.isPresent() ? partToPulse(function.get()) : 1;
    if (part == 1 && extrapolated.isPresent()) {
      poles.accepted(progress().time(), extrapolated.get().slope());
    }
    return part;
  }

  /** Returns the part of the step that passed up to a pulse inside of it; 1 if none is seen. */
  private double partToPulse(RightHandSide equations) {
    TriedStep step = step();
    if (step.manifold().completes()) {
      return 1;
    }
    double t = progress().time();
    double interval = step.problemEnd() - progress().start();
    if (step.error() < PulseProbe.ERROR_OF_STRAIGHT_STEP
        && pulses.wanted(step.size(), progress().stepSize(), interval, search.shortestDistance())) {
      pulses.place(step.size(), step.state(), step.stateAtEnd(), step.norm());
      if (straight(step)) {
        search.straightFrom(progress().start());
        return pulses.partToPulse(equations, t, step.norm());
      }
    }
    if (extrapolated.isEmpty() || !search.anyKnown()) {
      return 1;
    }
    int parts =
        (int) Math.min(MOST_LOOKS, Math.ceil(Math.abs(step.size()) / search.distanceOfLooks(t)));
    return parts > 1 ? unforeseen.partToPulse(equations, extrapolated.get(), parts) : 1;
  }

  private boolean straight(TriedStep step) {
    ErrorNorm norm = step.norm();
    boolean atStart = extrapolated.isEmpty() || pulses.straight(extrapolated.get().slope(), norm);
    return atStart && pulses.straight(step.slopeAtEnd(), norm);
  }

  @Override
  public boolean accepted() {
    TriedStep step = step();
    errors.accepted(step.error());
    boolean crossed = search.accepted(step.size(), step.end(), step.error());
    return crossed || step.error() > 1;
  }

  @Override
  public boolean rejected(TrialOutcome attempt) {
    TriedStep step = step();
    double t = progress().time();
    if (extrapolated.isPresent() && search.ahead(t, step.problemEnd()) > JumpSearch.MOST) {
      return true;
    }
    if (extrapolated.isEmpty()
        && attempt == TrialOutcome.NOT_CONVERGING
        && slide.unsolved(t, step.problemEnd())) {
      return true;
    }
    boolean inaccurate = attempt == TrialOutcome.TOO_INACCURATE && Double.isFinite(step.error());
    if (inaccurate && function.isPresent()) {
      search.rejected(step.size(), step.order(), step.end(), step.error(), step.discrepancy());
    }
    return false;
  }

  @Override
  public double aim() {
    return search.active() ? search.step(progress().time()) : Double.POSITIVE_INFINITY;
  }

  @Override
  public boolean atOrderOne() {
    return search.crossing();
  }

  @Override
  public double longest() {
    return search.longestStep(progress().time());
  }

  @Override
  public boolean forgets() {
    return errors.derivativeJumped(step().size());
  }

  @Override
  public boolean slides(double h) {
    double t = progress().time();
    double end = step().problemEnd();
    return chatter.suspects(t, end, progress().steps(), progress().rejectedSteps())
        && !step().manifold().completes()
        && new JumpProbe(function.orElseThrow(), t, step().state()).foundInState(h);
  }

  /**
   * {@inheritDoc} What looks like many jumps that follow each other may be one place at which f is
   * steep, as with friction too steep for any step. If they are jumps, too many for any run, the
   * explicit method is left to end it; as soon as a few of them have followed each other it is
   * asked once, too.
   */
  @Override
  public boolean steepAhead() {
    if (jumpsForEver) {
      return false;
    }
    double ahead = search.ahead(progress().time(), step().problemEnd());
    if (ahead > MANY_JUMPS) {
      boolean real = jumpAhead();
      jumpsForEver = real && ahead > JumpSearch.MOST;
      if (!real) {
        return true;
      }
    }
    if (looked || !search.crossesOften(progress().time(), step().problemEnd())) {
      return false;
    }
    looked = true;
    return !jumpAhead();
  }

  private boolean jumpAhead() {
    return new JumpProbe(function.orElseThrow(), progress().time(), step().state())
        .found(progress().stepSize());
  }

  @Override
  public void transfer(SavedState state) {
    search.transfer(state);
    errors.transfer(state);
    chatter.transfer(state);
    slide.transfer(state);
    poles.transfer(state);
    jumpsForEver = state.flag(jumpsForEver);
    looked = state.flag(looked);
  }
}
