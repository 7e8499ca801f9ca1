package org.mechservice.solver.simulation.equations;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.mechservice.solver.api.capability.Energies;
import org.mechservice.solver.api.capability.ModelEvents;
import org.mechservice.solver.api.capability.ModelEvents.Action;
import org.mechservice.solver.api.capability.ModelState;
import org.mechservice.solver.api.capability.MomentumBalance;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.api.run.RunNotes.Note;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.SavedSystem;
import org.mechservice.solver.ode.events.EventFunctions;
import org.mechservice.solver.ode.events.EventIntegration;
import org.mechservice.solver.ode.events.NoEventLog;

/** The events of a model in a run: it locates them, applies their actions and records them. */
final class WatchedRun extends RunEvents implements EventFunctions, ModelEvents.Path, SavedSystem {
  /** Largest number of events with their own note; only the number of the others is reported. */
  private static final int MOST_TOLD = 200;

  /**
   * Largest change by closing the loops of a component that an event sets, relative to its size or
   * one.
   */
  private static final double KEPT = 1e-8;

  private static final Path NO_WAY =
      new Path() {
        @Override
        public boolean moveTo(double t) {
          return false;
        }

        @Override
        public double[] state() {
          return new double[0];
        }
      };

  private final ModelEvents events;
  private final ModelEquations equations;
  private final String[] names;
  private final Action[] actions;
  private final double[] wanted;
  private final boolean[] set;
  private final double tolerance;
  private final NoEventLog noEvents;

  /** Number of times that each event has happened. */
  private final long[] counts;

  private final double[] after;
  private double afterTime = Double.NaN;
  private final double[] energy = new double[2];
  private final List<Occurrence> told = new ArrayList<>();
  private final List<Double> dueRows = new ArrayList<>();
  private long count;
  private int latest = -1;

  /** The solution along the step that is searched. */
  private Path way = NO_WAY;

  private int notFinite = -1;
  private double work;
  private Optional<Failure> failure = Optional.empty();
  private Optional<MomentumBalance> momentum = Optional.empty();

  /**
   * @param tolerance relative one of the run
   */
  WatchedRun(ModelEvents events, ModelEquations equations, double tolerance) {
    this.tolerance = tolerance;
    this.events = events;
    this.equations = equations;
    equations.follow(this);
    names = events.kinds().stream().map(ModelEvents.Kind::name).toArray(String[]::new);
    actions = events.kinds().stream().map(ModelEvents.Kind::action).toArray(Action[]::new);
    noEvents = new NoEventLog(names.length);
    counts = new long[names.length];
    wanted = new double[equations.dimension()];
    set = new boolean[wanted.length];
    after = new double[wanted.length];
  }

  /**
   * An event that has occurred.
   *
   * @param energy change of the energy by it and by events at the same time, J; NaN if there is
   *     none
   * @param byLoops part of that change due to closing the loops, J; likewise
   */
  private record Occurrence(int event, double time, double energy, double byLoops) {}

  @Override
  public Integrator watch(Integrator integrator) {
    return new EventIntegration(integrator, this);
  }

  @Override
  public void begin(double t, double[] y) {
    events.begin(t, y);
  }

  @Override
  public int count() {
    return names.length;
  }

  @Override
  public void evaluate(double t, double[] y, double[] g) {
    events.values(t, y, g);
    notFinite = -1;
    for (int i = 0; i < g.length && notFinite < 0; i++) {
      notFinite = Double.isFinite(g[i]) ? -1 : i;
    }
  }

  @Override
  public boolean searchesSteps() {
    return events.watches();
  }

  @Override
  public double seenUntil(double from, double to, Path path) {
    way = path;
    return events.seenUntil(from, to, this);
  }

  @Override
  public boolean moveTo(double t) {
    return way.moveTo(t);
  }

  @Override
  public double[] state() {
    return way.state();
  }

  @Override
  public boolean moveAcross(double t, double[] y, double[] yDot, double[] behind) {
    return events.moveAcross(t, y, yDot, behind);
  }

  @Override
  public double slidingSince() {
    return events.slidingSince();
  }

  @Override
  public double longestFirstStep() {
    return events.longestFirstStep();
  }

  @Override
  public Direction direction(int function) {
    return switch (events.kinds().get(function).direction()) {
      case RISING -> Direction.RISING;
      case FALLING -> Direction.FALLING;
      case BOTH -> Direction.EITHER;
    };
  }

  @Override
  public Reaction occurred(double t, double[] y, boolean[] occurred) {
    boolean samples = false;
    boolean sets = false;
    boolean stops = false;
    boolean records = false;
    for (int i = 0; i < occurred.length; i++) {
      if (occurred[i]) {
        Action action = actions[i];
        if (action == Action.BREAK) {
          latest = i;
          fail(motionJumps(t, part()));
          return Reaction.STOP;
        }
        if (action == Action.SAMPLE) {
          latest = i;
          samples = true;
          continue;
        }
        remember(i, t);
        sets |= action == Action.SET || action == Action.IMPULSE;
        stops |= action == Action.STOP;
        records |= action == Action.STOP || action == Action.RECORD;
      }
    }
    if (records) {
      dueRows.add(t);
    }
    if (stops || (sets && !change(t, y, occurred))) {
      return Reaction.STOP;
    }
    if (samples && !sets && !sample(t, y, occurred)) {
      return Reaction.STOP;
    }
    if (sets || samples) {
      System.arraycopy(y, 0, after, 0, after.length);
      afterTime = t;
      return Reaction.RESTART;
    }
    return Reaction.CONTINUE;
  }

  private void remember(int event, double t) {
    latest = event;
    count++;
    counts[event]++;
    if (told.size() < MOST_TOLD) {
      told.add(new Occurrence(event, t, Double.NaN, Double.NaN));
    }
  }

  /** Gives held states new values; positions and velocities stay. Returns false on failure. */
  private boolean sample(double t, double[] y, boolean[] occurred) {
    events.change(occurred, t, y);
    return isFinite(t, y);
  }

  private boolean isFinite(double t, double[] y) {
    for (int l = 0; l < y.length; l++) {
      if (!Double.isFinite(y[l])) {
        return fail(EventFailures.eventNotFinite(t, part(), equations.name(l)));
      }
    }
    return true;
  }

  /** Changes the state and closes the loops; returns false on failure. */
  private boolean change(double t, double[] y, boolean[] occurred) {
    double tBefore = events.evaluationTime(t);
    double tAfter = events.after(occurred, t);
    double before = energy(tBefore, y);
    double[] from = momentum.isPresent() ? y.clone() : y;
    events.change(occurred, tAfter, y);
    if (!isFinite(t, y)) {
      return false;
    }
    System.arraycopy(y, 0, wanted, 0, y.length);
    double open = energy(tAfter, y);
    for (int l = 0; l < y.length; l++) {
      set[l] = isSet(l, occurred);
    }
    if (!equations.closeLoopsAfterJump(tAfter, y, set)) {
      return fail(EventFailures.eventOpensLoops(t, part(), equations.obstacle()));
    }
    for (int l = 0; l < y.length; l++) {
      boolean kept = Math.abs(y[l] - wanted[l]) <= KEPT * (1 + Math.abs(wanted[l]));
      if (!kept && set[l]) {
        return fail(
            EventFailures.eventContradictsLoops(t, part(), equations.name(l), y[l], wanted[l]));
      }
    }
    momentum.ifPresent(balance -> balance.jump(tBefore, from, tAfter, y));
    double after = energy(tAfter, y);
    work += after - before;
    recordEnergy(after - before, Arrays.equals(y, wanted) ? Double.NaN : after - open);
    return true;
  }

  /** Adds the change of energy to the last recorded event. */
  private void recordEnergy(double change, double byLoops) {
    int last = told.size() - 1;
    if (count == told.size() && equations.model() instanceof Energies) {
      Occurrence one = told.get(last);
      told.set(last, new Occurrence(one.event(), one.time(), change, byLoops));
    }
  }

  private boolean isSet(int component, boolean[] occurred) {
    for (int i = 0; i < occurred.length; i++) {
      if (occurred[i] && events.changes(i, component)) {
        return true;
      }
    }
    return false;
  }

  /** Explains a prescribed position that jumps. */
  private static Failure motionJumps(double t, String joint) {
    return new Failure(
        MessageCode.DRIVEN_POSITION_JUMPS,
        "The position prescribed for a driven joint jumps, which no mechanism can follow.",
        t,
        0,
        0,
        joint,
        "End the run before, or write a motion that takes time, such as smoothStep((t-1)/0.1).");
  }

  private boolean fail(Failure why) {
    failure = Optional.of(why);
    return false;
  }

  private double energy(double t, double[] y) {
    if (equations.model() instanceof Energies able) {
      able.energy(t, y, energy);
    }
    return energy[0] + energy[1];
  }

  @Override
  double evaluationTime(double t) {
    return events.evaluationTime(t);
  }

  @Override
  public double resolution() {
    return tolerance;
  }

  @Override
  public void noEvent(int function, NoEvent why, double t, double value) {
    if (!isMotion(function) && actions[function] != Action.SAMPLE) {
      noEvents.note(function, why, t, value);
    }
  }

  @Override
  public boolean stateAfter(double t, double[] unknowns) {
    boolean changed = t == afterTime;
    if (changed) {
      System.arraycopy(after, 0, unknowns, 0, unknowns.length);
    }
    return changed;
  }

  @Override
  public void continueFrom(double t) {
    events.continueFrom(t);
  }

  @Override
  public void restarting(double t) {
    events.continueFrom(t);
  }

  @Override
  public double dueRow() {
    return dueRows.isEmpty() ? Double.POSITIVE_INFINITY : dueRows.get(0);
  }

  @Override
  public void rowWritten() {
    dueRows.remove(0);
  }

  @Override
  public double workOfEvents() {
    double taken = work;
    work = 0;
    return taken;
  }

  @Override
  public void setMomentumBalance(MomentumBalance balance) {
    momentum = Optional.of(balance);
  }

  @Override
  public Optional<Failure> failure() {
    return failure;
  }

  @Override
  public String part() {
    int event = notFinite >= 0 ? notFinite : latest;
    return event < 0 ? "" : kind(event) + " \"" + names[event] + "\"";
  }

  private String kind(int event) {
    return switch (actions[event]) {
      case IMPULSE, BREAK -> "joint";
      case SAMPLE -> "state";
      case STOP, RECORD, SET -> "event";
    };
  }

  private boolean isMotion(int event) {
    return actions[event] == Action.IMPULSE || actions[event] == Action.BREAK;
  }

  @Override
  public List<Note> notes() {
    List<Note> notes = new ArrayList<>(events.notes());
    for (NoEventLog.Entry entry : noEvents.entries()) {
      boolean passedLater = entry.why() == NoEvent.PASSED_AT_START && counts[entry.function()] > 0;
      if (!passedLater) {
        String text =
            "The expression of event \"" + names[entry.function()] + "\" " + entry.text() + ".";
        notes.add(new Note(MessageCode.EVENT_NOT_COUNTED, entry.time(), false, text));
      }
    }
    for (Occurrence one : told) {
      MessageCode code =
          isMotion(one.event()) ? MessageCode.DRIVEN_VELOCITY_JUMPED : MessageCode.EVENT_OCCURRED;
      notes.add(new Note(code, one.time(), false, described(one.event()) + energy(one) + "."));
    }
    if (count > told.size()) {
      Occurrence last = told.get(told.size() - 1);
      String text = (count - told.size()) + " more events after this time.";
      notes.add(new Note(MessageCode.EVENT_OCCURRED, last.time(), false, text));
    }
    return notes;
  }

  private String described(int event) {
    String name = "\"" + names[event] + "\"";
    return switch (actions[event]) {
      case STOP -> "Event " + name + " ends the run";
      case RECORD -> "Event " + name + " is recorded";
      case SAMPLE -> "State " + name + " is sampled";
      case SET -> "Event " + name + " changes the state";
      case IMPULSE ->
          "The velocity of driven joint "
              + name
              + " jumps, and the other velocities change by the impulse";
      case BREAK -> "The position of driven joint " + name + " jumps";
    };
  }

  private static String energy(Occurrence one) {
    if (Double.isNaN(one.energy())) {
      return "";
    }
    String change = String.format(Locale.ROOT, "; the energy changes by %.4g J", one.energy());
    return Double.isNaN(one.byLoops())
        ? change
        : change
            + String.format(
                Locale.ROOT, ", of that by %.4g J when the loops are closed again", one.byLoops());
  }

  @Override
  public void transfer(SavedState state) {
    if (events instanceof ModelState own) {
      ModelEquations.transfer(own, state);
    }
    for (int i = 0; i < names.length; i++) {
      state.require("event", names[i]);
      counts[i] = state.integer(counts[i]);
    }
    noEvents.transfer(state);
    count = state.integer(count);
    latest = state.integer(latest);
    afterTime = state.number(afterTime);
    state.numbers(after);
    int size = state.integer(told.size());
    for (int i = 0; i < size; i++) {
      Occurrence one = i < told.size() ? told.get(i) : new Occurrence(0, 0, 0, 0);
      Occurrence carried =
          new Occurrence(
              state.integer(one.event()),
              state.number(one.time()),
              state.number(one.energy()),
              state.number(one.byLoops()));
      if (state.restoring()) {
        told.add(carried);
      }
    }
  }
}
