package org.mechservice.server;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.mechservice.idl.Progress;
import org.mechservice.idl.ServiceEvent;
import org.mechservice.idl.Severity;
import org.mechservice.idl.SimState;
import org.mechservice.idl.SimSummary;
import org.mechservice.sim.service.Happening;
import org.mechservice.sim.service.Journal;

/**
 * Follows by their events which runs go on on which host, so that it can be said what was lost with
 * a host that is gone.
 */
final class LostRuns {
  private static final int KEPT = 500;

  private final Journal journal;

  /** The last event of each run that has not ended, by its id. */
  private final Map<String, ServiceEvent> goingOn = new LinkedHashMap<>();

  private final Map<String, SimSummary> lost =
      new LinkedHashMap<>() {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, SimSummary> eldest) {
          return size() > KEPT;
        }
      };

  LostRuns(Journal journal) {
    this.journal = journal;
  }

  /** Notes what happened on a host. */
  synchronized void follow(ServiceEvent event) {
    switch (event.kind) {
      case "sim-queued", "sim-running", "sim-paused" -> {
        goingOn.put(event.simId, event);
        lost.remove(event.simId); // the host is back
      }
      case "sim-done", "sim-failed", "sim-cancelled" -> goingOn.remove(event.simId);
      default -> {
        // It is about something else.
      }
    }
  }

  /** Says what was lost with a host. */
  synchronized void lostWith(String hostName) {
    List<ServiceEvent> ofHost =
        goingOn.values().stream().filter(event -> event.hostName.equals(hostName)).toList();
    for (ServiceEvent last : ofHost) {
      goingOn.remove(last.simId);
      String text = "the simulation was lost with host " + hostName;
      lost.put(last.simId, summary(last, "S-113 " + text));
      journal.tell(
          new Happening(
              "sim-lost",
              Severity.SEV_ERROR,
              "S-113",
              hostName,
              last.sessionId,
              last.simId,
              last.owner,
              text));
    }
  }

  private static SimSummary summary(ServiceEvent last, String text) {
    Progress unknown = new Progress(last.simId, SimState.SIM_FAILED, 0, 0, 0, 0, 0, 0, 0, 0, 0);
    return new SimSummary(
        last.simId,
        last.sessionId,
        last.hostName,
        "",
        last.owner,
        unknown,
        last.happenedAt,
        last.happenedAt,
        System.currentTimeMillis(),
        0,
        text);
  }

  /** Returns what was lost lately, as administrators see it. */
  synchronized List<SimSummary> summaries() {
    return new ArrayList<>(lost.values());
  }

  /** Returns what became of a run, if it was lost. */
  synchronized Optional<String> fateOf(String simId) {
    return Optional.ofNullable(lost.get(simId)).map(summary -> summary.text.substring(6));
  }
}
