package org.mechservice.solver.mechanism;

import java.util.List;
import org.mechservice.solver.text.Origin;

/**
 * Further states that get new values at the times offset + k·period, k an integer: a controller in
 * a computer, whose outputs are constant between two samples (zero-order hold). All values are
 * those of the state before the sample.
 *
 * @param name name in the model file of the first state, for messages
 * @param period time between two samples, s; positive
 * @param offset time of a sample, s
 * @param changes the new values
 * @param origin position in the model file
 */
public record Sampling(
    String name, double period, double offset, List<FurtherChange> changes, Origin origin) {
  public Sampling {
    changes = List.copyOf(changes);
    if (!(period > 0) || Double.isInfinite(period) || !Double.isFinite(offset)) {
      throw new IllegalArgumentException(
          "a sampling has the period " + period + " s and the offset " + offset + " s");
    }
  }

  /** Returns the time of a sample, s. */
  public double time(long sample) {
    return offset + sample * period;
  }

  /** Returns the number of the last sample that is not after a time. */
  public long lastUntil(double t) {
    long near = Math.round((t - offset) / period);
    while (time(near) > t) {
      near--;
    }
    while (time(near + 1) <= t) {
      near++;
    }
    return near;
  }
}
