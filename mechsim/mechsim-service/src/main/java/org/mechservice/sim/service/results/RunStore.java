package org.mechservice.sim.service.results;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Future;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.mechservice.idl.CurveSample;
import org.mechservice.idl.FailureRecord;
import org.mechservice.idl.Progress;
import org.mechservice.idl.SimState;
import org.mechservice.idl.SimSummary;
import org.mechservice.idl.StepTried;
import org.mechservice.sim.service.limits.CurrentLimits;
import org.mechservice.sim.service.limits.HostLimit;
import org.mechservice.sim.service.limits.SpoolQuota;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.text.FileErrors;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The ended runs of a host: those whose rows are kept after the end of their session, and the
 * latest of all others, for administrators. With a folder, a run is on disk before its end is
 * announced, and outlives the process.
 */
public final class RunStore implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(RunStore.class);

  /** What reads the record of a run. */
  interface Reading {
    RunRecord read() throws IOException;
  }

  /**
   * A run that is kept after the end of its session.
   *
   * @param identity its names and its owner, without the model's text
   * @param summary as administrators see it, with the time at which it is deleted
   * @param rows its rows
   * @param record reads the rest of it
   */
  public record Kept(RunIdentity identity, SimSummary summary, ResultSpool rows, Reading record) {

    /** Returns when it is deleted; UTC, ms since 1970-01-01. */
    long until() {
      return summary.leaseEndsAt;
    }

    /**
     * Returns its record.
     *
     * @throws IOException if it cannot be read any more
     */
    public RunRecord run() throws IOException {
      return record.read();
    }
  }

  /** Each may hold a file open. */
  private static final int KEPT_WITHOUT_FOLDER = 500;

  /** Ended runs that lists have at most: at 4 kB each, half of a message. */
  private static final int LISTED = 4000;

  private static final int REMEMBERED = 1000;
  private static final int LONG_TEXT = 1 << 18;

  /** Largest record that stays in memory where there is a folder, in characters. */
  private static final int SMALL_RECORD = 1 << 15;

  private static final long CLOSING_SECONDS = 10;

  private final Optional<SpoolFolder> folder;
  private final CurrentLimits limits;
  private final SpoolQuota account;
  private final Map<String, Kept> kept = new ConcurrentHashMap<>();
  private final Deque<RunRecord> remembered = new ArrayDeque<>();
  private final ExecutorService disk = oneThread();
  private final AtomicLong completed = new AtomicLong();
  private final AtomicLong failed = new AtomicLong();
  private final AtomicLong cancelled = new AtomicLong();

  /**
   * Opens a store, with what an earlier process has left in the folder.
   *
   * @param folder where runs outlive the process; empty: nowhere
   * @throws IllegalArgumentException with code S-114 if the folder cannot be used
   */
  public RunStore(Optional<Path> folder, CurrentLimits limits) {
    this.folder = folder.map(SpoolFolder::open);
    this.limits = limits;
    Path disk = folder.orElse(Path.of(System.getProperty("java.io.tmpdir", ".")));
    account = new SpoolQuota(limits, () -> freeOn(disk));
    this.folder.ifPresent(this::takeUp);
  }

  private static long freeOn(Path disk) {
    try {
      return Files.getFileStore(disk).getUsableSpace();
    } catch (IOException e) {
      return Long.MAX_VALUE; // not known: the run itself will find out
    }
  }

  private static ExecutorService oneThread() {
    ThreadPoolExecutor executor =
        new ThreadPoolExecutor(
            1,
            1,
            1,
            TimeUnit.SECONDS,
            new LinkedBlockingQueue<>(),
            work -> {
              Thread thread = new Thread(work, "mechservice-disk");
              thread.setDaemon(true);
              return thread;
            });
    executor.allowCoreThreadTimeOut(true);
    return executor;
  }

  private void takeUp(SpoolFolder left) {
    try {
      left.readAll(this::takeUp);
    } catch (IOException e) {
      throw new IllegalArgumentException(
          MessageCode.SPOOL_FOLDER + " the spool folder cannot be read: " + FileErrors.reason(e),
          e);
    }
  }

  private void takeUp(SpoolFolder left, RunRecord run) throws IOException {
    RowFile place = left.rows(run.identity().simId());
    ResultSpool rows =
        ResultSpool.left(run.columns().count(), place, account.of(run.identity().owner()));
    RunRecord found = run;
    if (run.endedAt() == 0) {
      found = cutOff(run, rows);
      left.write(found);
    }
    keep(found, rows);
  }

  /** Returns the record of a run whose process ended before the run. */
  private static RunRecord cutOff(RunRecord run, ResultSpool rows) throws IOException {
    Progress last = run.progress();
    last.state = SimState.SIM_FAILED;
    last.rowsReady = rows.rows();
    if (rows.rows() > 0) {
      last.simTime = rows.read(rows.rows() - 1, 1)[0];
    }
    String text = "the run was cut off by the end of its host; its rows up to then are kept";
    FailureRecord failure =
        new FailureRecord(
            MessageCode.RUN_CUT_OFF.code(),
            text + ".",
            last.simTime,
            0,
            0,
            "",
            "Start it again.",
            new StepTried[0]);
    return new RunRecord(
        run.identity(),
        run.columns(),
        run.states(),
        last,
        run.startedAt(),
        System.currentTimeMillis(),
        MessageCode.RUN_CUT_OFF + " " + text,
        "",
        Optional.of(failure),
        List.of());
  }

  public SpoolQuota account() {
    return account;
  }

  /** Returns the empty rows of a new run. */
  public ResultSpool newRows(String simId, String owner, int columns) {
    RowFile place = folder.map(spool -> spool.rows(simId)).orElseGet(RowFile::temporary);
    return new ResultSpool(columns, place, account.of(owner));
  }

  /** Returns the files of a run. */
  public RunFiles files(String simId, ResultSpool rows) {
    return new RunFiles(folder, simId, rows);
  }

  /** Returns whether runs outlive the process. */
  public boolean lasts() {
    return folder.isPresent();
  }

  /** Work on the disk. */
  public interface DiskWork {
    void run() throws IOException;
  }

  /** Queues work of the disk thread. */
  public Future<?> soon(String simId, DiskWork work) {
    try {
      return disk.submit(() -> tried(simId, work));
    } catch (RejectedExecutionException e) {
      LOG.warn(
          MessageCode.RESULTS_NOT_KEPT
              + " run {} ended after its host: on disk it is one that was cut off",
          simId);
      return CompletableFuture.completedFuture(null);
    }
  }

  private static void tried(String simId, DiskWork work) {
    try {
      work.run();
    } catch (IOException | UncheckedIOException e) {
      LOG.warn(
          MessageCode.RESULTS_NOT_KEPT + " what is on disk of run {} is not up to date: {}",
          simId,
          e.toString());
    }
  }

  /** Counts a run that has ended. */
  public void count(SimState state) {
    switch (state.value()) {
      case SimState._SIM_DONE -> completed.incrementAndGet();
      case SimState._SIM_FAILED -> failed.incrementAndGet();
      default -> cancelled.incrementAndGet();
    }
  }

  public long completed() {
    return completed.get();
  }

  public long failed() {
    return failed.get();
  }

  public long cancelled() {
    return cancelled.get();
  }

  /**
   * Keeps an ended run whose session is gone. The oldest run of its client is deleted for it if the
   * client has too many; without a folder, the oldest of the client who has most if all have.
   */
  public void keep(RunRecord run, ResultSpool rows) {
    long end = run.endedAt() == 0 ? System.currentTimeMillis() : run.endedAt();
    long retention = limits.now().bound(HostLimit.RETENTION);
    long until = retention > Long.MAX_VALUE / 2000 ? Long.MAX_VALUE : end + retention * 1000;
    String simId = run.identity().simId();
    kept.put(simId, new Kept(run.identity().withoutText(), run.summary(until), rows, reading(run)));
    String owner = run.identity().owner();
    while (count(owner) > limits.now().bound(HostLimit.CLIENT_KEPT)) {
      dropOldest(owner);
    }
    if (folder.isEmpty() && kept.size() > KEPT_WITHOUT_FOLDER) {
      dropOldest(ownerOfMost());
    }
  }

  /** Returns what reads the record of a run: on disk if it is large and there is a folder. */
  private Reading reading(RunRecord run) {
    if (folder.isEmpty() || run.size() <= SMALL_RECORD) {
      RunRecord remains = shortened(run);
      return () -> remains;
    }
    String simId = run.identity().simId();
    List<CurveSample> curves = run.curves();
    return () -> readBack(simId).withCurves(curves);
  }

  /** Reads a record in the disk thread, after all that is being written. */
  private RunRecord readBack(String simId) throws IOException {
    try {
      return disk.submit(() -> folder.orElseThrow().read(simId)).get();
    } catch (ExecutionException e) {
      throw e.getCause() instanceof IOException why ? why : new IOException(e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new InterruptedIOException("the host is closing");
    }
  }

  private static RunRecord shortened(RunRecord run) {
    return run.identity().modelText().length() > LONG_TEXT ? run.withoutText() : run;
  }

  private long count(String owner) {
    return ofOwner(owner).count();
  }

  private Stream<Kept> ofOwner(String owner) {
    return kept.values().stream().filter(other -> other.identity().owner().equals(owner));
  }

  private void dropOldest(String owner) {
    ofOwner(owner)
        .min(Comparator.comparingLong((Kept other) -> other.summary().endedAt))
        .ifPresent(this::drop);
  }

  private String ownerOfMost() {
    return kept.values().stream()
        .collect(Collectors.groupingBy(run -> run.identity().owner(), Collectors.counting()))
        .entrySet()
        .stream()
        .max(Map.Entry.comparingByValue())
        .orElseThrow()
        .getKey();
  }

  /** Returns a run that is kept; empty after its retention time, even if it is not deleted yet. */
  public Optional<Kept> find(String simId) {
    return Optional.ofNullable(kept.get(simId))
        .or(() -> continuing(simId))
        .filter(run -> run.until() > System.currentTimeMillis());
  }

  private Optional<Kept> continuing(String earlierId) {
    return kept.values().stream()
        .filter(kept -> kept.identity().earlierIds().contains(earlierId))
        .findFirst();
  }

  /** Deletes the files of a run in the disk thread; its quota is free at once. */
  public void delete(RunFiles files, ResultSpool rows, String simId) {
    rows.giveUp();
    var unused = soon(simId, files::delete);
  }

  /** Keeps the record of a run for administrators. */
  public void remember(RunRecord run) {
    RunRecord remains = shortened(run);
    synchronized (remembered) {
      remembered.addFirst(remains);
      if (remembered.size() > REMEMBERED) {
        remembered.removeLast();
      }
    }
  }

  /**
   * Deletes the runs whose retention time is over.
   *
   * @param reopened whether a client has reopened a run; such a run stays until it is released
   */
  public void expire(Predicate<String> reopened) {
    long now = System.currentTimeMillis();
    kept.values().stream()
        .filter(run -> run.until() < now && !reopened.test(run.identity().simId()))
        .forEach(this::drop);
  }

  private void drop(Kept run) {
    String simId = run.identity().simId();
    if (kept.remove(simId, run)) {
      read(run).ifPresent(this::remember);
      delete(files(simId, run.rows()), run.rows(), simId);
    }
  }

  private static Optional<RunRecord> read(Kept run) {
    try {
      return Optional.of(run.run());
    } catch (IOException e) {
      LOG.warn(
          MessageCode.RESULTS_NOT_KEPT + " the record of run {} cannot be read: {}",
          run.identity().simId(),
          FileErrors.reason(e));
      return Optional.empty();
    }
  }

  /** Returns the record of an ended run, kept or only remembered. */
  public Optional<RunRecord> known(String simId) {
    Optional<Kept> stillKept = find(simId);
    if (stillKept.isPresent()) {
      return read(stillKept.get());
    }
    synchronized (remembered) {
      return remembered.stream().filter(run -> run.identity().simId().equals(simId)).findFirst();
    }
  }

  /** Returns the latest ended runs as administrators see them. */
  public List<SimSummary> summaries() {
    List<SimSummary> summaries = new ArrayList<>();
    kept.values().forEach(run -> summaries.add(run.summary()));
    synchronized (remembered) {
      remembered.forEach(run -> summaries.add(run.summary(0)));
    }
    return summaries.stream()
        .sorted(Comparator.comparingLong((SimSummary run) -> run.endedAt).reversed())
        .limit(LISTED)
        .toList();
  }

  /** Finishes the work of the disk thread and closes all files. */
  @Override
  public void close() {
    disk.shutdown();
    try {
      disk.awaitTermination(CLOSING_SECONDS, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    kept.values().forEach(run -> run.rows().close());
    kept.clear();
    folder.ifPresent(SpoolFolder::close);
  }
}
