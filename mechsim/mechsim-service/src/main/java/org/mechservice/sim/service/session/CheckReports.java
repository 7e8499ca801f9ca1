package org.mechservice.sim.service.session;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executor;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.sim.service.results.RunIdentity;
import org.mechservice.sim.service.setup.SetUps;

/**
 * The check reports of the latest runs that administrators have looked at. A large model's takes
 * seconds, longer than a server waits for the answer of a host: it is made beside the call, and a
 * later call finds it. A few are made at once, whatever administrators look at; they share
 * processors and processes with the set-ups of clients. Thread-safe.
 */
final class CheckReports {
  private static final long LONGEST_WAIT_MILLIS = 1000;
  private static final int KEPT = 32;

  /** Reports that are made at once; further ones are left to later calls. */
  static final int AT_ONCE = 4;

  private record File(String name, String text) {}

  private final SetUps setUps;
  private final Executor executor;
  private int beingMade;
  private final Map<File, Future<String>> latest =
      new LinkedHashMap<>(16, 0.75f, true) {
        @Override
        protected boolean removeEldestEntry(Map.Entry<File, Future<String>> eldest) {
          return size() > KEPT;
        }
      };

  /**
   * @param setUps reads the models
   * @param executor makes the reports
   */
  CheckReports(SetUps setUps, Executor executor) {
    this.setUps = setUps;
    this.executor = executor;
  }

  /** Returns the report of a run's model as JSON; empty if there is none, or not yet. */
  String of(RunIdentity run) throws InterruptedException {
    File file = new File(run.fileName(), run.modelText());
    if (file.text().isEmpty()) {
      return "";
    }
    Optional<Future<String>> report = begun(file);
    if (report.isEmpty()) {
      return "";
    }
    try {
      return report.get().get(LONGEST_WAIT_MILLIS, TimeUnit.MILLISECONDS);
    } catch (TimeoutException e) {
      return "";
    } catch (ExecutionException e) {
      synchronized (latest) {
        latest.remove(file, report.get());
      }
      throw new IllegalStateException(e.getCause());
    }
  }

  /** Returns a report that is made or being made; empty if too many others are being made. */
  private Optional<Future<String>> begun(File file) {
    synchronized (latest) {
      Future<String> known = latest.get(file);
      if (known == null && beingMade < AT_ONCE) {
        beingMade++;
        known = CompletableFuture.supplyAsync(() -> make(file), executor).whenComplete(this::made);
        latest.put(file, known);
      }
      return Optional.ofNullable(known);
    }
  }

  private void made(String unused, Throwable failure) {
    synchronized (latest) {
      beingMade--;
    }
  }

  private String make(File file) {
    try {
      return setUps.reportOf(file.name(), file.text());
    } catch (LimitExceeded e) {
      return ""; // of a model for which the limits have become too small
    }
  }
}
