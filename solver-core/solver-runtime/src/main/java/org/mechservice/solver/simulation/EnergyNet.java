package org.mechservice.solver.simulation;

import java.util.Optional;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.Energies;
import org.mechservice.solver.api.run.RunNotes.Note;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.ode.SavedState;

/**
 * The balance of energy under every run: kinetic plus potential energy minus work must stay what it
 * was at the start, or the motion is wrong.
 *
 * <p>What may be off is measured by the energy that has moved: the largest of the ranges of kinetic
 * and of potential energy and of half the energy that forces without potential have added and
 * removed. At most {@value #LEAST_PART} to {@value #MOST_PART} of it may be missing, by the
 * tolerance, or {@value #TOLERANCES} tolerances of all energy if that is more, but never more than
 * {@value #MOST_PART} of it: integration loses some of an energy that stays where it is, too, as
 * that of a rotor.
 *
 * <p>The balance is looked at in every row and after {@value #STRIDE} steps without one where the
 * work is known, and at the end of the run. Where it is not known yet, only the energies are, after
 * twice as many steps. Whether a drift is too large is decided by the energy that has moved up to
 * then; when it began, from the times at which it has grown by a half. Nothing allocates in a step.
 */
final class EnergyNet {
  /** Largest part of the energy that has moved that may be missing at tight tolerances. */
  private static final double LEAST_PART = 0.01;

  /** The same at any tolerance. */
  private static final double MOST_PART = 0.03;

  /** Multiple of the tolerance that may accumulate. */
  private static final double TOLERANCES = 1e3;

  /** Relative rounding of an energy, a sum over bodies and forces. */
  private static final double ROUNDING = 1000 * 0x1p-52;

  /** Steps between two looks: a motion has more than this in each of its swings. */
  private static final int STRIDE = 8;

  /** Growth of the drift that is remembered with its time. */
  private static final double GROWTH = 1.5;

  /** Times that are remembered: more than the range of a double from rounding on. */
  private static final int MOST_TIMES = 200;

  private final Optional<Energies> model;
  private final double tolerance;
  private final double[] energy = new double[2];

  /** Total, kinetic and potential energy at the start, J. */
  private final double[] start = new double[3];

  /** Largest and least kinetic energy, largest and least potential energy, J. */
  private final double[] range = new double[4];

  private final double[] times = new double[MOST_TIMES];
  private final double[] drifts = new double[MOST_TIMES];
  private int count;
  private double drift;
  private double rounding;
  private double turnover;
  private boolean unknown;
  private int sinceLook;

  /**
   * @param tolerance relative tolerance of the run
   */
  EnergyNet(Model model, double tolerance) {
    this.model = model instanceof Energies able ? Optional.of(able) : Optional.empty();
    this.tolerance = tolerance;
  }

  /** Takes the energy at the start. */
  void begin(double t, double[] y) {
    if (model.isEmpty()) {
      return;
    }
    model.get().energy(t, y, energy);
    start[0] = energy[0] + energy[1];
    start[1] = energy[0];
    start[2] = energy[1];
    range[0] = energy[0];
    range[1] = energy[0];
    range[2] = energy[1];
    range[3] = energy[1];
  }

  /**
   * Returns whether the balance is looked at after this step.
   *
   * @param known whether the work up to its end is known
   */
  boolean isDue(boolean last, boolean known) {
    sinceLook++;
    return model.isPresent() && (last || sinceLook >= (known ? STRIDE : 2 * STRIDE));
  }

  /**
   * Looks at the balance.
   *
   * @param t time, s
   * @param y state there; not modified
   * @param work work since the start, J; NaN where it is not known yet
   * @param turned energy added and removed since the start, J
   */
  void look(double t, double[] y, double work, double turned) {
    model.orElseThrow().energy(t, y, energy);
    look(t, energy[0], energy[1], work, turned);
  }

  /**
   * Looks at the balance where the energies are known.
   *
   * @param t time, s
   * @param kinetic kinetic energy, J
   * @param potential potential energy, J
   * @param work work since the start, J; NaN where it is not known yet
   * @param turned energy added and removed since the start, J
   */
  void look(double t, double kinetic, double potential, double work, double turned) {
    range[0] = Math.max(range[0], kinetic);
    range[1] = Math.min(range[1], kinetic);
    range[2] = Math.max(range[2], potential);
    range[3] = Math.min(range[3], potential);
    turnover = turned;
    unknown |= Double.isNaN(kinetic + potential + turned);
    sinceLook = 0;
    if (Double.isNaN(work)) {
      return;
    }
    double off = Math.abs(kinetic + potential - work - start[0]);
    double sizes = kinetic + Math.abs(potential) + turned + Math.abs(start[0]);
    rounding = Math.max(rounding, ROUNDING * sizes);
    if (off > rounding && off > GROWTH * drift && count < MOST_TIMES) {
      times[count] = t;
      drifts[count] = off;
      count++;
    }
    drift = Math.max(drift, off);
  }

  /** Returns by how much the energy is larger at another state, J; states are not modified. */
  double change(double t, double[] from, double[] to) {
    if (model.isEmpty()) {
      return 0;
    }
    model.get().energy(t, from, energy);
    double before = energy[0] + energy[1];
    model.get().energy(t, to, energy);
    return energy[0] + energy[1] - before;
  }

  private double moved() {
    double ranges = Math.max(range[0] - range[1], range[2] - range[3]);
    return Math.max(ranges, turnover / 2);
  }

  private double limit() {
    double accumulated = Math.min(MOST_PART, TOLERANCES * tolerance);
    double all = Math.max(range[0], Math.max(range[2] - start[2], start[2] - range[3]));
    double part = Math.max(LEAST_PART, accumulated);
    return Math.max(part * moved(), accumulated * Math.max(all, turnover / 2)) + rounding;
  }

  /** Returns the note that the balance is off, if it is. */
  Optional<Note> note() {
    double limit = limit();
    if (unknown || !(drift > limit)) {
      return Optional.empty();
    }
    int first = 0;
    while (first < count - 1 && drifts[first] <= limit) {
      first++;
    }
    double moved = moved();
    String text =
        "The energy balance is off, from about this time on, by up to "
            + (float) drift
            + " J, which is "
            + (float) (drift / moved)
            + " of the energy that has moved ("
            + (float) moved
            + " J): the integrator has missed a jump, a corner or a short pulse, or the"
            + " tolerances are too loose. Tighten them, or give the integrator a maxStep.";
    return Optional.of(new Note(MessageCode.ENERGY_BALANCE_OFF, times[first], true, text));
  }

  /** Saves or restores what was seen. */
  void transfer(SavedState state) {
    state.numbers(start);
    state.numbers(range);
    state.numbers(times);
    state.numbers(drifts);
    count = state.integer(count);
    drift = state.number(drift);
    rounding = state.number(rounding);
    turnover = state.number(turnover);
    unknown = state.flag(unknown);
    sinceLook = state.integer(sinceLook);
  }
}
