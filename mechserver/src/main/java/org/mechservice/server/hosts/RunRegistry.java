package org.mechservice.server.hosts;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.mechservice.idl.CurveSample;
import org.mechservice.idl.FailureRecord;
import org.mechservice.idl.Progress;
import org.mechservice.idl.ServiceEvent;
import org.mechservice.idl.Severity;
import org.mechservice.idl.SimDetail;
import org.mechservice.idl.SimEvent;
import org.mechservice.idl.SimState;
import org.mechservice.idl.SimSummary;
import org.mechservice.idl.StepTried;
import org.mechservice.sim.service.contract.Journal;
import org.mechservice.sim.service.contract.JournalEntry;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * The last known state of all runs of a server's hosts. Administrators see it for hosts that do not
 * answer; for hosts that are gone it is the only record of their runs. Thread-safe.
 */
public final class RunRegistry {
  /** Runs of hosts that are gone. */
  private static final int GONE_KEPT = 2000;

  private static final int DETAILS_KEPT = 500;
  private static final int LONGEST_MODEL = 1 << 18;
  private static final String LOST = MessageCode.SIMULATION_LOST.code();

  /** Of one host. */
  private static final class Page {
    private Map<String, SimSummary> runs = new LinkedHashMap<>();

    /** Runs whose state has changed and whose details are not fetched yet. */
    private final Set<String> unread = new LinkedHashSet<>();

    /** When the list was requested from the host, by {@link System#nanoTime}. */
    private long askedAt = Long.MIN_VALUE;

    private long listedAt;
    private boolean changed;
  }

  private final Journal journal;
  private final Map<String, Page> pages = new HashMap<>();
  private final Map<String, SimSummary> gone = new Latest<>(GONE_KEPT);
  private final Map<String, SimDetail> details = new Latest<>(DETAILS_KEPT);

  private static final class Latest<T> extends LinkedHashMap<String, T> {
    private static final long serialVersionUID = 1L;
    private final int kept;

    Latest(int kept) {
      this.kept = kept;
    }

    @Override
    protected boolean removeEldestEntry(Map.Entry<String, T> eldest) {
      return size() > kept;
    }
  }

  RunRegistry(Journal journal) {
    this.journal = journal;
  }

  private Page page(String hostName) {
    return pages.computeIfAbsent(hostName, unused -> new Page());
  }

  /** Applies an event of a host. */
  synchronized void follow(ServiceEvent event) {
    Optional<SimState> state = stateAfter(event.kind);
    if (state.isEmpty()) {
      return;
    }
    Page page = page(event.hostName);
    page.changed = true;
    page.runs.put(event.simId, after(event, state.get(), page.runs.get(event.simId)));
    gone.remove(event.simId); // the host is back
    if (state.get() != SimState.SIM_QUEUED && state.get() != SimState.SIM_PAUSED) {
      page.unread.add(event.simId);
    }
  }

  private static Optional<SimState> stateAfter(String kind) {
    return switch (kind) {
      case "sim-queued" -> Optional.of(SimState.SIM_QUEUED);
      case "sim-running" -> Optional.of(SimState.SIM_RUNNING);
      case "sim-paused" -> Optional.of(SimState.SIM_PAUSED);
      case "sim-done" -> Optional.of(SimState.SIM_DONE);
      case "sim-failed" -> Optional.of(SimState.SIM_FAILED);
      case "sim-cancelled" -> Optional.of(SimState.SIM_CANCELLED);
      default -> Optional.empty();
    };
  }

  private static SimSummary after(ServiceEvent event, SimState state, @Nullable SimSummary before) {
    SimSummary now =
        before == null
            ? new SimSummary(
                event.simId,
                event.sessionId,
                event.hostName,
                "",
                event.owner,
                new Progress(event.simId, state, 0, 0, 0, 0, 0, 0, 0, 0, 0),
                event.happenedAt,
                state == SimState.SIM_QUEUED ? 0 : event.happenedAt,
                0,
                0,
                event.text)
            : copy(before, before.text);
    now.info = copy(now.info, state);
    if (state.value() >= SimState._SIM_DONE) {
      now.endedAt = event.happenedAt;
      now.text = event.code.isEmpty() ? event.text : event.code + " " + event.text;
    }
    return now;
  }

  /** Returns the same with another text. */
  public static SimSummary copy(SimSummary of, String text) {
    return new SimSummary(
        of.simId,
        of.sessionId,
        of.hostName,
        of.modelName,
        of.owner,
        of.info,
        of.createdAt,
        of.startedAt,
        of.endedAt,
        of.leaseEndsAt,
        text);
  }

  private static Progress copy(Progress of, SimState state) {
    return new Progress(
        of.simId,
        state,
        of.queuePosition,
        of.simTime,
        of.startTime,
        of.endTime,
        of.stepsDone,
        of.stepSize,
        of.stepOrder,
        of.realTimeFactor,
        of.rowsReady);
  }

  /**
   * Returns whether the list of a host is out of date.
   *
   * @param running number of runs in progress there
   * @param longest oldest acceptable list while runs are in progress, ns
   */
  synchronized boolean outdated(String hostName, int running, long longest) {
    Page page = page(hostName);
    boolean old = System.nanoTime() - page.listedAt > longest;
    return page.changed || (running > 0 && old);
  }

  /**
   * Replaces the runs of a host by those it has listed.
   *
   * @param askedAt when the list was requested, by {@link System#nanoTime}; a list requested before
   *     the present one is ignored
   */
  synchronized void listed(String hostName, SimSummary[] runs, long askedAt) {
    Page page = page(hostName);
    if (askedAt < page.askedAt) {
      return;
    }
    page.askedAt = askedAt;
    page.listedAt = System.nanoTime();
    page.changed = false;
    page.runs = new LinkedHashMap<>();
    for (SimSummary run : runs) {
      page.runs.put(run.simId, run);
      gone.remove(run.simId);
    }
  }

  /** Takes the run of a host whose details should be fetched next, if there is one. */
  synchronized Optional<String> takeUnread(String hostName) {
    Optional<String> next = page(hostName).unread.stream().findFirst();
    next.ifPresent(page(hostName).unread::remove);
    return next;
  }

  /** Forgets which details of a host's runs should be fetched. */
  synchronized void leaveUnread(String hostName) {
    page(hostName).unread.clear();
  }

  /** Notes that the details of a run could not be fetched, so that they are once more. */
  synchronized void notRead(String hostName, String simId) {
    page(hostName).unread.add(simId);
  }

  /** Records the details of a run; a check report that they lack is that of before. */
  public synchronized void read(SimDetail detail) {
    if (detail.modelText.length() > LONGEST_MODEL) {
      detail.modelText = "";
    }
    SimDetail before = details.remove(detail.summary.simId); // moves it to the end
    if (before != null && detail.checkReportJson.isEmpty()) {
      detail.checkReportJson = before.checkReportJson;
    }
    details.put(detail.summary.simId, detail);
  }

  /**
   * Keeps the runs of a host that is gone: those that had ended as they were, the others as failed.
   *
   * @param how the end of the host as a verb, such as {@code was lost}
   */
  synchronized void removeHost(String hostName, String how) {
    Page page = pages.remove(hostName);
    if (page == null) {
      return;
    }
    for (SimSummary last : page.runs.values()) {
      boolean ended = last.info.state.value() >= SimState._SIM_DONE;
      gone.put(last.simId, ended ? last : cutOff(last, hostName, how));
    }
  }

  private SimSummary cutOff(SimSummary last, String hostName, String how) {
    String text = "the simulation ended with host " + hostName + ", which " + how;
    SimSummary lost = copy(last, LOST + " " + text);
    lost.info = copy(last.info, SimState.SIM_FAILED);
    lost.endedAt = System.currentTimeMillis();
    lost.leaseEndsAt = 0;
    journal.add(
        new JournalEntry(
            "sim-lost",
            Severity.SEV_ERROR,
            LOST,
            hostName,
            last.sessionId,
            last.simId,
            last.owner,
            text));
    return lost;
  }

  /** Returns the last known runs of a host, oldest first. */
  public synchronized List<SimSummary> of(String hostName) {
    Page page = pages.get(hostName);
    return page == null ? List.of() : List.copyOf(page.runs.values());
  }

  /**
   * Returns the last known runs of a host that does not answer.
   *
   * @param why the host does not answer; added to the text of each run
   */
  public synchronized List<SimSummary> of(String hostName, String why) {
    return of(hostName).stream().map(run -> copy(run, why + "; last known: " + run.text)).toList();
  }

  /** Returns the runs of hosts that are gone. */
  public synchronized Collection<SimSummary> ofGoneHosts() {
    return new ArrayList<>(gone.values());
  }

  /** Returns the host a run is or was on, if there is one. */
  public synchronized Optional<String> hostOf(String simId) {
    for (Map.Entry<String, Page> page : pages.entrySet()) {
      if (page.getValue().runs.containsKey(simId)) {
        return Optional.of(page.getKey());
      }
    }
    return Optional.ofNullable(gone.get(simId)).map(run -> run.hostName);
  }

  /** Returns what became of a run, if its host is gone. */
  public synchronized Optional<String> endOf(String simId) {
    return Optional.ofNullable(gone.get(simId))
        .map(
            run ->
                run.text.startsWith(LOST + " ")
                    ? run.text.substring(LOST.length() + 1)
                    : "the simulation has ended (" + run.text + "), and its host is gone");
  }

  /** Returns all that is known of a run whose host does not answer or is gone. */
  public synchronized Optional<SimDetail> lastKnown(String simId) {
    SimSummary summary = gone.get(simId);
    if (summary == null) {
      summary =
          pages.values().stream()
              .map(page -> page.runs.get(simId))
              .filter(run -> run != null)
              .findFirst()
              .orElse(null);
    }
    return summary == null ? Optional.empty() : Optional.of(detail(summary));
  }

  private SimDetail detail(SimSummary summary) {
    SimDetail last = details.get(summary.simId);
    boolean cutOff = summary.text.startsWith(LOST + " ");
    return new SimDetail(
        summary,
        last == null ? "" : last.modelText,
        last == null ? "" : last.checkReportJson,
        last == null ? "" : last.reportJson,
        cutOff || last == null ? failure(summary, cutOff) : last.failed,
        last == null ? new CurveSample[0] : last.curves,
        last == null ? new SimEvent[0] : last.events);
  }

  private static FailureRecord failure(SimSummary run, boolean cutOff) {
    return cutOff
        ? new FailureRecord(
            LOST,
            run.text.substring(LOST.length() + 1),
            run.info.simTime,
            run.info.stepSize,
            run.info.stepOrder,
            "",
            "Start it again; if its host has a spool folder, its rows up to then can be fetched"
                + " when it is back.",
            new StepTried[0])
        : new FailureRecord("", "", 0, 0, 0, "", "", new StepTried[0]);
  }
}
