package org.mechservice.admin;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.admin.AdminFailure.Reason;
import org.mechservice.idl.SimState;
import org.mechservice.idl.SimSummary;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * A simulation and the server that lists it.
 *
 * @param server address of the server
 * @param summary the server's summary of it
 */
public record KnownSimulation(String server, SimSummary summary) {
  /** A prefix of this length identifies a simulation in practice and is quick to type. */
  private static final int SHORTEST_PREFIX = 4;

  private static final String[] STATES = {
    "created", "queued", "running", "paused", "done", "failed", "cancelled"
  };

  /** Returns the words for the states of a simulation. */
  public static List<String> states() {
    return List.of(STATES);
  }

  /** Returns the word for a state. */
  static String label(SimState state) {
    return STATES[state.value()];
  }

  /** Returns the word for its state. */
  public String state() {
    return label(summary.info.state);
  }

  /** Returns whether it has not ended. */
  public boolean isUnfinished() {
    return summary.info.state.value() < SimState._SIM_DONE;
  }

  /** Returns the share of the simulated time it has done, 0 to 1. */
  public double progress() {
    double length = summary.info.endTime - summary.info.startTime;
    double done = (summary.info.simTime - summary.info.startTime) / length;
    if (summary.info.state == SimState.SIM_DONE) {
      return 1;
    }
    return Double.isFinite(done) ? Math.max(0, Math.min(1, done)) : 0;
  }

  /**
   * Returns the simulations of all servers that answered, oldest first. A host may serve several
   * servers: what it runs is listed once.
   */
  public static List<KnownSimulation> all(List<ServerReading> readings) {
    Map<String, KnownSimulation> byId = new LinkedHashMap<>();
    for (ServerReading reading : readings) {
      if (reading instanceof ServerReading.Answering answering) {
        for (SimSummary summary : answering.simulations()) {
          byId.merge(
              summary.simId,
              new KnownSimulation(reading.address(), summary),
              KnownSimulation::betterInformed);
        }
      }
    }
    List<KnownSimulation> all = new ArrayList<>(byId.values());
    all.sort(
        Comparator.comparingLong((KnownSimulation known) -> known.summary.createdAt)
            .thenComparing(known -> known.summary.simId));
    return all;
  }

  /** A server that is in contact with a host knows more of its simulations than one that is not. */
  private static KnownSimulation betterInformed(KnownSimulation first, KnownSimulation second) {
    return first.notUpToDate() && !second.notUpToDate() ? second : first;
  }

  private boolean notUpToDate() {
    return summary.text.startsWith(MessageCode.SIMULATION_LOST + " ")
        || summary.text.contains("is silent since");
  }

  /**
   * Returns the simulation whose id begins with some characters.
   *
   * @param id the id, or at least its first four characters
   * @throws AdminFailure if there is none (S-130) or more than one (S-131)
   */
  public static KnownSimulation find(List<ServerReading> readings, String id) {
    List<KnownSimulation> found =
        all(readings).stream()
            .filter(known -> known.summary.simId.equals(id))
            .findFirst()
            .map(List::of)
            .orElseGet(() -> beginningWith(readings, id));
    if (found.size() > 1) {
      throw new AdminFailure(
          Reason.NOT_USABLE,
          MessageCode.AMBIGUOUS_NAME
              + " "
              + found.size()
              + " simulations have an id that begins with "
              + PlainText.of(id)
              + "; write more of it");
    } else if (found.isEmpty()) {
      throw AdminTarget.notFound("simulation " + PlainText.of(id), List.of(), readings);
    }
    return found.get(0);
  }

  private static List<KnownSimulation> beginningWith(List<ServerReading> readings, String id) {
    return id.length() < SHORTEST_PREFIX
        ? List.of()
        : all(readings).stream().filter(known -> known.summary.simId.startsWith(id)).toList();
  }
}
