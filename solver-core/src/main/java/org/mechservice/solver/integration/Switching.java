package org.mechservice.solver.integration;

import java.util.List;

/**
 * {@link Ode113} as long as accuracy limits its steps, {@link Ode15s} where stability would. A
 * problem that never becomes stiff is integrated by ode113 alone, with the same bits and at no
 * further cost.
 *
 * <p>ode15s takes over when 13 of the last 16 steps were at the limit of stability, which ode113
 * sees in the two evaluations of its steps ({@link StiffnessMonitor}), or when it slides along what
 * looks like a jump: friction so steep that no step of its own tells it from one. ode113 takes over
 * when its steps at that limit would cost half the evaluations that ode15s has spent lately ({@link
 * StiffPhase}). Both begin at order 1. A phase that has not paid makes the next change of that kind
 * ask for four times the evidence, so that methods that are about equally good do not take turns:
 * one of ode15s that cost more than half of what ode113 would have spent there, one of ode113 of
 * less than 50 steps.
 *
 * <p>The workspace of ode15s is made when it is first needed. {@link IntegratorSettings#maxOrder}
 * bounds both; ode15s knows no more than 5.
 *
 * <p>After Petzold, <i>Automatic selection of methods for solving stiff and nonstiff systems of
 * ordinary differential equations</i>, SIAM J. Sci. Stat. Comput. 4 (1983) 136; the criteria are
 * our own.
 */
public final class Switching implements Integrator {
  /** A phase of ode113 with fewer steps was not worth its start. */
  private static final int SHORT_PHASE = 50;

  private static final int MORE_EVIDENCE = 4;
  private static final int MOST_EVIDENCE = 256;

  private final Progress progress = new Progress();
  private final Ode113 adams;
  private final Ode15s backward;
  private final StiffPhase stiffPhase = new StiffPhase();
  private final MethodChanges changes = new MethodChanges();

  private final double rootOfTolerance;

  /** Halvings of a way after which its ends are neighbours in double precision. */
  private static final int HALVINGS = 60;

  /** What is left of a difference across a real jump. */
  private static final double LASTING = 0.1;

  /** How often the way ahead is doubled to meet what the solution slides along. */
  private static final int DOUBLINGS = 12;

  /** Change of a derivative, as a part of it, that is no smooth one's within so short a way. */
  private static final double MUCH = 0.1;

  /** Of both methods. */
  private final StepBounds bounds = new StepsToEnd();

  private OdeSystem system = RightHandSide.none().system();
  private double tEnd;

  /** Where the problem is handed over, and its derivative. */
  private double[] y = {};

  private double[] yDot = {};

  /** Which method is at work, and whether ode15s ever was. */
  private boolean stiff;

  private boolean backwardBegun;
  private boolean changeDue;

  /** Whether the right-hand side was found to jump where the solution slides. */
  private boolean jumps;

  /** Steps of the present phase, and those at its end that speak for the other method. */
  private long stepsOfPhase;

  private int evidence;

  /** Where the present phase began, and the evaluations of ode15s up to there. */
  private double phaseStart;

  private long spentBefore;

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
    prepare(system, tEnd);
    changes.clear();
    backwardBegun = false;
    jumps = false;
    neededForBackward = 1;
    neededForAdams = 1;
    beginPhase(false);
    return result;
  }

  private void prepare(OdeSystem system, double tEnd) {
    this.system = system;
    this.tEnd = tEnd;
    y = new double[system.dimension()];
    yDot = new double[system.dimension()];
  }

  private void beginPhase(boolean stiff) {
    this.stiff = stiff;
    stepsOfPhase = 0;
    phaseStart = progress.time();
    spentBefore = backwardBegun ? backward.evaluations() : 0;
    beginWatch();
  }

  private void beginWatch() {
    changeDue = false;
    evidence = 0;
    stiffPhase.begin();
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
    boolean slides = !stiff && !jumps && adams.slides();
    if (slides) {
      jumps = jumpsAhead();
      slides = !jumps;
    }
    boolean speaksForOther = stiff ? backwardCostsMore() : adams.atStabilityLimit();
    evidence = speaksForOther ? evidence + 1 : 0;
    changeDue = slides || evidence >= (stiff ? neededForAdams : neededForBackward);
  }

  /**
   * Returns whether the right-hand side jumps where the solution slides, unless it is proved to be
   * steep only: along the tangent ahead derivatives change much within a short way, and by halving
   * that way until no number lies between, their changes get smaller. Of a real jump an implicit
   * method could make a slope that is not there; then ode113 is left to end the run.
   */
  private boolean jumpsAhead() {
    int n = y.length;
    double t = progress.time();
    double[] here = new double[n];
    double[] slope = new double[n];
    double[] ahead = new double[n];
    double[] slopeAhead = new double[n];
    boolean[] looked = new boolean[n];
    boolean steep = false;
    adams.interpolate(t, here, yDot);
    system.derivative(t, here, slope);
    double h = progress.stepSize();
    for (int i = 0; i < DOUBLINGS; i++, h *= 2) {
      for (int l = 0; l < n; l++) {
        ahead[l] = here[l] + h * slope[l];
      }
      system.derivative(t + h, ahead, slopeAhead);
      for (int l = 0; l < n; l++) {
        double size = Math.max(Math.abs(slope[l]), Math.abs(slopeAhead[l]));
        if (!looked[l] && Math.abs(slopeAhead[l] - slope[l]) > MUCH * size) {
          looked[l] = true;
          steep = true;
          if (changeLasts(l, t, h, here, slope, slopeAhead[l])) {
            return true;
          }
        }
      }
    }
    return !steep;
  }

  /** Returns whether a derivative still changes as much when its ends are neighbours. */
  private boolean changeLasts(
      int l, double t, double h, double[] here, double[] slope, double slopeAhead) {
    double from = 0;
    double to = h;
    double before = slope[l];
    double behind = slopeAhead;
    for (int i = 0; i < HALVINGS; i++) {
      double middle = 0.5 * (from + to);
      for (int j = 0; j < here.length; j++) {
        y[j] = here[j] + middle * slope[j];
      }
      system.derivative(t + middle, y, yDot);
      if (Math.abs(yDot[l] - before) < Math.abs(yDot[l] - behind)) {
        from = middle;
        before = yDot[l];
      } else {
        to = middle;
        behind = yDot[l];
      }
    }
    return !(Math.abs(behind - before) < LASTING * Math.abs(slopeAhead - slope[l]));
  }

  private boolean backwardCostsMore() {
    stiffPhase.record(progress.time(), backward.evaluations());
    return stiffPhase.costsMoreThanAdams(backward.fastestRate()) && roomToBegin();
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
    double covered = Math.abs(progress.time() - phaseStart);
    return stiff
        ? StiffPhase.paid(covered, backward.evaluations() - spentBefore, backward.fastestRate())
        : stepsOfPhase >= SHORT_PHASE;
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
  public byte[] save() {
    byte[] ofAdams = adams.save();
    byte[] ofBackward = backwardBegun ? backward.save() : new byte[0];
    return StateTransfer.save(
        state -> {
          state.require("method", getClass().getSimpleName());
          state.number(tEnd);
          state.bytes(ofAdams);
          state.bytes(ofBackward);
          transfer(state);
        });
  }

  @Override
  public StepResult resume(OdeSystem system, byte[] saved) {
    StateTransfer.restore(
        saved,
        state -> {
          state.require("method", getClass().getSimpleName());
          prepare(system, state.number(0));
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

  private void transfer(StateTransfer state) {
    stiffPhase.transfer(state);
    changes.transfer(state);
    stiff = state.flag(stiff);
    changeDue = state.flag(changeDue);
    jumps = state.flag(jumps);
    stepsOfPhase = state.integer(stepsOfPhase);
    phaseStart = state.number(phaseStart);
    spentBefore = state.integer(spentBefore);
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
