package org.mechservice.client;

import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Set-up times of a run under the names of Rodríguez et al. 2003, in s.
 *
 * <ul>
 *   <li>{@code t1c}, {@code t1s}: sending and treating the model (parse, check, generate), as seen
 *       by the client and as spent in the server
 *   <li>{@code tcc}: compiling the generated class, in the server
 *   <li>{@code t2c}, {@code t2s}: making and fetching the JARs (local runs only)
 *   <li>{@code tR}, {@code tL}: all calls of the client from the first one until a remote or local
 *       run is ready to start
 * </ul>
 *
 * <p>The call that requests the run also generates and compiles the class. The server's own times
 * split that call into its shares.
 */
final class SetUpReport {
  private SetUpReport() {}

  /**
   * Returns the times of a remote run.
   *
   * @param load client time of sending the model, s
   * @param create client time of creating the simulation, s
   * @param run the server's times
   * @param total time of all calls, s
   */
  static Map<String, Object> remote(double load, double create, ServerTimes run, double total) {
    Map<String, Object> times = new LinkedHashMap<>();
    times.put("t1c", load + notNegative(create - run.compiling()));
    times.put("t1s", run.treating());
    times.put("tcc", run.compiling());
    times.put("tR", total);
    return times;
  }

  /**
   * Returns the times of a local run.
   *
   * @param load client time of sending the model, s
   * @param fetch client time of fetching the model JAR and the runtime JAR, s
   * @param run the server's times
   * @param total time of all calls and of loading the classes, s
   */
  static Map<String, Object> local(double load, double fetch, ServerTimes run, double total) {
    // A server that began to treat the model before the client requested the JAR makes the client
    // wait less than the sum of the server's own times.
    double jars =
        Math.max(fetch - run.treating() - run.compiling(), Math.min(fetch, run.packing()));
    Map<String, Object> times = new LinkedHashMap<>();
    times.put("t1c", load + Math.min(run.treating(), notNegative(fetch - jars - run.compiling())));
    times.put("t1s", run.treating());
    times.put("t2c", jars);
    times.put("t2s", run.packing());
    times.put("tcc", run.compiling());
    times.put("tL", total);
    return times;
  }

  /**
   * Returns a difference of times of two machines, at least 0, since their clocks differ slightly.
   */
  private static double notNegative(double seconds) {
    return Math.max(0, seconds);
  }
}
