package org.mechservice.sim.service.run;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.idl.CurveSample;

/**
 * The curves of step size, order, energy drift and constraint residual of one run, in bounded
 * memory.
 *
 * <p>Samples are collected in intervals of equal numbers of samples. An interval keeps the least
 * and the largest value of each quantity, so that a peak of a single sample stays visible however
 * long the run is. When there are too many intervals, neighbours are joined. Thread-safe.
 */
final class CurveHistory {
  /** Most intervals; each becomes two samples, which is more than a screen has columns for. */
  private static final int MOST_INTERVALS = 300;

  private static final int QUANTITIES = 4;

  private final List<Interval> intervals = new ArrayList<>();
  private final double[] latest = new double[QUANTITIES];
  private int samplesPerInterval = 1;
  private long samples;
  private long latestAt;
  private double latestTime = Double.NEGATIVE_INFINITY;

  /**
   * Adds a sample. A simulated time before that of the previous sample is raised to it: rows lie
   * inside the step that the solver has finished.
   *
   * @param at UTC, ms since 1970-01-01
   * @param time simulated time, s
   * @param stepSize s
   * @param energyDrift J; NaN if the run does not put it out
   * @param residual NaN if the run does not put it out
   */
  synchronized void add(
      long at, double time, double stepSize, int order, double energyDrift, double residual) {
    latestAt = at;
    latestTime = Math.max(latestTime, time);
    latest[0] = stepSize;
    latest[1] = order;
    latest[2] = energyDrift;
    latest[3] = residual;
    Interval last = intervals.isEmpty() ? null : intervals.get(intervals.size() - 1);
    if (last == null || last.count >= samplesPerInterval) {
      if (intervals.size() >= MOST_INTERVALS) {
        joinNeighbours();
      }
      last = new Interval(at, latestTime);
      intervals.add(last);
    }
    last.add(samples, at, latestTime, latest);
    samples++;
  }

  private void joinNeighbours() {
    List<Interval> joined = new ArrayList<>(MOST_INTERVALS);
    for (int i = 0; i < intervals.size(); i += 2) {
      Interval first = intervals.get(i);
      if (i + 1 < intervals.size()) {
        first.join(intervals.get(i + 1));
      }
      joined.add(first);
    }
    intervals.clear();
    intervals.addAll(joined);
    samplesPerInterval *= 2;
  }

  /**
   * Returns the curves, oldest first. Two samples stand for an interval: they hold the extremes of
   * each quantity in the order in which they occurred. The final sample is the latest one.
   */
  synchronized List<CurveSample> samples() {
    List<CurveSample> curve = new ArrayList<>();
    for (Interval interval : intervals) {
      interval.writeTo(curve);
    }
    if (samplesPerInterval > 1) {
      curve.add(sample(latestAt, latestTime, latest));
    }
    return curve;
  }

  private static CurveSample sample(long at, double time, double[] values) {
    return new CurveSample(at, time, values[0], (int) values[1], values[2], values[3]);
  }

  /** Successive samples, of which the extremes are kept. */
  private static final class Interval {
    private final long firstAt;
    private final double firstTime;
    private final double[] low = new double[QUANTITIES];
    private final double[] high = new double[QUANTITIES];

    /** Number of the sample that holds the extreme of each quantity. */
    private final long[] lowSample = new long[QUANTITIES];

    private final long[] highSample = new long[QUANTITIES];
    private long lastAt;
    private double lastTime;
    private int count;

    Interval(long at, double time) {
      firstAt = at;
      firstTime = time;
    }

    void add(long sample, long at, double time, double[] values) {
      for (int i = 0; i < QUANTITIES; i++) {
        includeLow(i, count == 0, values[i], sample);
        includeHigh(i, count == 0, values[i], sample);
      }
      lastAt = at;
      lastTime = time;
      count++;
    }

    void join(Interval later) {
      for (int i = 0; i < QUANTITIES; i++) {
        includeLow(i, false, later.low[i], later.lowSample[i]);
        includeHigh(i, false, later.high[i], later.highSample[i]);
      }
      lastAt = later.lastAt;
      lastTime = later.lastTime;
      count += later.count;
    }

    private void includeLow(int i, boolean first, double value, long sample) {
      if (first || value < low[i] || Double.isNaN(low[i])) {
        low[i] = value;
        lowSample[i] = sample;
      }
    }

    private void includeHigh(int i, boolean first, double value, long sample) {
      if (first || value > high[i] || Double.isNaN(high[i])) {
        high[i] = value;
        highSample[i] = sample;
      }
    }

    void writeTo(List<CurveSample> curve) {
      double[] earlier = new double[QUANTITIES];
      double[] later = new double[QUANTITIES];
      for (int i = 0; i < QUANTITIES; i++) {
        boolean lowIsEarlier = lowSample[i] <= highSample[i];
        earlier[i] = lowIsEarlier ? low[i] : high[i];
        later[i] = lowIsEarlier ? high[i] : low[i];
      }
      curve.add(sample(firstAt, firstTime, earlier));
      if (count > 1) {
        curve.add(sample(lastAt, lastTime, later));
      }
    }
  }
}
