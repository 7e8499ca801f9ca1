package org.mechservice.client.run;

import org.mechservice.client.failure.RunState;
import org.mechservice.idl.Progress;

/**
 * Progress of a run.
 *
 * @param state its state
 * @param queuePosition position in the host's queue, from 1; 0 if it is not queued
 * @param time simulated time reached, s
 * @param startTime start of the run, s
 * @param endTime end of the run, s
 * @param steps accepted steps
 * @param stepSize last accepted step, s
 * @param order order of the last accepted step
 * @param realTimeFactor simulated time over wall time since the start
 * @param rows result rows computed
 */
public record RunProgress(
    RunState state,
    int queuePosition,
    double time,
    double startTime,
    double endTime,
    long steps,
    double stepSize,
    int order,
    double realTimeFactor,
    long rows) {

  static RunProgress of(Progress info) {
    return new RunProgress(
        RunState.of(info.state),
        info.queuePosition,
        info.simTime,
        info.startTime,
        info.endTime,
        info.stepsDone,
        info.stepSize,
        info.stepOrder,
        info.realTimeFactor,
        info.rowsReady);
  }

  /** Returns the same progress with rows of an earlier host added. */
  RunProgress after(long rowsBefore) {
    return new RunProgress(
        state,
        queuePosition,
        time,
        startTime,
        endTime,
        steps,
        stepSize,
        order,
        realTimeFactor,
        rowsBefore + rows);
  }

  /** Returns the completed fraction of the interval, between 0 and 1. */
  public double fraction() {
    double interval = endTime - startTime;
    if (!(interval > 0) || Double.isNaN(time)) {
      return 0;
    }
    return Math.max(0, Math.min(1, (time - startTime) / interval));
  }
}
