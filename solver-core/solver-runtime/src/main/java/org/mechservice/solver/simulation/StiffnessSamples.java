package org.mechservice.solver.simulation;

import java.util.Arrays;
import java.util.Optional;
import org.mechservice.solver.analysis.equation.FastSpectrum;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ModelState;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.api.run.Stiffness;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.SavedState;

/**
 * Looks at the stiffness of a run at the times of {@link Stiffness}: the start and the ends of
 * equal parts of the interval. A run that is stopped within the first part has one place more,
 * where it was after the latest power of two steps.
 *
 * <p>The states are kept along the run. Their eigenvalues are computed once the integrator suspects
 * stiffness, between two steps; the model's internal state is put back, so that they change nothing
 * in the run. After a stop or a failure nothing is evaluated any more.
 */
final class StiffnessSamples {
  /** Steps before which no run is looked at within the first part of the interval. */
  private static final long FIRST_LOOK = 256;

  private final ExplicitModel model;
  private final double start;
  private final double end;

  /** States at the times; the last row is that of the place more. */
  private final double[][] states;

  /** Deciding eigenvalue of each row; NaN if it was not computed, or if there is none. */
  private final double[] real;

  private final double[] imaginary;
  private final double[] scratch;
  private int taken;

  /** Rows, of those taken, that were looked at. */
  private int looked;

  /**
   * @param dimension unknowns of the integrator, the states first
   */
  StiffnessSamples(ExplicitModel model, int dimension, RunSettings settings) {
    this.model = model;
    start = settings.tStart();
    end = settings.tEnd();
    states = new double[Stiffness.USUAL_TIMES + 1][model.description().stateCount()];
    real = new double[states.length];
    imaginary = new double[states.length];
    Arrays.fill(real, Double.NaN);
    scratch = new double[dimension];
  }

  private double time(int sample) {
    int last = Stiffness.USUAL_TIMES - 1;
    return sample == last ? end : start + (end - start) * sample / last;
  }

  /** Keeps the state at the start. */
  void begin(double[] y) {
    System.arraycopy(y, 0, states[0], 0, states[0].length);
    taken = 1;
  }

  /**
   * Keeps the states that a step has passed, and looks at them if the run suspects stiffness.
   *
   * @param steps number of steps so far
   * @param yDot overwritten
   * @return whether it looked
   */
  boolean stepped(Integrator integrator, long steps, double[] yDot) {
    int before = taken;
    while (taken < Stiffness.USUAL_TIMES && time(taken) <= integrator.time()) {
      keep(integrator, time(taken), taken, yDot);
      taken++;
    }
    boolean early = taken == 1 && steps >= FIRST_LOOK && Long.bitCount(steps) == 1;
    boolean looks = (early || taken > before) && isLimited(integrator);
    if (looks) {
      look();
      if (early) {
        int more = Stiffness.USUAL_TIMES;
        keep(integrator, integrator.time(), more, yDot);
        lookAt(new FastSpectrum(model), more, integrator.time());
      }
    }
    return looks;
  }

  private void keep(Integrator integrator, double t, int row, double[] yDot) {
    integrator.interpolate(t, scratch, yDot);
    System.arraycopy(scratch, 0, states[row], 0, states[row].length);
  }

  private static boolean isLimited(Integrator integrator) {
    return integrator.methodChangeCount() > 0 || integrator.statistics().stiffnessSuspected();
  }

  private void look() {
    FastSpectrum spectrum = new FastSpectrum(model);
    for (; looked < taken; looked++) {
      lookAt(spectrum, looked, time(looked));
    }
  }

  private void lookAt(FastSpectrum spectrum, int row, double t) {
    double[] kept = new double[model instanceof ModelState own ? own.stateLength() : 0];
    if (model instanceof ModelState own) {
      own.saveState(kept);
    }
    Optional<FastSpectrum.Found> found = spectrum.at(t, states[row]);
    if (model instanceof ModelState own) {
      own.restoreState(kept);
    }
    real[row] = found.map(f -> f.real()[f.deciding()]).orElse(Double.NaN);
    imaginary[row] = found.map(f -> f.imaginary()[f.deciding()]).orElse(Double.NaN);
  }

  /**
   * Returns whether stability has limited steps and the motion so far is called stiff.
   *
   * @param completed whether the run has come to its end, so that the model may be evaluated
   */
  boolean areStiff(Integrator integrator, boolean completed) {
    if (taken == 0 || !isLimited(integrator)) {
      return false;
    }
    if (completed) {
      look();
    }
    Stiffness stiffness = new Stiffness();
    for (int row = 0; row < states.length; row++) {
      boolean counts = row < Stiffness.USUAL_TIMES || taken == 1;
      if (counts && !Double.isNaN(real[row])) {
        stiffness.add(new double[] {real[row]}, new double[] {imaginary[row]});
      }
    }
    return stiffness.verdict(Math.abs(integrator.time() - start)) == Stiffness.Verdict.STIFF;
  }

  /** Carries the states and what was seen in them over. */
  void transfer(SavedState state) {
    taken = state.integer(taken);
    looked = state.integer(looked);
    state.numbers(states);
    state.numbers(real);
    state.numbers(imaginary);
  }
}
