package org.mechservice.sim.service.library;

import java.util.LinkedHashMap;
import java.util.Map;

/**
 * The set-up times of a session's models in this process, under the names of Rodríguez et al. 2003,
 * in s. A model from the cache takes no time.
 */
public final class SetUpTimes {
  private double treating;
  private double compiling;
  private double packing;

  /** Adds time spent reading, checking and generating (t1s). */
  public synchronized void addTreating(long nanos) {
    treating += nanos * 1e-9;
  }

  /** Adds time spent compiling (tcc). */
  synchronized void addCompiling(long nanos) {
    compiling += nanos * 1e-9;
  }

  /** Adds time spent making JARs (t2s). */
  public synchronized void addPacking(long nanos) {
    packing += nanos * 1e-9;
  }

  /** Returns the times by name. */
  public synchronized Map<String, Double> asMap() {
    Map<String, Double> times = new LinkedHashMap<>();
    times.put("t1s", treating);
    times.put("tcc", compiling);
    times.put("t2s", packing);
    return times;
  }
}
