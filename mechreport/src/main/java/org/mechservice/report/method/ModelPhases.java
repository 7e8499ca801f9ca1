package org.mechservice.report.method;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import org.mechservice.report.reference.Phases;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ModelEvents;
import org.mechservice.solver.api.capability.ModelEvents.Action;
import org.mechservice.solver.api.capability.ModelEvents.Direction;
import org.mechservice.solver.api.capability.ModelEvents.Kind;
import org.mechservice.solver.api.capability.StateJumps;
import org.mechservice.solver.api.run.RunSettings;

/**
 * A model's events for the reference codes: the model evaluates the event functions and changes the
 * state; the codes locate the zeros. Events that are only recorded do not divide a solution into
 * phases. Records the events of one solution.
 */
public final class ModelPhases implements Phases {
  /** Smallest number of points at which the event functions of a run are checked. */
  private static final int PLACES = 200;

  /** Largest change of a value that an event has set by closing the loops, relative to 1 + |y|. */
  private static final double KEPT = 1e-8;

  /** Number of successive, ever shorter phases after which events accumulate. */
  private static final int IN_A_ROW = 20;

  /** Distance of that point, or length of phases, beside the time elapsed. */
  private static final double NO_TIME = 1e-6;

  private final ModelEvents events;
  private final ModelProblem problem;
  private final List<Kind> kinds;
  private final int[] parting;
  private final double[] all;
  private final double[] closed;
  private final double start;
  private final double[] breaks;
  private final double longestStep;
  private final List<Double> jumps = new ArrayList<>();
  private String end = "";
  private double endTime = Double.POSITIVE_INFINITY;
  private int shrinking;
  private int behindBreaks;

  ModelPhases(ModelEvents events, ModelProblem problem) {
    this.events = events;
    this.problem = problem;
    RunSettings settings = problem.model().description().defaults();
    start = settings.tStart();
    breaks =
        events.begin(start, settings.tEnd()).stream()
            .mapToDouble(Double::doubleValue)
            .filter(t -> t > start && t < settings.tEnd())
            .sorted()
            .distinct()
            .toArray();
    kinds = events.kinds();
    parting =
        IntStream.range(0, kinds.size())
            .filter(i -> kinds.get(i).action() != Action.RECORD)
            .toArray();
    all = new double[kinds.size()];
    closed = new double[problem.dimension()];
    boolean ofState = Arrays.stream(parting).anyMatch(i -> !isMotion(kinds.get(i)));
    longestStep = ofState ? (settings.tEnd() - start) / PLACES : Double.POSITIVE_INFINITY;
  }

  private static boolean isMotion(Kind kind) {
    return kind.action() == Action.IMPULSE || kind.action() == Action.BREAK;
  }

  /**
   * Applies the samples that are due at the start.
   *
   * @param y state there; overwritten
   */
  void sample(double[] y) {
    events.begin(start, y);
  }

  /** Returns whether the state may jump, or the run end before its time. */
  public boolean isParted() {
    return parting.length > 0;
  }

  /** Returns the times at which the state has jumped. */
  public List<Double> jumps() {
    return List.copyOf(jumps);
  }

  /** Returns why the solution ended early, as a sentence; empty if it did not. */
  public String end() {
    return end;
  }

  /** Returns when that was, s; infinite if nothing did. */
  public double endTime() {
    return endTime;
  }

  /** Returns whether an event may end the solution early. */
  public boolean mayEnd() {
    return Arrays.stream(parting)
        .mapToObj(i -> kinds.get(i).action())
        .anyMatch(action -> action != Action.IMPULSE && action != Action.SAMPLE);
  }

  /** Returns the names of the events that may change the state. */
  public List<String> changing() {
    return kinds.stream()
        .filter(kind -> kind.action() == Action.SET || kind.action() == Action.IMPULSE)
        .map(kind -> (isMotion(kind) ? "the motion of joint \"" : "event \"") + kind.name() + '"')
        .distinct()
        .toList();
  }

  @Override
  public int count() {
    return parting.length;
  }

  @Override
  public boolean values(double t, double[] y, double[] g) {
    System.arraycopy(y, 0, closed, 0, closed.length);
    if (!problem.close(t, closed)) {
      return false;
    }
    events.values(t, closed, all);
    for (int i = 0; i < g.length; i++) {
      g[i] = all[parting[i]];
    }
    return Arrays.stream(g).allMatch(Double::isFinite);
  }

  @Override
  public boolean counts(int function, boolean rising) {
    Direction direction = kinds.get(parting[function]).direction();
    return direction == Direction.BOTH || (direction == Direction.RISING) == rising;
  }

  @Override
  public double longestStep() {
    return longestStep;
  }

  @Override
  public double nextBreak(double t) {
    return behindBreaks < breaks.length ? breaks[behindBreaks] : Double.POSITIVE_INFINITY;
  }

  @Override
  public boolean change(boolean[] passed, double t, double[] y) {
    boolean[] occurred = new boolean[kinds.size()];
    for (int i = 0; i < passed.length; i++) {
      occurred[parting[i]] = passed[i];
    }
    for (int i : parting) {
      Action action = kinds.get(i).action();
      if (occurred[i] && (action == Action.STOP || action == Action.BREAK)) {
        return ends(isMotion(kinds.get(i)) ? "the position of joint" : "event", i, t);
      }
    }
    if (!set(occurred, t, y)) {
      int first =
          IntStream.range(0, occurred.length).filter(i -> occurred[i]).findFirst().orElse(0);
      return ends("what cannot be done at event", first, t);
    }
    if (accumulates(t)) {
      endTime = t;
      end =
          String.format(
              Locale.ROOT,
              "Events accumulate at %.6g s, which no method can pass; the time before is judged.",
              t);
      return false;
    }
    jumps.add(t);
    return true;
  }

  private boolean ends(String what, int kind, double t) {
    endTime = t;
    end =
        String.format(
            Locale.ROOT,
            "The run ends at %.6g s, by %s \"%s\"; the time before is judged, short of an end that"
                + " another method may reach a little earlier.",
            t,
            what,
            kinds.get(kind).name());
    return false;
  }

  /** Applies the event's change of the state, and closes the loops as the model does. */
  private boolean set(boolean[] occurred, double t, double[] y) {
    double after = events.after(occurred, t);
    events.change(occurred, after, y);
    double[] wanted = y.clone();
    boolean[] set = new boolean[y.length];
    for (int k = 0; k < y.length; k++) {
      for (int i = 0; i < occurred.length; i++) {
        set[k] |= occurred[i] && events.changes(i, k);
      }
    }
    passBreaks(t);
    ExplicitModel model = problem.model();
    boolean closes =
        Arrays.stream(y).allMatch(Double::isFinite)
            && (model instanceof StateJumps loops
                ? loops.jump(after, y, set)
                : problem.close(after, y));
    for (int k = 0; k < y.length && closes; k++) {
      closes = !set[k] || Math.abs(y[k] - wanted[k]) <= KEPT * (1 + Math.abs(wanted[k]));
    }
    return closes;
  }

  /** Returns whether ever shorter phases converge to a time that is practically reached. */
  private boolean accumulates(double t) {
    double last = jumps.isEmpty() ? start : jumps.get(jumps.size() - 1);
    double before = jumps.size() < 2 ? start : jumps.get(jumps.size() - 2);
    double length = t - last;
    double lengthBefore = last - before;
    shrinking = length < lengthBefore ? shrinking + 1 : 0;
    double ahead = length * length / (lengthBefore - length);
    return shrinking >= IN_A_ROW && ahead <= NO_TIME * (t - start);
  }

  @Override
  public void continueFrom(double t) {
    events.continueFrom(t);
    passBreaks(t);
  }

  private void passBreaks(double t) {
    while (behindBreaks < breaks.length && breaks[behindBreaks] <= t) {
      behindBreaks++;
    }
  }

  /** Returns a time inside the present phase for one at its borders. */
  double within(double t) {
    double in = t;
    if (behindBreaks > 0 && in <= breaks[behindBreaks - 1]) {
      in = Math.nextUp(breaks[behindBreaks - 1]);
    }
    if (behindBreaks < breaks.length && in >= breaks[behindBreaks]) {
      in = Math.nextDown(breaks[behindBreaks]);
    }
    return events.evaluationTime(in);
  }
}
