package org.mechservice.solver.analysis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.IntStream;
import org.mechservice.solver.analysis.Trim.Condition;
import org.mechservice.solver.analysis.equation.EquationsOfMotion;
import org.mechservice.solver.api.capability.Defects;
import org.mechservice.solver.api.capability.Defects.Defect;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.run.RunNotes.Note;
import org.mechservice.solver.catalogue.ClosureMethod;
import org.mechservice.solver.catalogue.Formulation;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.catalogue.MethodNames;
import org.mechservice.solver.compact.CompactModel;
import org.mechservice.solver.compact.DataDriven;
import org.mechservice.solver.force.formula.ExpressionInputs;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.FurtherState;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Output;

/**
 * A state in which chosen quantities, accelerations, rates of further states and outputs, have
 * given values: r(x) = 0 for the chosen unknowns x, by Newton's method with a line search on |r|²
 * (Nocedal and Wright 2006, ch. 11). The derivatives are central differences of two steps,
 * extrapolated; {@link ScaledStep} solves the equations of a step.
 *
 * <p>Positions and velocities that loops tie to the unknowns follow by the least change. Everything
 * else keeps its value of the start.
 */
final class TrimPoint {
  /** Largest residual, as the change of unknowns that it needs, in their scales. */
  private static final double CLOSE = 1e-9;

  /** Step of unknowns, in their scales, below which the iteration ends. */
  private static final double SHORT = 1e-11;

  private static final int MOST_STEPS = 100;

  /** Shortest part of a step in the line search. */
  private static final double LEAST_PART = 1e-6;

  /** Largest move of a position in one step, rad or lengths of the mechanism. */
  private static final double MOST_TURN = 0.3;

  /** Difference for derivatives, in the scale of the unknown. */
  private static final double DIFFERENCE = 0x1p-14;

  /** Kinds of unknowns. */
  private enum Kind {
    POSITION,
    VELOCITY,
    STATE
  }

  /** An unknown: its kind and its number among velocities or further states. */
  private record Unknown(String name, Kind kind, int index) {}

  private final Mechanism mechanism;
  private final EquationsOfMotion equations;
  private final ExplicitModel model;
  private final CoordinateNames names;
  private final boolean atRest;
  private final List<Unknown> unknowns = new ArrayList<>();
  private final List<Condition> conditions;
  private final List<Output> outputs;
  private final ExpressionInputs outputValues;
  private final List<Note> notes = new ArrayList<>();
  private final double[] scale;
  private final double[] yDot;
  private double[] y;
  private Optional<Defect> defect = Optional.empty();
  private long iterations;

  /**
   * @param data the model
   * @param atRest whether all velocities are zero, for statics
   */
  TrimPoint(CompactModel data, UserForceSource userForces, Trim trim, boolean atRest) {
    this.atRest = atRest;
    mechanism = data.mechanism();
    equations = new EquationsOfMotion(mechanism, userForces);
    names = new CoordinateNames(mechanism);
    conditions = trim.conditions();
    outputs = data.outputs();
    outputValues =
        new ExpressionInputs(equations.motion, outputs.stream().map(Output::value).toList());
    boolean open = mechanism.closures().isEmpty();
    CompactModel free =
        new CompactModel(
            mechanism,
            Formulation.DSR.label(),
            open ? MethodNames.NONE : ClosureMethod.PROJECTION.label(),
            data.settings());
    model = (ExplicitModel) ModelParts.of(DataDriven.model(free, userForces)).equations();
    trim.unknowns().forEach(name -> unknowns.add(unknown(name)));
    scale = new double[unknowns.size()];
    y = new double[mechanism.stateCount()];
    yDot = new double[y.length];
  }

  private Unknown unknown(String name) {
    List<FurtherState> further = mechanism.furtherStates();
    for (int k = 0; k < further.size(); k++) {
      if (further.get(k).name().equals(name)) {
        return new Unknown(name, Kind.STATE, k);
      }
    }
    for (int j = 0; j < names.count(); j++) {
      if (names.of(j, "q").equals(name)) {
        return new Unknown(name, Kind.POSITION, j);
      }
      if (names.of(j, "v").equals(name)) {
        return new Unknown(name, Kind.VELOCITY, j);
      }
    }
    throw new IllegalArgumentException("there is no unknown " + name);
  }

  /** Returns the state found. */
  double[] state() {
    return y.clone();
  }

  /** Returns the accelerations of the state found, one per velocity. */
  double[] accelerations() {
    return Arrays.copyOfRange(yDot, equations.nq, equations.nq + equations.nv);
  }

  EquationsOfMotion equations() {
    return equations;
  }

  List<Note> notes() {
    return List.copyOf(notes);
  }

  /** Returns why no state was found. */
  Defect defect() {
    return defect.orElseThrow();
  }

  /** Returns the number of Newton steps. */
  long iterations() {
    return iterations;
  }

  /**
   * Finds the state nearest to the start by Newton's method.
   *
   * @param t time, s
   * @return whether one was found; if not, {@link #defect} says why
   */
  boolean find(double t) {
    model.initialState(y);
    if (atRest) {
      Arrays.fill(y, equations.nq, equations.nq + equations.nv, 0);
    }
    double[] r = new double[conditions.size()];
    if (!close(t, y) || !residual(t, y, r)) {
      return defect.isPresent() || notClosed();
    }
    double[] step = new double[unknowns.size()];
    double[] values = conditions.stream().mapToDouble(Condition::value).toArray();
    for (iterations = 0; ; iterations++) {
      scaleUnknowns();
      Optional<double[]> slopes = slopes(t);
      if (slopes.isEmpty()) {
        return false;
      }
      ScaledStep scaled = new ScaledStep(slopes.get(), r, values, scale);
      scaled.step(r, step);
      boolean arrived = scaled.residual(r) <= CLOSE;
      if (arrived && (longest(step) <= SHORT || iterations > 2)) {
        residual(t, y, r);
        note(scaled, t);
        return true;
      }
      double part = iterations < MOST_STEPS ? search(t, scaled, step, r) : 0;
      if (part == 0 && !arrived) {
        return notFound(scaled, r);
      }
    }
  }

  private void scaleUnknowns() {
    for (int j = 0; j < scale.length; j++) {
      Unknown unknown = unknowns.get(j);
      scale[j] =
          switch (unknown.kind()) {
            case POSITION -> equations.unit[unknown.index()];
            case VELOCITY ->
                Math.max(
                    equations.unit[unknown.index()], Math.abs(y[equations.nq + unknown.index()]));
            case STATE -> Math.max(1, Math.abs(y[mechanism.furtherOffset() + unknown.index()]));
          };
    }
  }

  /** Returns the longest move of an unknown, in its scale. */
  private double longest(double[] step) {
    double longest = 0;
    for (int j = 0; j < step.length; j++) {
      longest = Math.max(longest, Math.abs(step[j]) / scale[j]);
    }
    return longest;
  }

  /** Moves along the step by the longest part tried that reduces the residual; 0 if none does. */
  private double search(double t, ScaledStep scaled, double[] step, double[] r) {
    double turn = 0;
    for (int j = 0; j < step.length; j++) {
      boolean turns = unknowns.get(j).kind() == Kind.POSITION;
      turn = turns ? Math.max(turn, Math.abs(step[j]) / scale[j]) : turn;
    }
    double before = scaled.square(r);
    double[] ahead = new double[r.length];
    for (double part = Math.min(1, MOST_TURN / turn); part > LEAST_PART; part /= 2) {
      double[] tried = y.clone();
      move(tried, step, part);
      if (close(t, tried)
          && residual(t, tried, ahead)
          && scaled.square(ahead) < (1 - 1e-4 * part) * before) {
        y = tried;
        System.arraycopy(ahead, 0, r, 0, r.length);
        defect = Optional.empty();
        return part;
      }
    }
    return 0;
  }

  /** Moves the unknowns by a part of a step. */
  private void move(double[] state, double[] step, double part) {
    double[] xi = new double[equations.nv];
    for (int j = 0; j < step.length; j++) {
      int index = unknowns.get(j).index();
      switch (unknowns.get(j).kind()) {
        case POSITION -> xi[index] += step[j];
        case VELOCITY -> state[equations.nq + index] += part * step[j];
        case STATE -> state[mechanism.furtherOffset() + index] += part * step[j];
      }
    }
    equations.coordinates.move(state, 0, xi, 0, part);
  }

  /** Closes the loops in positions and velocities; returns whether they can be closed. */
  private boolean close(double t, double[] state) {
    if (mechanism.closures().isEmpty()) {
      return true;
    }
    boolean closed = equations.closePositions(t, state);
    if (closed && !atRest) {
      equations.place(t, state);
      equations.solveLeast(equations.loops.rate);
      for (int i = 0; i < equations.nv; i++) {
        state[equations.nq + i] += equations.step[i];
      }
    }
    return closed;
  }

  /** Evaluates the conditions less their values; returns whether all have a value. */
  private boolean residual(double t, double[] state, double[] r) {
    int result = model.derivative(t, state, yDot);
    if (result != ExplicitModel.REGULAR) {
      defect =
          Optional.of(
              result == Defects.DEFECT && model instanceof Defects defects
                  ? defects.lastDefect()
                  : new Defect(
                      MessageCode.SMALL_MOTION_WITHOUT_INERTIA,
                      result >= 0 ? names.part(Math.min(result, names.count() - 1)) : "",
                      "An acceleration is not defined, since no inertia resists it.",
                      "Give the bodies beyond this joint mass and inertia."));
      return false;
    }
    equations.motion.sweep(t, state);
    outputValues.evaluate(t);
    for (int i = 0; i < r.length; i++) {
      r[i] = value(conditions.get(i).name()) - conditions.get(i).value();
    }
    return true;
  }

  private double value(String name) {
    for (int i = 0; i < outputs.size(); i++) {
      if (outputs.get(i).name().equals(name)) {
        return outputValues.value(i);
      }
    }
    for (int j = 0; j < names.count(); j++) {
      if (names.of(j, "a").equals(name)) {
        return yDot[equations.nq + j];
      }
    }
    List<FurtherState> further = mechanism.furtherStates();
    for (int k = 0; k < further.size(); k++) {
      if (name.equals(further.get(k).name() + ".rate")) {
        return yDot[mechanism.furtherOffset() + k];
      }
    }
    throw new IllegalArgumentException("there is no quantity " + name);
  }

  /** Returns the derivatives of the conditions by the unknowns, row by row. */
  private Optional<double[]> slopes(double t) {
    int n = unknowns.size();
    double[] slopes = new double[conditions.size() * n];
    double[] plus = new double[conditions.size()];
    double[] minus = new double[conditions.size()];
    for (int j = 0; j < n; j++) {
      for (int pass = 0; pass < 2; pass++) {
        double h = scale[j] * DIFFERENCE / (pass + 1);
        if (!moved(t, j, h, plus) || !moved(t, j, -h, minus)) {
          return Optional.empty();
        }
        for (int i = 0; i < plus.length; i++) {
          double slope = (plus[i] - minus[i]) / (2 * h);
          slopes[i * n + j] = pass == 0 ? slope : slope + (slope - slopes[i * n + j]) / 3;
        }
      }
    }
    return Optional.of(slopes);
  }

  private boolean moved(double t, int unknown, double h, double[] r) {
    double[] state = y.clone();
    double[] step = new double[unknowns.size()];
    step[unknown] = 1;
    move(state, step, h);
    return (close(t, state) || notClosed()) && residual(t, state, r);
  }

  private boolean notClosed() {
    defect =
        Optional.of(
            new Defect(
                code(),
                "",
                "The loops cannot be closed where the unknowns lead.",
                "Start nearer to the state that is sought, or leave an unknown out."));
    return false;
  }

  private MessageCode code() {
    return atRest ? MessageCode.NO_EQUILIBRIUM : MessageCode.NO_TRIM;
  }

  /** States why no state was found; returns false. */
  private boolean notFound(ScaledStep scaled, double[] r) {
    int worst = scaled.worst(r);
    Condition missed = conditions.get(worst);
    List<String> dependent =
        IntStream.of(scaled.dependent())
            .mapToObj(i -> "\"" + conditions.get(i).name() + "\"")
            .toList();
    defect =
        Optional.of(
            new Defect(
                code(),
                "condition \"" + missed.name() + "\"",
                String.format(
                    Locale.ROOT,
                    "The conditions cannot be met: after %d steps \"%s\" is %.6g, and %.6g is"
                        + " asked.%s",
                    iterations,
                    missed.name(),
                    missed.value() + r[worst],
                    missed.value(),
                    dependent.isEmpty()
                        ? ""
                        : " Near there no unknown changes "
                            + (dependent.size() == 1 ? "" : "one of ")
                            + String.join(", ", dependent)
                            + (dependent.size() == 1 ? "." : " without the others.")),
                "Add an unknown that this depends on, leave a condition out, or start nearer to"
                    + " the state that is sought."));
    return false;
  }

  /** Notes unknowns that the conditions do not determine. */
  private void note(ScaledStep scaled, double t) {
    List<String> open =
        IntStream.of(scaled.undetermined())
            .mapToObj(j -> "\"" + unknowns.get(j).name() + "\"")
            .toList();
    if (!open.isEmpty()) {
      notes.add(
          new Note(
              atRest ? MessageCode.EQUILIBRIUM_NOT_UNIQUE : MessageCode.TRIM_NOT_UNIQUE,
              t,
              true,
              "The conditions do not determine "
                  + String.join(", ", open)
                  + "; the values nearest to the start were taken."));
    }
  }
}
