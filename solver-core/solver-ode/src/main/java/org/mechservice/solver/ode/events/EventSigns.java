package org.mechservice.solver.ode.events;

import java.util.Arrays;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.events.EventFunctions.Direction;

/**
 * On which side of zero each event function is, so that an event is reported once.
 *
 * <p>A function is armed as soon as it is away from zero by its hysteresis; its next change of sign
 * is then an event. Until then it is known to be on one side, or on neither just after an event,
 * and must get that far on the other side. Near a zero just found, the uncertainty of that zero
 * takes the place of a smaller hysteresis.
 *
 * <p>A function that rests at exactly zero from the start on has its event where it leaves zero.
 * One that moves through zero at the start has none there.
 */
final class EventSigns {
  /** Round-off of a function in units of u times its largest value. */
  private static final double ROUNDOFFS = 16;

  /** Uncertainty of a zero in units of the difference of the values on both sides. */
  private static final double BLUR = 4;

  /**
   * How far behind zero, relative to its largest value, a function may be after a change of the
   * state that was not meant to move it: by closing loops, by a projection.
   */
  private static final double STILL_AT_ZERO = 1e-4;

  /** Steps after a change of the state in which a function that rests at zero can go on. */
  private static final int FIRST_STEPS = 10;

  private final EventFunctions functions;

  /** 1, −1, or 0 as long as the function was not away from zero. */
  private final int[] side;

  /** The side before the last event. */
  private final int[] sideBefore;

  private final boolean[] armed;

  /** Whether a function has rested at exactly zero from the start on. */
  private final boolean[] resting;

  /** In how many more steps the side is only assumed to be that before the event. */
  private final int[] provisional;

  /** Largest absolute value so far, and uncertainty of the zero found last. */
  private final double[] largest;

  private final double[] blur;

  EventSigns(EventFunctions functions) {
    this.functions = functions;
    side = new int[functions.count()];
    sideBefore = new int[functions.count()];
    armed = new boolean[functions.count()];
    resting = new boolean[functions.count()];
    provisional = new int[functions.count()];
    largest = new double[functions.count()];
    blur = new double[functions.count()];
  }

  /** Begins with the values at the start. */
  void begin(double[] g) {
    Arrays.fill(side, 0);
    Arrays.fill(sideBefore, 0);
    Arrays.fill(armed, false);
    Arrays.fill(resting, false);
    Arrays.fill(provisional, 0);
    Arrays.fill(largest, 0);
    Arrays.fill(blur, 0);
    observe(g);
  }

  /** Returns whether a function is away from zero on the side that an event of it leads to. */
  boolean behindEvent(int i) {
    return side[i] != 0 && leadsTo(i, side[i] > 0);
  }

  /** Returns whether an event of a function leads to the positive or the negative side. */
  private boolean leadsTo(int i, boolean positive) {
    Direction direction = functions.direction(i);
    return direction == Direction.EITHER || (direction == Direction.RISING) == positive;
  }

  /** Returns whether a value is an event of a function, given those observed before. */
  boolean event(int i, double g) {
    if (resting[i]) {
      return g != 0 && leadsTo(i, g > 0);
    }
    return beyond(i, g) && leadsTo(i, side[i] < 0);
  }

  /** Returns whether any value is an event. */
  boolean anyEvent(double[] g) {
    for (int i = 0; i < g.length; i++) {
      if (event(i, g[i])) {
        return true;
      }
    }
    return false;
  }

  /** Returns how far a function is from an event; negative or 0 behind it, 0 while it rests. */
  double distance(int i, double g) {
    return resting[i] ? -Math.abs(g) : g * side[i] + threshold(i);
  }

  /** Returns whether a function with this value, not at zero, has an event when it passes zero. */
  boolean awaitsEvent(int i, double g) {
    return (armed[i] && g * side[i] > 0) || Math.abs(g) > band(i);
  }

  /** Returns the distance from zero within which a function that turns back touches it. */
  double touchWidth(int i) {
    return Math.max(roundOff(i), functions.resolution() * largest[i]);
  }

  private boolean beyond(int i, double g) {
    return side[i] != 0 && (armed[i] ? g * side[i] <= 0 : g * side[i] < -threshold(i));
  }

  private double threshold(int i) {
    return armed[i] ? 0 : band(i);
  }

  private double band(int i) {
    return Math.max(noise(i), functions.hysteresis(i));
  }

  private double noise(int i) {
    return Math.max(blur[i], roundOff(i));
  }

  /** Returns the round-off of the values of a function. */
  double roundOff(int i) {
    return ROUNDOFFS * Math.ulp(1.0) * largest[i];
  }

  /** Takes note of values that are not events, or of functions not looked at in that direction. */
  void observe(double[] g) {
    for (int i = 0; i < g.length; i++) {
      observe(i, g[i]);
    }
  }

  private void observe(int i, double g) {
    resting[i] &= g == 0;
    if (beyond(i, g)) {
      side[i] = -side[i];
      armed[i] = false;
    }
    largest[i] = Math.max(largest[i], Math.abs(g));
    if (side[i] == 0 && Math.abs(g) > noise(i)) {
      side[i] = g > 0 ? 1 : -1;
    }
    if (g * side[i] > band(i)) {
      armed[i] = true;
      blur[i] = 0;
    }
  }

  /**
   * Returns whether any of the functions with an event has not been away from zero since its last
   * one by more than the uncertainty of that.
   */
  boolean anyStayedAtZero(boolean[] occurred) {
    for (int i = 0; i < occurred.length; i++) {
      if (occurred[i] && !armed[i] && noise(i) > functions.hysteresis(i)) {
        return true;
      }
    }
    return false;
  }

  /**
   * Takes note of an event.
   *
   * @param occurred functions that took part
   * @param atPole functions that have passed a pole instead; they are on the other side, and their
   *     values near it are no measure of their size
   * @param gBefore values just before it
   * @param gBehind values just behind it
   */
  void passed(boolean[] occurred, boolean[] atPole, double[] gBefore, double[] gBehind) {
    for (int i = 0; i < occurred.length; i++) {
      if (atPole[i]) {
        side[i] = -side[i];
        armed[i] = true;
        blur[i] = 0;
      } else if (occurred[i]) {
        sideBefore[i] = resting[i] ? gBehind[i] > 0 ? -1 : 1 : side[i];
        side[i] = -sideBefore[i];
        resting[i] = false;
        armed[i] = false;
        provisional[i] = 0;
        blur[i] = BLUR * Math.abs(gBehind[i] - gBefore[i]);
      } else {
        observe(i, gBehind[i]);
      }
    }
  }

  /** Returns whether a function has had an event since the start. */
  boolean hadEvent(int i) {
    return sideBefore[i] != 0;
  }

  /** Returns whether any function has been exactly zero since the start, moving or not. */
  boolean anyAtZeroSinceStart(double[] g) {
    for (int i = 0; i < g.length; i++) {
      if (atZeroSinceStart(i, g[i])) {
        return true;
      }
    }
    return false;
  }

  private boolean atZeroSinceStart(int i, double g) {
    return g == 0 && side[i] == 0 && sideBefore[i] == 0;
  }

  /**
   * Decides which functions that have been zero since the start rest there.
   *
   * @param g values at a place
   * @param ahead values further along the solution; zero ones show rest
   * @param anew whether earlier decisions are taken back
   */
  void judgeRest(double[] g, double[] ahead, boolean anew) {
    for (int i = 0; i < g.length; i++) {
      if (atZeroSinceStart(i, g[i])) {
        resting[i] = ahead[i] == 0 || (resting[i] && !anew);
      }
    }
  }

  /** Returns whether a function is known to be on neither side. */
  boolean isOpen(int i) {
    return side[i] == 0;
  }

  /**
   * Takes note of the values of a state that has just been changed at an event.
   *
   * <p>A function that had no event keeps its side: if the change has taken it to the other one,
   * its event is due at the next point looked at. A function that had one is open near zero, also a
   * little behind it, where {@link #lean} decides.
   */
  void place(boolean[] occurred, double[] g) {
    for (int i = 0; i < g.length; i++) {
      if (occurred[i]) {
        reopen(i, g[i]);
      } else if (!event(i, g[i])) {
        observe(i, g[i]);
      }
    }
  }

  private void reopen(int i, double g) {
    side[i] = 0;
    armed[i] = false;
    boolean behind = g * sideBefore[i] < 0;
    if (behind && Math.abs(g) <= STILL_AT_ZERO * largest[i]) {
      blur[i] = noise(i) + Math.abs(g);
    }
    observe(i, g);
  }

  /**
   * Takes note that values at one place differ. A function nearer to zero than such a difference
   * must first leave it by more.
   *
   * @param g values last observed
   * @param other values at the same place
   */
  void blur(double[] g, double[] other) {
    for (int i = 0; i < g.length; i++) {
      double unsure = BLUR * Math.abs(other[i] - g[i]);
      if (Math.abs(g[i]) <= unsure) {
        armed[i] = false;
        blur[i] = Math.max(blur[i], unsure);
      }
    }
  }

  /**
   * Decides by the way a function goes on which side it is on after an event that has changed the
   * state, where its value leaves that open. One that turns round must not pass zero unnoticed; one
   * that hardly moves counts as on the side before the event for some steps, so that it has another
   * event if it goes on at once.
   *
   * @param g values at the changed state
   * @param ahead values a little further along the solution
   */
  void lean(boolean[] occurred, double[] g, double[] ahead) {
    for (int i = 0; i < g.length; i++) {
      if (occurred[i] && side[i] == 0) {
        double way = ahead[i] - g[i];
        boolean back = way * sideBefore[i] > 0;
        boolean still = !back && Math.abs(way) <= roundOff(i);
        side[i] = back || still ? sideBefore[i] : -sideBefore[i];
        provisional[i] = still ? FIRST_STEPS : 0;
      }
    }
  }

  /** Returns whether the side of any function is only assumed. */
  boolean anyProvisional() {
    for (int steps : provisional) {
      if (steps > 0) {
        return true;
      }
    }
    return false;
  }

  /**
   * Takes note of the end of a step: sides assumed for long enough, or of functions that rest, are
   * open.
   *
   * @param g values there
   * @param ahead values further along the solution; equal ones show rest
   */
  void endStep(double[] g, double[] ahead) {
    for (int i = 0; i < side.length; i++) {
      if (provisional[i] > 0) {
        boolean rests = Math.abs(ahead[i] - g[i]) <= roundOff(i);
        provisional[i] = rests ? 0 : provisional[i] - 1;
        if (provisional[i] == 0 && !armed[i]) {
          side[i] = 0;
        }
      }
    }
  }

  /** Carries the sides over. */
  void transfer(SavedState state) {
    for (int i = 0; i < side.length; i++) {
      side[i] = state.integer(side[i]);
      sideBefore[i] = state.integer(sideBefore[i]);
      armed[i] = state.flag(armed[i]);
      resting[i] = state.flag(resting[i]);
      provisional[i] = state.integer(provisional[i]);
    }
    state.numbers(largest);
    state.numbers(blur);
  }
}
