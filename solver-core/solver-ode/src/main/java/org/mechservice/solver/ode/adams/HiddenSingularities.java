package org.mechservice.solver.ode.adams;

import org.mechservice.solver.ode.IntegratorSettings.Mode;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.jumps.ChatterMonitor;
import org.mechservice.solver.ode.jumps.JumpProbe;
import org.mechservice.solver.ode.jumps.JumpSearch;
import org.mechservice.solver.ode.jumps.PoleProbe;
import org.mechservice.solver.ode.jumps.PulseProbe;
import org.mechservice.solver.ode.step.ErrorNorm;
import org.mechservice.solver.ode.step.IntegrationProgress;

/**
 * Jumps, pulses and poles of f that a step of an Adams method may hide although it passes its error
 * test, and jumps along which many short steps slide. The published programs do not look for them.
 *
 * <p>Steps are inspected only where their numbers give a reason, as an evaluation of f may cost
 * much and an inspection takes as long as the step itself does for small problems: a discrepancy
 * that the differences before it do not foretell, a derivative that turns or has doubled, an error
 * that is next to nothing.
 */
final class HiddenSingularities {
  /** Parts into which looks for pulses divide a step at most. */
  private static final double MOST_LOOKS = 16;

  private final IntegrationProgress progress;
  private final ErrorNorm norm;
  private final AdamsOrderControl control;
  private final AdamsCoefficients coefficients;

  /** Whether anything is looked for but sliding. */
  private final boolean searches;

  private final JumpSearch jumps = new JumpSearch();
  private final ChatterMonitor chatter = new ChatterMonitor();

  private AdamsProblem problem = AdamsProblem.none();
  private PoleProbe poles = new PoleProbe(0);
  private PulseProbe pulses = new PulseProbe(0);
  private UnforeseenJump unforeseen = new UnforeseenJump(0);

  HiddenSingularities(
      IntegrationProgress progress,
      ErrorNorm norm,
      AdamsOrderControl control,
      AdamsCoefficients coefficients,
      Mode mode) {
    this.progress = progress;
    this.norm = norm;
    this.control = control;
    this.coefficients = coefficients;
    searches = mode != Mode.FAITHFUL;
  }

  /** Makes ready for a problem. */
  void prepare(AdamsProblem problem) {
    int n = problem.dimension();
    this.problem = problem;
    poles = new PoleProbe(n);
    pulses = new PulseProbe(n);
    unforeseen = new UnforeseenJump(n);
  }

  /** Begins without history. */
  void beginAt(double t) {
    jumps.clear();
    if (t == progress.start()) {
      jumps.beginsAt(t);
    }
    chatter.begin(t, progress.steps(), progress.rejectedSteps());
  }

  /** Forgets what derivatives before another state have foretold. */
  void forgetDerivatives() {
    poles.clear();
  }

  /** Returns the search for jumps that failed tries tell of. */
  JumpSearch jumps() {
    return jumps;
  }

  /**
   * Returns whether a step that passes its error test has a jump inside.
   *
   * @param h its size
   * @param end where it ends
   */
  boolean jumpInside(double h, double end) {
    if (crossesUnseen(h, control.order())) {
      jumps.found(h, control.order(), end, control.error(), control.discrepancy());
    }
    return jumps.inside(h, control.discrepancy());
  }

  private boolean crossesUnseen(double h, int k) {
    if (!searches
        || problem.manifold().completes()
        || !jumps.wouldMatter(h, control.discrepancy())) {
      return false;
    }
    AdamsHistory history = problem.history();
    int component = norm.largest(history.discrepancy);
    boolean suspected =
        jumps.suspects(h, k, control.error())
            || unforeseen.suspected(
                history, coefficients.beta, k, progress.order(), component, jumps.anyKnown());
    return suspected
        && unforeseen.found(
            problem.equations(), history, progress.time(), h, k, coefficients.psi, component);
  }

  /**
   * Returns the component that has a pole inside the step that passed, −1 if none has.
   *
   * @param end where it ends
   */
  int componentWithPole(double end) {
    AdamsHistory history = problem.history();
    if (!searches
        || !poles.suspected(progress.time(), end, history.difference(1), history.derivative)) {
      return -1;
    }
    poles.place(progress.time(), end, history.state(), history.corrected());
    return poles.component(
        problem.equations(), norm, history.difference(1), history.foreseen(), history.derivative);
  }

  /**
   * Returns the part of the step that passed up to a pulse inside of it; 1 if none is seen.
   *
   * @param h its size
   */
  double partToPulse(double h) {
    if (!searches || problem.manifold().completes()) {
      return 1;
    }
    double t = progress.time();
    double interval = problem.end() - progress.start();
    AdamsHistory history = problem.history();
    if (control.error() < PulseProbe.ERROR_OF_STRAIGHT_STEP
        && pulses.wanted(h, progress.stepSize(), interval, jumps.shortestDistance())) {
      pulses.place(h, history.state(), history.corrected(), norm);
      if (pulses.straight(history.difference(1), norm)
          && pulses.straight(history.derivative, norm)) {
        jumps.straightFrom(progress.start());
        return pulses.partToPulse(problem.equations(), t, norm);
      }
    }
    if (!jumps.anyKnown()) {
      return 1;
    }
    int parts = (int) Math.min(MOST_LOOKS, Math.ceil(Math.abs(h) / jumps.distanceOfLooks(t)));
    return parts > 1
        ? unforeseen.partToPulse(
            problem.equations(), history, norm, t, h, control.order(), coefficients.psi, parts)
        : 1;
  }

  /** Takes note that a step is accepted from where the integration is. */
  void accepting() {
    poles.accepted(progress.time(), problem.history().difference(1));
  }

  /**
   * Returns whether the solution slides along a jump and would have to cross it for ever.
   *
   * @param h step to be tried next
   */
  boolean slides(double h) {
    double t = progress.time();
    return chatter.suspects(t, problem.end(), progress.steps(), progress.rejectedSteps())
        && !problem.manifold().completes()
        && new JumpProbe(problem.equations().system(), t, problem.history().state())
            .foundInState(h);
  }

  /** Carries the state between two steps over. */
  void transfer(SavedState state) {
    jumps.transfer(state);
    chatter.transfer(state);
    poles.transfer(state);
  }
}
