package org.mechservice.solver.dynamics.event;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.api.capability.ModelEvents.Action;
import org.mechservice.solver.api.capability.ModelEvents.Direction;
import org.mechservice.solver.api.capability.ModelEvents.Kind;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.mechanism.Sampling;

/**
 * The samplings of a mechanism as events of a run. Each event function is the distance from the
 * nearest sample, with a sign that alternates from sample to sample; a step ends exactly at each
 * sample, where the function is zero.
 */
final class SampleTimes {
  /** Largest number of samples of a run: their times are kept. */
  private static final int MOST = 10_000_000;

  private final List<Sampling> samplings;

  SampleTimes(List<Sampling> samplings) {
    this.samplings = List.copyOf(samplings);
  }

  List<Kind> kinds() {
    return samplings.stream().map(s -> new Kind(s.name(), Direction.BOTH, Action.SAMPLE)).toList();
  }

  /** Writes one function per kind from {@code at}. */
  void values(double t, double[] g, int at) {
    for (int i = 0; i < samplings.size(); i++) {
      Sampling sampling = samplings.get(i);
      long last = sampling.lastUntil(t);
      double nearest = Math.min(t - sampling.time(last), sampling.time(last + 1) - t);
      g[at + i] = (last & 1) == 0 ? nearest : -nearest;
    }
  }

  /** Marks the samplings that have a sample at a time. */
  void mark(double t, boolean[] due, int at) {
    for (int i = 0; i < samplings.size(); i++) {
      Sampling sampling = samplings.get(i);
      due[at + i] = sampling.time(sampling.lastUntil(t)) == t;
    }
  }

  /**
   * Returns the times of all samples of an interval.
   *
   * @throws IllegalArgumentException S-196 if there are too many
   */
  List<Double> between(double from, double to) {
    List<Double> times = new ArrayList<>();
    for (Sampling sampling : samplings) {
      long first = sampling.lastUntil(from);
      long last = sampling.lastUntil(to);
      if (last - first > MOST - times.size()) {
        throw new IllegalArgumentException(
            MessageCode.SAMPLES_TOO_MANY
                + " the run would take more than "
                + MOST
                + " samples; \""
                + sampling.name()
                + "\" has a period of "
                + sampling.period()
                + " s: end the run earlier, or use a longer period");
      }
      for (long k = first; k <= last; k++) {
        times.add(sampling.time(k));
      }
    }
    return times;
  }
}
