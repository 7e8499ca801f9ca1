package org.mechservice.solver.ode.switching;

import java.util.List;
import org.mechservice.solver.ode.IntegrationFailure;
import org.mechservice.solver.ode.IntegrationStatistics;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.Integrator.MethodChange;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.OdeSystem;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.StepPolynomial;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.adams.Ode113;
import org.mechservice.solver.ode.adams.StiffnessMonitor;
import org.mechservice.solver.ode.backward.BackwardFormulas;
import org.mechservice.solver.ode.jumps.JumpProbe;
import org.mechservice.solver.ode.jumps.JumpSearch;
import org.mechservice.solver.ode.step.ExactEndBounds;
import org.mechservice.solver.ode.step.IntegrationProgress;
import org.mechservice.solver.ode.step.RightHandSide;
import org.mechservice.solver.ode.step.StepBounds;
import org.mechservice.solver.ode.step.SteppingIntegrator;
import org.mechservice.solver.ode.stiff.Ode15s;

/**
 * {@link Ode113} as long as accuracy limits its steps, {@link Ode15s} where stability would and its
 * steps would cost less. A problem that never becomes stiff is integrated by ode113 alone, with the
 * same bits; what watching it costs, where stability is near, is a tenth of cheap steps.
 *
 * <p>What steps cost is told by {@link StepCosts}: beside its evaluations a step of ode15s takes
 * several times what one of ode113 does, which with cheap equations decides. ode15s takes over when
 * 13 of the last 16 steps were at the limit of stability, which ode113 sees in the two evaluations
 * of its steps ({@link StiffnessMonitor}), if steps of ode15s would by then be so much longer that
 * they cost at most three quarters ({@link StepForecast}), and stiffness can be expected to last
 * long enough to pay its start. Where the solution has only begun to get smooth, nothing is lost by
 * waiting: both cost the same until then. It also takes over when ode113 slides along what looks
 * like a jump, or crosses such things again and again: friction so steep that no step of its own
 * tells it from one. It takes over before or after one of the first steps if that is accurate and
 * far too long for stability, and from an oscillation that only ode113 keeps alive ({@link
 * FastestMotionProbe}).
 *
 * <p>ode113 takes over when its steps, as long as they were when it was left or shorter by as much
 * as the fastest motion got faster, would cost three quarters of what ode15s spends, for as long as
 * adds up to a dozen of its steps ({@link StiffPhaseCost}). Both begin at order 1. A phase that has
 * not paid makes the next change of that kind ask for four times as much, so that methods that are
 * about equally good do not take turns: one of ode15s that cost more than three quarters of what
 * ode113 would have spent there, one of ode113 of less than 50 steps.
 *
 * <p>The workspace of ode15s is made when it is first needed. {@link IntegratorSettings#maxOrder}
 * bounds both; ode15s knows no more than 5.
 *
 * <p>Orders 1 to 13 and 1 to 5. Memory: about 95 n numbers of 8 bytes for n unknowns, and that of
 * ode15s from when it is first needed.
 *
 * <p>After Petzold, <i>Automatic selection of methods for solving stiff and nonstiff systems of
 * ordinary differential equations</i>, SIAM J. Sci. Stat. Comput. 4 (1983) 136; the criteria are
 * our own.
 */
public final class Switching implements Integrator {
  /** A phase of ode113 with fewer steps was not worth its start. */
  private static final int SHORT_PHASE = 50;

  /** Times the length of steps that cost less by which they save next to all. */
  private static final double MUCH_LONGER = 8;

  /** Part of the way ahead over which stiffness is expected to last. */
  private static final double SHARE_AHEAD = 0.8;

  /** Loss after which ode15s is left, in steps of its own. */
  private static final double LOSS_ALLOWED = 12;

  /** Steps at the edge of stability after which their motion is looked at first. */
  private static final long STEPS_TO_PROBE = 2000;

  /** Part of what ode113 has spent at the edge of stability that a trial may cost. */
  private static final double SHARE_OF_TRIAL = 0.1;

  private static final int MORE_EVIDENCE = 4;
  private static final int MOST_EVIDENCE = 256;

  /** Steps after a start in which one that is too long for stability tells that it is stiff. */
  private static final int FIRST_STEPS = 6;

  /** Rate of the fastest motion times the step from which on no Adams method is stable. */
  private static final double UNSTABLE = 2;

  /** Jumps ahead that are worth the evaluations of a closer look at the next one. */
  private static final double MANY_JUMPS = 1e4;

  private final IntegrationProgress progress = new IntegrationProgress();
  private final Ode113 adams;
  private final Ode15s backward;
  private final StiffPhaseCost stiffPhase = new StiffPhaseCost();
  private final MethodChanges changes = new MethodChanges();

  private final StepForecast forecast = new StepForecast();
  private FastestMotionProbe probe;
  private final double rootOfTolerance;

  /** Of both methods. */
  private final StepBounds bounds = new ExactEndBounds();

  private OdeSystem system = RightHandSide.none().system();
  private StepCosts costs = StepCosts.dense(0);
  private double tEnd;

  /** Where the problem is handed over, and its derivative. */
  private double[] y = {};

  private double[] yDot = {};

  /** Which method is at work, and whether ode15s ever was. */
  private boolean stiff;

  private boolean backwardBegun;
  private boolean changeDue;

  /** Whether the latest forecast speaks for ode15s. */
  private boolean worthChange;

  /** Since when stability has limited the steps, and how long the last phase of ode15s was. */
  private double limitedSince;

  private double lastedBefore;

  /** Whether the right-hand side was found to jump where the solution slides. */
  private boolean jumps;

  /** Whether that was asked in the present phase because ode113 crosses jumps often. */
  private boolean looked;

  /** Steps of the present phase, and those at its end that speak for the other method. */
  private long stepsOfPhase;

  private int evidence;

  /** What was spent up to the start of the present phase. */
  private double spentBefore;

  /** How many steps in a row must speak for ode15s, and times the loss allowed to that. */
  private int neededForBackward;

  private int lossFactor;

  /** Loss allowed to a phase of ode15s that is a trial. */
  private double patience;

  /** Steps at the edge of stability after which its motion is looked at. */
  private long stepsToProbe;

  /** Whether the first step is still to be looked at. */
  private boolean startDue;

  /**
   * @throws IllegalArgumentException if a setting is out of range
   */
  public Switching(IntegratorSettings settings) {
    rootOfTolerance = Math.sqrt(settings.relativeTolerance());
    adams = new Ode113(settings, progress);
    backward = new Ode15s(settings, progress);
    probe = new FastestMotionProbe(system, adams.norm());
  }

  private SteppingIntegrator atWork() {
    return stiff ? backward : adams;
  }

  @Override
  public StepResult start(OdeSystem system, double t0, double[] y0, double tEnd) {
    StepResult result = adams.start(system, t0, y0, tEnd);
    prepare(system, t0, tEnd);
    changes.clear();
    backwardBegun = false;
    jumps = false;
    neededForBackward = 1;
    lossFactor = 1;
    lastedBefore = 0;
    stepsToProbe = STEPS_TO_PROBE;
    patience = 0;
    beginPhase(false);
    startDue = result == StepResult.ADVANCED;
    return result;
  }

  private void prepare(OdeSystem system, double t0, double tEnd) {
    this.system = system;
    this.tEnd = tEnd;
    y = new double[system.dimension()];
    yDot = new double[system.dimension()];
    forecast.prepare(system.dimension(), tEnd - t0);
    probe = new FastestMotionProbe(system, adams.norm());
    costs = StepCosts.of(system);
  }

  private void beginPhase(boolean stiff) {
    this.stiff = stiff;
    looked = false;
    stepsOfPhase = 0;
    spentBefore = spent();
    stiffPhase.begin(progress.time(), forecast.meanStep());
    beginWatch();
  }

  private void beginWatch() {
    changeDue = false;
    evidence = 0;
    startDue = false;
    stiffPhase.watch();
    forecast.begin();
    worthChange = false;
    limitedSince = progress.time();
  }

  @Override
  public StepResult restart(double t, double[] y, double longestFirstStep) {
    StepResult result = atWork().restart(t, y, longestFirstStep);
    beginWatch();
    return result;
  }

  /** Looks whether the problem is stiff from its first step on; returns false if told to stop. */
  private boolean lookAtStart() {
    if (!adams.foresee()) {
      return false;
    }
    startDue = false;
    double t = progress.time();
    double h = adams.foreseenStep();
    changeDue =
        adams.foreseen()
            && probe.startsStiff(t, adams.state(), adams.slope(), adams.discrepancy(), h)
            && paysStart(1 / probe.rate());
    if (changeDue) {
      adams.abandonStep();
    }
    return true;
  }

  @Override
  public StepResult step() {
    if (startDue && !lookAtStart()) {
      return StepResult.STOPPED;
    }
    if (changeDue) {
      StepResult result = change();
      if (result != StepResult.ADVANCED) {
        return result;
      }
    }
    StepResult result = atWork().step();
    if (result == StepResult.ADVANCED) {
      watch();
    }
    return result;
  }

  /** Looks at the step just taken: the other method takes the next one if there is evidence. */
  private void watch() {
    stepsOfPhase++;
    boolean slides = !stiff && !jumps && (slidesAlongSteepness() || crossesSteepness());
    if (stiff) {
      changeDue = backwardCostsMore();
    } else {
      evidence = adamsCostsMore() ? evidence + 1 : 0;
      changeDue = evidence >= neededForBackward || slides || startsStiff() || keepsAlive();
    }
  }

  /**
   * Returns whether one of the first steps was accurate and far too long for stability: the start
   * lies on the slow solution of a stiff problem. Where the fast motion is an oscillation that is
   * hardly damped, a few more such steps would stir it up to some tolerances, and then both methods
   * would have to follow it.
   */
  private boolean startsStiff() {
    double product = adams.rateTimesStep();
    if (stiff || changes.count() > 0 || stepsOfPhase > FIRST_STEPS || !(product >= UNSTABLE)) {
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

  /**
   * Returns whether what looks like many jumps that follow each other is one place at which the
   * right-hand side is steep. If they are jumps, too many for any run, ode113 is left to end it.
   */
  private boolean slidesAlongSteepness() {
    double ahead = adams.jumpsAhead();
    if (ahead <= MANY_JUMPS) {
      return false;
    }
    boolean real = jumpsAhead();
    jumps = real && ahead > JumpSearch.MOST;
    return !real;
  }

  /** Likewise, asked once in a phase, as soon as a few of them have followed each other. */
  private boolean crossesSteepness() {
    if (looked || !adams.crossesOften()) {
      return false;
    }
    looked = true;
    return !jumpsAhead();
  }

  /** Returns whether there is a real jump: ode113 is left to cross it, or to end the run there. */
  private boolean jumpsAhead() {
    adams.interpolate(progress.time(), y, yDot);
    return new JumpProbe(system, progress.time(), y).found(progress.stepSize());
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

  private boolean backwardCostsMore() {
    double rate = backward.fastestRate();
    stiffPhase.record(progress.time(), spent() - spentBefore, rate, costs.adamsStep());
    double allowed = patience + LOSS_ALLOWED * lossFactor * costs.backwardStep();
    return stiffPhase.loss() > allowed && roomToBegin();
  }

  /** Returns what ode15s has cost, and the steps of ode113 as if they had been its own. */
  private double spent() {
    long tries = progress.steps() + progress.rejectedSteps();
    return backwardBegun
        ? costs.backward(tries, backward.evaluations(), backward.factorisations())
        : costs.backward(tries, 0, 0);
  }

  /**
   * Returns whether a method can begin here: at order 1 it takes steps that are shorter, by about
   * the root of the tolerance, and t has to tell them apart.
   */
  private boolean roomToBegin() {
    double begun = Math.abs(progress.stepSize()) * rootOfTolerance;
    return begun > bounds.smallest(progress.time());
  }

  /** Hands the problem over where the last step ended. */
  private StepResult change() {
    double t = progress.time();
    atWork().interpolate(t, y, yDot);
    changes.record(t, progress.stepSize(), !stiff);
    if (!paid()) {
      demandMore();
    }
    if (stiff) {
      lastedBefore = stiffPhase.covered();
      patience = 0;
    }
    beginPhase(!stiff);
    if (!stiff) {
      return adams.takeOver(t, y);
    }
    boolean first = !backwardBegun;
    backwardBegun = true;
    return first ? backward.takeOver(system, t, y, tEnd) : backward.takeOver(t, y);
  }

  /** Returns whether the phase that ends was worth its start. */
  private boolean paid() {
    return stiff ? stiffPhase.paid() : stepsOfPhase >= SHORT_PHASE;
  }

  /** The phase that ends was begun too early. */
  private void demandMore() {
    if (stiff) {
      neededForBackward = Math.min(MORE_EVIDENCE * neededForBackward, MOST_EVIDENCE);
    } else if (changes.count() > 1) {
      lossFactor = Math.min(MORE_EVIDENCE * lossFactor, MOST_EVIDENCE);
    }
  }

  @Override
  public double time() {
    return progress.time();
  }

  @Override
  public double previousTime() {
    return progress.previousTime();
  }

  @Override
  public double stepSize() {
    return progress.stepSize();
  }

  @Override
  public int order() {
    return progress.order();
  }

  @Override
  public void interpolate(double t, double[] y, double[] yDot) {
    atWork().interpolate(t, y, yDot);
  }

  @Override
  public int keptLength() {
    return atWork().keptLength();
  }

  @Override
  public StepPolynomial keepStep(double[] kept, int from) {
    return atWork().keepStep(kept, from);
  }

  @Override
  public byte[] save() {
    byte[] ofAdams = adams.save();
    byte[] ofBackward = backwardBegun ? backward.save() : new byte[0];
    return SavedState.save(
        state -> {
          state.require("method", getClass().getSimpleName());
          state.number(progress.start());
          state.number(tEnd);
          state.bytes(ofAdams);
          state.bytes(ofBackward);
          transfer(state);
        });
  }

  @Override
  public StepResult resume(OdeSystem system, byte[] saved) {
    SavedState.restore(
        saved,
        state -> {
          state.require("method", getClass().getSimpleName());
          double t0 = state.number(0);
          prepare(system, t0, state.number(0));
          adams.resume(system, state.bytes(new byte[0]));
          byte[] ofBackward = state.bytes(new byte[0]);
          backwardBegun = ofBackward.length > 0;
          if (backwardBegun) {
            backward.resume(system, ofBackward);
          }
          transfer(state);
        });
    return progress.result();
  }

  private void transfer(SavedState state) {
    stiffPhase.transfer(state);
    forecast.transfer(state);
    changes.transfer(state);
    stiff = state.flag(stiff);
    changeDue = state.flag(changeDue);
    worthChange = state.flag(worthChange);
    limitedSince = state.number(limitedSince);
    lastedBefore = state.number(lastedBefore);
    jumps = state.flag(jumps);
    looked = state.flag(looked);
    stepsOfPhase = state.integer(stepsOfPhase);
    spentBefore = state.number(spentBefore);
    evidence = state.integer(evidence);
    neededForBackward = state.integer(neededForBackward);
    lossFactor = state.integer(lossFactor);
    patience = state.number(patience);
    stepsToProbe = state.integer(stepsToProbe);
    startDue = state.flag(startDue);
    probe.transfer(state);
  }

  @Override
  public IntegrationStatistics statistics() {
    IntegrationStatistics ofAdams = adams.statistics();
    if (!backwardBegun && probe.evaluations() == 0) {
      return ofAdams;
    }
    IntegrationStatistics ofBackward = backward.statistics();
    return new IntegrationStatistics(
        ofAdams.steps(),
        ofAdams.rejectedSteps(),
        ofAdams.evaluations() + ofBackward.evaluations() + probe.evaluations(),
        ofBackward.jacobians(),
        ofBackward.factorisations(),
        ofBackward.solutions(),
        ofAdams.stiffnessSuspected(),
        ofAdams.timeConstants(),
        ofAdams.toleranceFactor(),
        ofAdams.limits());
  }

  @Override
  public List<MethodChange> methodChanges() {
    return changes.list();
  }

  @Override
  public long methodChangeCount() {
    return changes.count();
  }

  @Override
  public IntegrationFailure failure() {
    return progress.failure();
  }
}
