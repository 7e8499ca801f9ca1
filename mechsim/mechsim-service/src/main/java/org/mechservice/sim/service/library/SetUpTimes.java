package org.mechservice.sim.service.library;

import java.util.LinkedHashMap;
import java.util.Map;

/**
 * The set-up times of a session's models in this process, under the names of Rodríguez et al. 2003,
 * in s. A model from the cache takes no time.
 */
public final class SetUpTimes {
  /**
   * Times of one call, ns.
   *
   * @param treating reading, checking and generating
   * @param compiling compiling
   * @param packing making JARs
   */
  public record Spent(long treating, long compiling, long packing) {}

  private long treating;
  private long compiling;
  private long packing;

  /** Adds the times of a call. */
  public synchronized void add(Spent spent) {
    treating += spent.treating();
    compiling += spent.compiling();
    packing += spent.packing();
  }

  /** Returns the times so far. */
  public synchronized Spent spent() {
    return new Spent(treating, compiling, packing);
  }

  /** Adds time spent reading, checking and generating (t1s). */
  public synchronized void addTreating(long nanos) {
    treating += nanos;
  }

  /** Adds time spent compiling (tcc). */
  synchronized void addCompiling(long nanos) {
    compiling += nanos;
  }

  /** Adds time spent making JARs (t2s). */
  public synchronized void addPacking(long nanos) {
    packing += nanos;
  }

  /** Returns the times by name. */
  public synchronized Map<String, Double> asMap() {
    Map<String, Double> times = new LinkedHashMap<>();
    times.put("t1s", treating * 1e-9);
    times.put("tcc", compiling * 1e-9);
    times.put("t2s", packing * 1e-9);
    return times;
  }
}
