package org.mechservice.solver.ode.events;

/**
 * Finds the first event in an interval at whose end there is one, by the rule of false position in
 * the Illinois form: the end that stays counts half as much each time, and where that does not
 * halve the interval, bisection does.
 */
public final class EventSearch {
  /** Width of the interval that is left, relative to t and to the step. */
  private static final double ROUNDOFFS = 100 * Math.ulp(1.0);

  private static final double OF_STEP = 1e-12;

  /** The event functions along the solution. */
  interface Path {
    /** Evaluates the functions; returns false if that is not possible there. */
    boolean evaluate(double t, double[] g);
  }

  private final EventSigns signs;
  private double[] before;
  private double[] behind;
  private double[] middle;
  private double tBefore;
  private double tBehind;

  /** Weights of the two ends. */
  private double weightBefore;

  private double weightBehind;

  EventSearch(EventSigns signs, int count) {
    this.signs = signs;
    before = new double[count];
    behind = new double[count];
    middle = new double[count];
  }

  /** Returns the width to which an event can be located. */
  public static double width(double t, double stepSize) {
    return Math.max(ROUNDOFFS * Math.abs(t), OF_STEP * Math.abs(stepSize));
  }

  /**
   * Narrows an interval down to its first event.
   *
   * @param tFrom where it begins, with values that are no events
   * @param gFrom not modified
   * @param tTo where it ends, with values of which at least one is
   * @param gTo not modified
   * @param width of the interval left
   * @return false if the functions cannot be evaluated somewhere between
   */
  boolean locate(double tFrom, double[] gFrom, double tTo, double[] gTo, double width, Path path) {
    tBefore = tFrom;
    tBehind = tTo;
    System.arraycopy(gFrom, 0, before, 0, before.length);
    System.arraycopy(gTo, 0, behind, 0, behind.length);
    weightBefore = 1;
    weightBehind = 1;
    int slow = 0;
    while (Math.abs(tBehind - tBefore) > width) {
      double last = Math.abs(tBehind - tBefore);
      double t = slow < 2 ? proposal(width) : 0.5 * (tBefore + tBehind);
      if (t == tBefore || t == tBehind) {
        return true;
      }
      if (!path.evaluate(t, middle)) {
        return false;
      }
      narrow(t);
      slow = Math.abs(tBehind - tBefore) > 0.5 * last ? slow + 1 : 0;
    }
    return true;
  }

  /** The first zero of the straight lines between the ends, a little inside of them. */
  private double proposal(double width) {
    double first = 1;
    for (int i = 0; i < behind.length; i++) {
      if (signs.event(i, behind[i])) {
        double from = weightBefore * signs.distance(i, before[i]);
        double to = weightBehind * signs.distance(i, behind[i]);
        first = Math.min(first, from / (from - to));
      }
    }
    double length = tBehind - tBefore;
    double margin = Math.min(0.5, 0.5 * width / Math.abs(length));
    return tBefore + length * Math.max(margin, Math.min(1 - margin, first));
  }

  private void narrow(double t) {
    double[] freed = middle;
    if (signs.anyEvent(middle)) {
      middle = behind;
      behind = freed;
      tBehind = t;
      weightBehind = 1;
      weightBefore *= 0.5;
    } else {
      middle = before;
      before = freed;
      tBefore = t;
      weightBefore = 1;
      weightBehind *= 0.5;
    }
  }

  /** Returns where the event has happened. */
  double time() {
    return tBehind;
  }

  /** Returns the values just before the event; not to be modified. */
  double[] before() {
    return before;
  }

  /** Returns the values where the event has happened; not to be modified. */
  double[] behind() {
    return behind;
  }
}
