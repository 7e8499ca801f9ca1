package org.mechservice.solver.ode.events;

import java.util.Arrays;
import org.mechservice.solver.ode.CompletedSystem;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.SavedSystem;
import org.mechservice.solver.ode.SystemParts;
import org.mechservice.solver.ode.events.EventFunctions.NoEvent;
import org.mechservice.solver.ode.step.RightHandSide;

/**
 * Values of event functions along the last step of an integrator, and which of them change sign.
 */
final class EventValues implements EventFunctions.Path {
  /** Part of what is left of the problem by which to look ahead after a restart. */
  private static final double LOOK_AHEAD = Math.sqrt(Math.ulp(1.0));

  /** The same after each of the first steps, to tell what rests from what is slow. */
  private static final double LOOK_FAR_AHEAD = Math.sqrt(LOOK_AHEAD);

  /** The same within the first step, in units of the time since the start. */
  private static final double FIRST_STEPS_AHEAD = 5;

  private final Integrator integrator;
  private final EventFunctions functions;
  private final EventSigns signs;
  private final EventSearch search;
  private final EventSearch.Path path = this::evaluate;
  private final TurnSearch turns;
  private final boolean[] occurred;
  private final boolean[] atPole;
  private final boolean[] zeroAtStart;

  private CompletedSystem completed = CompletedSystem.NOTHING_PASSIVE;

  /** Where the problem begins and ends, and whether the first step is not over. */
  private double start;

  private double tEnd;
  private boolean inFirstStep;

  /** Where the steps began last, and the state there. */
  private double beginning = Double.NaN;

  private double[] atBeginning = {};

  /** Whether the last step is the first one from there, its end, and by what it is moved there. */
  private boolean joined;

  private double joinedUntil;
  private double[] offset = {};

  /** The point looked at. */
  private double place;

  /** Values at the points searched last and next. */
  private double[] before;

  private double[] here;

  /** State and derivative at the point looked at. */
  private double[] y = {};

  private double[] yDot = {};

  EventValues(Integrator integrator, EventFunctions functions) {
    this.integrator = integrator;
    this.functions = functions;
    int count = functions.count();
    signs = new EventSigns(functions);
    search = new EventSearch(signs, count);
    turns = new TurnSearch(signs, functions, path);
    occurred = new boolean[count];
    atPole = new boolean[count];
    zeroAtStart = new boolean[count];
    before = new double[count];
    here = new double[count];
  }

  /** Prepares for a problem. */
  void prepare(SystemParts system, int dimension, double tEnd) {
    completed = system.part(CompletedSystem.class).orElse(CompletedSystem.NOTHING_PASSIVE);
    y = new double[dimension];
    yDot = new double[dimension];
    atBeginning = new double[dimension];
    offset = new double[dimension];
    joined = false;
    this.tEnd = tEnd;
  }

  /** Forgets which functions changed sign. */
  void forget() {
    Arrays.fill(occurred, false);
  }

  /** Takes note of how the functions stand where the problem begins. */
  void judgeStart() {
    for (int i = 0; i < zeroAtStart.length; i++) {
      zeroAtStart[i] = before[i] == 0;
      if (functions.direction(i) != EventFunctions.Direction.EITHER && signs.behindEvent(i)) {
        functions.noEvent(i, NoEvent.PASSED_AT_START, start, before[i]);
      }
    }
  }

  /**
   * Tells of the functions that were zero at the start and have left it without an event where
   * events of theirs would have led.
   */
  void reportZerosLeft() {
    for (int i = 0; i < zeroAtStart.length; i++) {
      if (zeroAtStart[i] && signs.behindEvent(i) && !signs.hadEvent(i)) {
        functions.noEvent(i, NoEvent.ZERO_AT_START, start, 0);
      }
      zeroAtStart[i] &= signs.isOpen(i);
    }
  }

  /** Takes note of where and in which state steps begin anew. */
  void stepsBegin(double t, double[] state) {
    beginning = t;
    System.arraycopy(state, 0, atBeginning, 0, atBeginning.length);
  }

  /**
   * Takes note of a step. The interpolated solution of the first one need not begin in the very
   * state that it was restarted from, and so may begin on the other side of a change of the
   * equations: where steps are searched it is moved there, by less towards the end of the step.
   */
  void joinStep(double from, double to) {
    joined = functions.searchesSteps() && from == beginning && from != to;
    if (joined) {
      joinedUntil = to;
      integrator.interpolate(from, y, yDot);
      for (int l = 0; l < y.length; l++) {
        offset[l] = atBeginning[l] - y[l];
      }
    }
  }

  /** Takes note that there is no step. */
  void leaveStep() {
    joined = false;
  }

  /** Begins at a state without history; returns false if something is not finite. */
  boolean begin(double t) {
    start = t;
    inFirstStep = true;
    boolean finite = evaluate(t, before);
    if (finite) {
      signs.begin(before);
    }
    return finite;
  }

  /**
   * Takes note of where the solution begins when it is interpolated in the first step after a
   * restart: not quite in the state it was restarted from. Returns false if something is not finite
   * there.
   */
  boolean join(double t) {
    boolean finite = evaluate(t, here);
    if (finite) {
      signs.blur(before, here);
    }
    return finite;
  }

  /**
   * Evaluates the functions along a step and returns the points at which to look at it, in their
   * order: those given, and others at which a function is seen to have crossed zero between.
   *
   * @param parts of the step, up to 1; not modified
   */
  int survey(double begin, double end, double[] parts) {
    turns.survey(begin, end, parts, before);
    return turns.pointCount();
  }

  /** Returns a point at which to look at the step, from 0 on. */
  double point(int index) {
    return turns.point(index);
  }

  /** Looks at a point; returns false if something is not finite. */
  boolean lookAt(double t) {
    place = t;
    return turns.known(t, here) || evaluate(t, here);
  }

  /** Returns whether there is an event up to the point looked at. */
  boolean anyEvent() {
    return signs.anyEvent(here);
  }

  /** Goes on from the point looked at. */
  void moveOn() {
    signs.observe(here);
    swap();
    if (inFirstStep && signs.anyAtZeroSinceStart(before)) {
      lookAlong(place, LOOK_FAR_AHEAD * (tEnd - place) + FIRST_STEPS_AHEAD * (place - start));
      signs.judgeRest(before, here, true);
    }
  }

  private void swap() {
    double[] freed = before;
    before = here;
    here = freed;
  }

  /**
   * Locates the first event between two points; returns false if something is not finite.
   *
   * @param width to which it is located
   */
  boolean locate(double from, double to, double width) {
    boolean located = search.locate(from, before, to, here, width, path);
    if (located) {
      double[] behind = search.behind();
      for (int i = 0; i < occurred.length; i++) {
        occurred[i] = signs.event(i, behind[i]);
      }
      search.findPoles(occurred, from, to, width, path, atPole);
    }
    return located;
  }

  /** Returns where the event is. */
  double time() {
    return search.time();
  }

  /**
   * Determines which functions have changed sign there through zero, and the state, which is
   * copied; tells of those that have a pole there. Returns whether there are any of the first.
   */
  boolean determine(double[] state) {
    boolean any = false;
    for (int i = 0; i < occurred.length; i++) {
      occurred[i] &= !atPole[i];
      any |= occurred[i];
      if (atPole[i]) {
        functions.noEvent(i, NoEvent.POLE, search.time(), search.behind()[i]);
      }
    }
    evaluate(search.time(), here);
    System.arraycopy(y, 0, state, 0, y.length);
    return any;
  }

  /** Returns which functions have changed sign in the last event; not to be modified. */
  boolean[] occurred() {
    return occurred;
  }

  /** Returns whether one of them has not left zero since its last event; before {@link #pass}. */
  boolean anyStayedAtZero() {
    return signs.anyStayedAtZero(occurred);
  }

  /** Goes on from the event. */
  void pass() {
    signs.passed(occurred, atPole, search.before(), search.behind());
    swap();
  }

  /**
   * Goes on from the event with a state that may be another; returns false if a function is not
   * finite there.
   *
   * @param moved whether it is another
   */
  boolean goOnFrom(double t, double[] state, boolean moved) {
    functions.evaluate(t, state, before);
    if (RightHandSide.firstNotFinite(before) >= 0) {
      return false;
    }
    if (moved) {
      signs.place(occurred, before);
    }
    return true;
  }

  /** Returns whether a state is that of the point looked at. */
  boolean standsAt(double[] state) {
    return Arrays.equals(state, y);
  }

  /** Sees which way the functions go on from a state that was changed. */
  void lookAhead(double t, double tEnd) {
    lookAlong(t, LOOK_AHEAD * (tEnd - t));
    signs.lean(occurred, before, here);
  }

  /** Takes note of the end of a step. */
  void endStep(double t, double tEnd) {
    if (signs.anyProvisional() || signs.anyAtZeroSinceStart(before)) {
      lookAlong(t, LOOK_FAR_AHEAD * (tEnd - t));
      signs.judgeRest(before, here, false);
      signs.endStep(before, here);
    }
    inFirstStep = false;
  }

  /** Evaluates the functions on the tangent of the solution, or where that begins. */
  private void lookAlong(double t, double stretch) {
    integrator.interpolate(t, y, yDot);
    for (int l = 0; l < y.length; l++) {
      y[l] += stretch * yDot[l];
    }
    if (completed.complete(t + stretch, y)) {
      functions.evaluate(t + stretch, y, here);
    } else {
      System.arraycopy(before, 0, here, 0, here.length);
    }
  }

  private boolean evaluate(double t, double[] g) {
    if (!moveTo(t)) {
      return false;
    }
    functions.evaluate(t, y, g);
    return RightHandSide.firstNotFinite(g) < 0;
  }

  @Override
  public boolean moveTo(double t) {
    integrator.interpolate(t, y, yDot);
    if (joined) {
      double share = (joinedUntil - t) / (joinedUntil - beginning);
      for (int l = 0; l < y.length; l++) {
        y[l] += share * offset[l];
      }
    }
    return completed.complete(t, y);
  }

  @Override
  public double[] state() {
    return y;
  }

  /** Returns where a step has to end so that nothing has happened in it unseen, or NaN. */
  double seenUntil(double from, double to) {
    return functions.seenUntil(from, to, this);
  }

  /** Moves the state at the end of the last step across a change within rounding, if any. */
  boolean moveAcross(double t, double[] behind) {
    return moveTo(t) && functions.moveAcross(t, y, yDot, behind);
  }

  /** Goes to where the step is cut off, and copies the state; returns false if that fails. */
  boolean stopAt(double t, double[] state) {
    boolean possible = moveTo(t);
    System.arraycopy(y, 0, state, 0, y.length);
    return possible;
  }

  /** Carries the values between two steps over. */
  void transfer(SavedState state) {
    state.require("number of event functions", occurred.length);
    signs.transfer(state);
    turns.transfer(state);
    start = state.number(start);
    inFirstStep = state.flag(inFirstStep);
    beginning = state.number(beginning);
    state.numbers(atBeginning);
    state.numbers(before);
    for (int i = 0; i < occurred.length; i++) {
      occurred[i] = state.flag(occurred[i]);
      zeroAtStart[i] = state.flag(zeroAtStart[i]);
    }
    if (functions instanceof SavedSystem saved) {
      saved.transfer(state);
    }
  }
}
