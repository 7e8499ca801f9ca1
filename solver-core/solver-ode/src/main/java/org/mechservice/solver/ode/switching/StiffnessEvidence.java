package org.mechservice.solver.ode.switching;

import org.mechservice.solver.ode.OdeSystem;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.adams.Ode113;
import org.mechservice.solver.ode.backward.BackwardFormulas;
import org.mechservice.solver.ode.step.IntegrationProgress;
import org.mechservice.solver.ode.step.RightHandSide;

/**
 * Whether an Adams method is to be left for an implicit one, asked after each of its steps. There
 * are four reasons, one for each way in which stiffness shows: stability limits the steps and
 * implicit ones would cost less ({@link StepForecast}, {@link StepCosts}); a step can be foreseen
 * to be far too long for stability, before the first one or after one of the first; an oscillation
 * is kept alive by the method alone ({@link FastestMotionProbe}); and a watch of the steps may have
 * reasons of its own.
 */
final class StiffnessEvidence {
  /** A phase of ode113 with fewer steps was not worth its start. */
  private static final int SHORT_PHASE = 50;

  /** Times the length of steps that cost less by which they save next to all. */
  private static final double MUCH_LONGER = 8;

  /** Part of the way ahead over which stiffness is expected to last. */
  private static final double SHARE_AHEAD = 0.8;

  /** Steps at the edge of stability after which their motion is looked at first. */
  private static final long STEPS_TO_PROBE = 2000;

  /** Part of what ode113 has spent at the edge of stability that a trial may cost. */
  private static final double SHARE_OF_TRIAL = 0.1;

  /** Steps after a start in which one that is too long for stability tells that it is stiff. */
  private static final int FIRST_STEPS = 6;

  /** Rate of the fastest motion times the step from which on no Adams method is stable. */
  private static final double UNSTABLE = 2;

  private static final int MORE_EVIDENCE = 4;
  private static final int MOST_EVIDENCE = 256;

  private final Ode113 adams;
  private final IntegrationProgress progress;
  private final StepForecast forecast = new StepForecast();
  private FastestMotionProbe probe;
  private StepCosts costs = StepCosts.dense(0);
  private double tEnd;

  /** Whether the implicit method has not been at work yet. */
  private boolean fresh;

  /** Steps of the present phase, and those at its end at which stability limits them. */
  private long stepsOfPhase;

  private int evidence;

  /** How many in a row have to be limited by it. */
  private int needed;

  /** Whether the latest forecast speaks for the implicit method. */
  private boolean worthChange;

  /** Since when stability has limited the steps, and how long the last implicit phase was. */
  private double limitedSince;

  private double lastedBefore;

  /** Loss allowed to the implicit method if it is at work for a trial. */
  private double patience;

  /** Steps at the edge of stability after which its motion is looked at. */
  private long stepsToProbe;

  StiffnessEvidence(Ode113 adams, IntegrationProgress progress) {
    this.adams = adams;
    this.progress = progress;
    probe = new FastestMotionProbe(RightHandSide.none().system(), adams.norm());
  }

  /** Makes ready for a problem. */
  void prepare(OdeSystem system, double t0, double tEnd, StepCosts costs) {
    this.tEnd = tEnd;
    this.costs = costs;
    forecast.prepare(system.dimension(), tEnd - t0);
    probe = new FastestMotionProbe(system, adams.norm());
  }

  /** Begins a problem. */
  void begin() {
    fresh = true;
    needed = 1;
    lastedBefore = 0;
    stepsToProbe = STEPS_TO_PROBE;
    patience = 0;
  }

  /** Begins a phase of either method. */
  void beginPhase() {
    stepsOfPhase = 0;
    watch();
  }

  /** Looks at the steps from here on. */
  void watch() {
    evidence = 0;
    forecast.begin();
    worthChange = false;
    limitedSince = progress.time();
  }

  /** Takes note that the Adams method is left; returns whether it was worth its start. */
  boolean left() {
    fresh = false;
    return stepsOfPhase >= SHORT_PHASE;
  }

  /**
   * Takes note that the Adams method takes over again.
   *
   * @param paid whether the implicit one was worth its start
   * @param covered how long it was at work
   */
  void takenUp(boolean paid, double covered) {
    needed = paid ? needed : more(needed);
    lastedBefore = covered;
    patience = 0;
  }

  /** Returns what the next change of a kind has to bring after one that has not paid. */
  static int more(int before) {
    return Math.min(MORE_EVIDENCE * before, MOST_EVIDENCE);
  }

  /** Returns whether the problem is stiff from its first step on, which is foreseen. */
  boolean startsStiffAtOnce() {
    return adams.foreseen()
        && probe.startsStiff(
            progress.time(),
            adams.state(),
            adams.slope(),
            adams.discrepancy(),
            adams.foreseenStep())
        && paysStart(1 / probe.rate());
  }

  /** Looks at the step just taken; returns whether the implicit method is to take the next one. */
  boolean speaksForChange() {
    stepsOfPhase++;
    boolean steep = adams.steepAhead();
    evidence = adamsCostsMore() ? evidence + 1 : 0;
    return evidence >= needed || steep || startsStiff() || keepsAlive();
  }

  /**
   * Returns whether one of the first steps was accurate and far too long for stability: the start
   * lies on the slow solution of a stiff problem. Where the fast motion is an oscillation that is
   * hardly damped, a few more such steps would stir it up to some tolerances, and then both methods
   * would have to follow it.
   */
  private boolean startsStiff() {
    double product = adams.rateTimesStep();
    if (!fresh || stepsOfPhase > FIRST_STEPS || !(product >= UNSTABLE)) {
      return false;
    }
    double stable = Math.abs(progress.stepSize()) / product;
    return paysStart(stable);
  }

  /** Returns whether steps far longer than a size pay the start of ode15s up to the end. */
  private boolean paysStart(double stable) {
    return costs.paysStart(SHARE_AHEAD * Math.abs(tEnd - progress.time()) / stable, MUCH_LONGER);
  }

  /**
   * Returns whether an oscillation that ode113 follows would be long gone but for that: at the edge
   * of stability it has gone on for many times the time in which it decays. To end it ode15s may
   * take a part of what ode113 has spent on it.
   */
  private boolean keepsAlive() {
    long steps = adams.stepsAtEdge();
    if (steps < stepsToProbe) {
      return false;
    }
    double h = Math.abs(progress.stepSize());
    double decay = probe.decay(progress.time(), adams.state(), adams.slope(), adams.discrepancy());
    double gone = 1 + StrictMath.log(Math.max(1, adams.sizeAtEdge()));
    double decayed = decay * h * steps;
    if (decayed >= gone && paysStart(h)) {
      patience = SHARE_OF_TRIAL * steps * costs.adamsStep();
      stepsToProbe = 4 * steps;
      return true;
    }
    double toGo = decayed > 0 ? Math.max(1.1, Math.min(gone / decayed, 2)) : 2;
    stepsToProbe = (long) (toGo * steps);
    return false;
  }

  /** Returns whether stability limits the steps and those of ode15s would cost less. */
  private boolean adamsCostsMore() {
    if (!adams.nearStabilityLimit()) {
      forecast.begin();
      worthChange = false;
      limitedSince = progress.time();
      return false;
    }
    if (forecast.record(progress.time(), adams.state())) {
      worthChange = adams.atStabilityLimit() && backwardWouldCostLess();
    }
    return worthChange && adams.atStabilityLimit();
  }

  /** Returns whether steps of ode15s would cost less, over the way ahead with its start. */
  private boolean backwardWouldCostLess() {
    double step = costs.stepWorthAChange() * forecast.meanStep();
    if (!passes(step)) {
      return false;
    }
    double longer = 1;
    while (longer < MUCH_LONGER && passes(2 * longer * step)) {
      longer *= 2;
    }
    return costs.paysStart(stiffnessAhead() / forecast.meanStep(), longer);
  }

  /**
   * Returns how long stiffness is expected to last. It may end before the run does; and if it has
   * come and gone before, it is expected to last as long as then, or as long again as it has lasted
   * already.
   */
  private double stiffnessAhead() {
    double most = SHARE_AHEAD * Math.abs(tEnd - progress.time());
    if (lastedBefore == 0) {
      return most;
    }
    return Math.min(most, Math.max(lastedBefore, Math.abs(progress.time() - limitedSince)));
  }

  private boolean passes(double step) {
    return forecast.passes(step, BackwardFormulas.NDF, adams.norm());
  }

  /** Returns the loss allowed to the implicit method because it is at work for a trial. */
  double patience() {
    return patience;
  }

  /** Returns the mean length of the latest steps of the Adams method. */
  double meanStep() {
    return forecast.meanStep();
  }

  /** Returns how often f was evaluated to look at the fastest motion. */
  long evaluations() {
    return probe.evaluations();
  }

  /** Carries the state between two steps over. */
  void transfer(SavedState state) {
    forecast.transfer(state);
    fresh = state.flag(fresh);
    stepsOfPhase = state.integer(stepsOfPhase);
    evidence = state.integer(evidence);
    needed = state.integer(needed);
    worthChange = state.flag(worthChange);
    limitedSince = state.number(limitedSince);
    lastedBefore = state.number(lastedBefore);
    patience = state.number(patience);
    stepsToProbe = state.integer(stepsToProbe);
    probe.transfer(state);
  }
}
