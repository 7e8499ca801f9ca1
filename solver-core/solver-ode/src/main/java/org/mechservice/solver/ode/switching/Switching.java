package org.mechservice.solver.ode.switching;

import java.util.List;
import java.util.function.Supplier;
import org.mechservice.solver.ode.IntegrationFailure;
import org.mechservice.solver.ode.IntegrationStatistics;
import org.mechservice.solver.ode.Integrator.MethodChange;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.OdeSystem;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.StepPolynomial;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.adams.Ode113;
import org.mechservice.solver.ode.adams.StiffnessMonitor;
import org.mechservice.solver.ode.step.ExactEndBounds;
import org.mechservice.solver.ode.step.IntegrationProgress;
import org.mechservice.solver.ode.step.RightHandSide;
import org.mechservice.solver.ode.step.StepBounds;
import org.mechservice.solver.ode.step.StepWatch;
import org.mechservice.solver.ode.step.SteppingIntegrator;
import org.mechservice.solver.ode.step.WatchedIntegrator;
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
 * waiting: both cost the same until then. It takes over before or after one of the first steps if
 * that is accurate and far too long for stability, and from an oscillation that only ode113 keeps
 * alive ({@link FastestMotionProbe}).
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
public final class Switching implements WatchedIntegrator {
  /** Loss after which ode15s is left, in steps of its own. */
  private static final double LOSS_ALLOWED = 12;

  private final IntegrationProgress progress = new IntegrationProgress();
  private final Ode113 adams;
  private final Ode15s backward;
  private final StiffPhaseCost stiffPhase = new StiffPhaseCost();
  private final MethodChanges changes = new MethodChanges();

  private final StiffnessEvidence stiffness;
  private final double rootOfTolerance;

  /** Of both methods. */
  private final StepBounds bounds = new ExactEndBounds();

  private OdeSystem system = RightHandSide.none().system();
  private StepCosts costs = StepCosts.dense(0);
  private double tEnd;

  /** State at which the problem is handed over, and its derivative. */
  private double[] y = {};

  private double[] yDot = {};

  /** Which method is at work, and whether ode15s ever was. */
  private boolean stiff;

  private boolean backwardBegun;
  private boolean changeDue;

  /** Cost up to the start of the present phase. */
  private double spentBefore;

  /** Times the usual loss that is allowed to ode15s. */
  private int lossFactor;

  /** Whether the first step is still to be looked at. */
  private boolean startDue;

  /**
   * @throws IllegalArgumentException if a setting is out of range
   */
  public Switching(IntegratorSettings settings) {
    rootOfTolerance = Math.sqrt(settings.relativeTolerance());
    adams = new Ode113(settings, progress);
    backward = new Ode15s(settings, progress);
    stiffness = new StiffnessEvidence(adams, progress);
  }

  @Override
  public void watch(Supplier<StepWatch> watches) {
    adams.watch(watches);
    backward.watch(watches);
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
    lossFactor = 1;
    stiffness.begin();
    beginPhase(false);
    startDue = result == StepResult.ADVANCED;
    return result;
  }

  private void prepare(OdeSystem system, double t0, double tEnd) {
    this.system = system;
    this.tEnd = tEnd;
    y = new double[system.dimension()];
    yDot = new double[system.dimension()];
    costs = StepCosts.of(system);
    stiffness.prepare(system, t0, tEnd, costs);
  }

  private void beginPhase(boolean stiff) {
    this.stiff = stiff;
    spentBefore = spent();
    stiffPhase.begin(progress.time(), stiffness.meanStep());
    changeDue = false;
    startDue = false;
    stiffness.beginPhase();
  }

  @Override
  public StepResult restart(double t, double[] y, double longestFirstStep) {
    StepResult result = atWork().restart(t, y, longestFirstStep);
    changeDue = false;
    startDue = false;
    stiffPhase.watch();
    stiffness.watch();
    return result;
  }

  @Override
  public StepResult step() {
    if (startDue && !adams.foresee()) {
      return StepResult.STOPPED;
    }
    if (startDue) {
      lookAtStart();
    }
    if (changeDue) {
      StepResult result = change();
      if (result != StepResult.ADVANCED) {
        return result;
      }
    }
    StepResult result = atWork().step();
    if (result == StepResult.ADVANCED) {
      changeDue = stiff ? backwardCostsMore() : stiffness.speaksForChange();
    }
    return result;
  }

  /** Looks whether the problem is stiff from its first step on, which is foreseen. */
  private void lookAtStart() {
    startDue = false;
    changeDue = stiffness.startsStiffAtOnce();
    if (changeDue) {
      adams.abandonStep();
    }
  }

  /** Returns whether ode15s has lost so much that ode113 is to take the next step. */
  private boolean backwardCostsMore() {
    double rate = backward.fastestRate();
    stiffPhase.record(progress.time(), spent() - spentBefore, rate, costs.adamsStep());
    double allowed = stiffness.patience() + LOSS_ALLOWED * lossFactor * costs.backwardStep();
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
    if (stiff) {
      stiffness.takenUp(stiffPhase.paid(), stiffPhase.covered());
    } else if (!stiffness.left() && changes.count() > 1) {
      lossFactor = StiffnessEvidence.more(lossFactor);
    }
    beginPhase(!stiff);
    if (!stiff) {
      return adams.takeOver(t, y);
    }
    boolean first = !backwardBegun;
    backwardBegun = true;
    return first ? backward.takeOver(system, t, y, tEnd) : backward.takeOver(t, y);
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
    stiffness.transfer(state);
    changes.transfer(state);
    stiff = state.flag(stiff);
    changeDue = state.flag(changeDue);
    spentBefore = state.number(spentBefore);
    lossFactor = state.integer(lossFactor);
    startDue = state.flag(startDue);
  }

  @Override
  public IntegrationStatistics statistics() {
    IntegrationStatistics ofAdams = adams.statistics();
    if (!backwardBegun && stiffness.evaluations() == 0) {
      return ofAdams;
    }
    IntegrationStatistics ofBackward = backward.statistics();
    return new IntegrationStatistics(
        ofAdams.steps(),
        ofAdams.rejectedSteps(),
        ofAdams.evaluations() + ofBackward.evaluations() + stiffness.evaluations(),
        ofBackward.jacobians(),
        ofBackward.factorisations(),
        ofBackward.solutions(),
        ofAdams.stiffnessSuspected(),
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
