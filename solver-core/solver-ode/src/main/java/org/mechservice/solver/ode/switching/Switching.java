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
 * tells it from one. And it takes over after one of the first steps if that was accurate and far
 * too long for stability.
 *
 * <p>ode113 takes over when its steps, as long as they were when it was left or shorter by as much
 * as the fastest motion got faster, would cost three quarters of what ode15s has spent lately
 * ({@link StiffPhaseCost}). Both begin at order 1. A phase that has not paid makes the next change
 * of that kind ask for four times the evidence, so that methods that are about equally good do not
 * take turns: one of ode15s that cost more than three quarters of what ode113 would have spent
 * there, one of ode113 of less than 50 steps.
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

  /** How many steps in a row must speak for ode15s, and for ode113. */
  private int neededForBackward;

  private int neededForAdams;

  /**
   * @throws IllegalArgumentException if a setting is out of range
   */
  public Switching(IntegratorSettings settings) {
    rootOfTolerance = Math.sqrt(settings.relativeTolerance());
    adams = new Ode113(settings, progress);
    backward = new Ode15s(settings, progress);
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
    neededForAdams = 1;
    lastedBefore = 0;
    beginPhase(false);
    return result;
  }

  private void prepare(OdeSystem system, double t0, double tEnd) {
    this.system = system;
    this.tEnd = tEnd;
    y = new double[system.dimension()];
    yDot = new double[system.dimension()];
    forecast.prepare(system.dimension(), tEnd - t0);
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

  @Override
  public StepResult step() {
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
    boolean speaksForOther = stiff ? backwardCostsMore() : adamsCostsMore();
    evidence = speaksForOther ? evidence + 1 : 0;
    boolean atOnce = slides || startsStiff();
    changeDue = atOnce || evidence >= (stiff ? neededForAdams : neededForBackward);
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
    return costs.paysStart(0.5 * Math.abs(tEnd - progress.time()) / stable, MUCH_LONGER);
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
   * Returns how long stiffness is expected to last. It may end anywhere before the run does; but if
   * it has come and gone before, it is expected to last as long as then, or as long again as it has
   * lasted already.
   */
  private double stiffnessAhead() {
    double half = 0.5 * Math.abs(tEnd - progress.time());
    if (lastedBefore == 0) {
      return half;
    }
    return Math.min(half, Math.max(lastedBefore, Math.abs(progress.time() - limitedSince)));
  }

  private boolean passes(double step) {
    return forecast.passes(step, BackwardFormulas.NDF, adams.norm());
  }

  private boolean backwardCostsMore() {
    double rate = backward.fastestRate();
    stiffPhase.record(progress.time(), spent() - spentBefore, rate, costs.adamsStep());
    return stiffPhase.costsMoreThanAdams() && roomToBegin();
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
      neededForAdams = Math.min(MORE_EVIDENCE * neededForAdams, MOST_EVIDENCE);
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
    neededForAdams = state.integer(neededForAdams);
  }

  @Override
  public IntegrationStatistics statistics() {
    IntegrationStatistics ofAdams = adams.statistics();
    if (!backwardBegun) {
      return ofAdams;
    }
    IntegrationStatistics ofBackward = backward.statistics();
    return new IntegrationStatistics(
        ofAdams.steps(),
        ofAdams.rejectedSteps(),
        ofAdams.evaluations() + ofBackward.evaluations(),
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
