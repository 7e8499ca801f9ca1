package org.mechservice.solver.ode.events;

import org.mechservice.solver.ode.SavedState;

/**
 * Notices that events accumulate: that they follow each other at a distance that is no more than
 * round-off, without their functions leaving zero between, or at distances that shrink towards a
 * point close ahead, as the bounces of a ball do.
 */
final class AccumulationMonitor {
  private static final int IN_A_ROW = 20;

  /** Distance of two events, relative to t, that is hardly more than their uncertainty. */
  private static final double CHATTER = 1e-10;

  /** Distance of the point of accumulation ahead, relative to the time elapsed. */
  private static final double CLOSE_AHEAD = 1e-6;

  private double start;
  private double last;
  private double lastDistance;
  private int shrinking;
  private int chattering;

  void begin(double t0) {
    start = t0;
    last = t0;
    lastDistance = Double.POSITIVE_INFINITY;
    shrinking = 0;
    chattering = 0;
  }

  /**
   * Takes note of an event; returns whether it is one too many.
   *
   * @param stayedAtZero whether its function has not left zero since its last event
   */
  boolean accumulates(double t, boolean stayedAtZero) {
    double distance = Math.abs(t - last);
    double ahead = distance * distance / (lastDistance - distance);
    shrinking = distance < lastDistance ? shrinking + 1 : 0;
    boolean atOnce = distance <= CHATTER * Math.max(Math.abs(t), Math.abs(start));
    chattering = atOnce || stayedAtZero ? chattering + 1 : 0;
    last = t;
    lastDistance = distance;
    boolean near = ahead <= CLOSE_AHEAD * Math.abs(t - start);
    return chattering >= IN_A_ROW || (shrinking >= IN_A_ROW && near);
  }

  /** Returns the distance of the last event from the one before. */
  double distance() {
    return lastDistance;
  }

  /** Carries the events remembered over. */
  void transfer(SavedState state) {
    start = state.number(start);
    last = state.number(last);
    lastDistance = state.number(lastDistance);
    shrinking = state.integer(shrinking);
    chattering = state.integer(chattering);
  }
}
