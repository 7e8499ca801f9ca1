package org.mechservice.sim.service.session;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executor;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.sim.service.results.RunIdentity;
import org.mechservice.sim.service.setup.SetUpWorkers;

/**
 * The check reports of the latest runs that administrators have looked at. A large model's takes
 * seconds, longer than a server waits for the answer of a host: it is made beside the call, and a
 * later call finds it. Thread-safe.
 */
final class CheckReports {
  private static final long LONGEST_WAIT_MILLIS = 1000;
  private static final int KEPT = 32;

  private record File(String name, String text) {}

  private final SetUpWorkers setUps;
  private final Executor executor;
  private final Map<File, Future<String>> latest =
      new LinkedHashMap<>(16, 0.75f, true) {
        @Override
        protected boolean removeEldestEntry(Map.Entry<File, Future<String>> eldest) {
          return size() > KEPT;
        }
      };

  /**
   * @param executor makes the reports
   */
  CheckReports(SetUpWorkers setUps, Executor executor) {
    this.setUps = setUps;
    this.executor = executor;
  }

  /** Returns the report of a run's model as JSON; empty if there is none, or not yet. */
  String of(RunIdentity run) throws InterruptedException {
    File file = new File(run.fileName(), run.modelText());
    if (file.text().isEmpty()) {
      return "";
    }
    Future<String> report;
    synchronized (latest) {
      report =
          latest.computeIfAbsent(
              file, made -> CompletableFuture.supplyAsync(() -> make(made), executor));
    }
    try {
      return report.get(LONGEST_WAIT_MILLIS, TimeUnit.MILLISECONDS);
    } catch (TimeoutException e) {
      return "";
    } catch (ExecutionException e) {
      synchronized (latest) {
        latest.remove(file, report);
      }
      throw new IllegalStateException(e.getCause());
    }
  }

  private String make(File file) {
    try {
      return setUps.setUps().reportOf(file.name(), file.text());
    } catch (LimitExceeded e) {
      return ""; // of a model for which the limits have become too small
    }
  }
}
