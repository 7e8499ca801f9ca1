package org.mechservice.client;

import java.util.HashMap;
import java.util.Map;
import org.mechservice.client.failure.ServerFailureException;
import org.mechservice.idl.NameValue;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * Times that a session has taken at the server so far.
 *
 * @param treating reading and checking the model and generating its class (t1s), s
 * @param compiling compiling generated classes (tcc), s
 * @param packing making JARs (t2s), s
 */
record ServerTimes(double treating, double compiling, double packing) {
  /** The times before the first call. */
  static final ServerTimes NONE = new ServerTimes(0, 0, 0);

  /**
   * Reads the server's answer; a time that is absent is none.
   *
   * @throws ServerFailureException if a time is no number
   */
  static ServerTimes of(NameValue[] timings) {
    Map<String, Double> times = new HashMap<>();
    for (NameValue timing : timings) {
      try {
        times.put(timing.key, Double.valueOf(timing.text));
      } catch (NumberFormatException e) {
        throw new ServerFailureException(
            MessageCode.ANSWER_NOT_UNDERSTOOD.code(),
            "the server's time " + timing.key + " is no number: " + timing.text,
            "");
      }
    }
    return new ServerTimes(
        times.getOrDefault("t1s", 0.0),
        times.getOrDefault("tcc", 0.0),
        times.getOrDefault("t2s", 0.0));
  }

  ServerTimes since(ServerTimes earlier) {
    return new ServerTimes(
        treating - earlier.treating, compiling - earlier.compiling, packing - earlier.packing);
  }
}
