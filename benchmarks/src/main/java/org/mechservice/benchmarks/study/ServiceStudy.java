package org.mechservice.benchmarks.study;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;
import org.mechservice.client.MechSession;
import org.mechservice.client.SimulationOptions;
import org.mechservice.client.failure.ServiceException;
import org.mechservice.client.run.PreparedRun;
import org.mechservice.client.run.RunResult;
import org.mechservice.report.stability.ExtremeCase;
import org.mechservice.solver.api.run.Outcome;

/** The extreme scenes run on the server and here: the same bits, and the same words. */
final class ServiceStudy implements MethodStudy {
  private static final String OUT_OF_TIME = "stopped when its time was over";

  private final StudyContext context;
  private final double limit;

  ServiceStudy(StudyContext context) {
    this.context = context;
    limit = context.quick() ? 3 : 60;
  }

  @Override
  public String name() {
    return "service";
  }

  /** The result of a run: its numbers, and its end or the reason of its refusal. */
  private record Ended(List<double[]> rows, String words, boolean begun) {
    boolean sameBits(Ended other) {
      boolean same = rows.size() == other.rows.size();
      for (int i = 0; same && i < rows.size(); i++) {
        same = Arrays.equals(rows.get(i), other.rows.get(i));
      }
      return same;
    }
  }

  @Override
  public void measure(StudyPage page) {
    page.title("The extreme scenes, remote and local");
    page.notes(
        "Every scene as its file says, once on the server, rows coming over the network, and once"
            + " here with the class and the solver fetched from it. Numbers are compared bit by"
            + " bit, messages letter by letter. A run that takes more than %.0f s is stopped, and"
            + " its first rows are compared.",
        limit);
    StudyPage.Table table =
        page.table("Scenes", "scene", "rows", "same bits", "same words", "how it ended");
    int cases = 0;
    int same = 0;
    List<String> different = new ArrayList<>();
    List<ExtremeCase> suite = context.cases();
    for (ExtremeCase wanted : suite) {
      context.at(wanted.name(), (double) cases / suite.size());
      cases++;
      Ended remote = run(wanted, true);
      Ended local = run(wanted, false);
      boolean stopped = remote.words().equals(OUT_OF_TIME) || local.words().equals(OUT_OF_TIME);
      boolean bits = stopped ? sameStart(remote, local) : remote.sameBits(local);
      // Two refusals alike say nothing, unless the scene is one to be refused.
      boolean begun = remote.begun() && local.begun();
      boolean refusal = wanted.expectation() == ExtremeCase.Expectation.REFUSAL;
      boolean words = (begun || refusal) && (stopped || remote.words().equals(local.words()));
      table.row(
          wanted.name(),
          remote.rows().size(),
          bits ? "yes" : "no",
          words ? "yes" : "no",
          words ? remote.words() : remote.words() + " | " + local.words());
      if (bits && words) {
        same++;
      } else {
        different.add(wanted.name());
      }
    }
    page.finds(
        "%d of %d scenes give the same bits and the same words remote and local%s",
        same, cases, different.isEmpty() ? "." : "; not: " + String.join(", ", different) + ".");
  }

  private static boolean sameStart(Ended remote, Ended local) {
    int rows = Math.min(remote.rows().size(), local.rows().size());
    return new Ended(remote.rows().subList(0, rows), "", true)
        .sameBits(new Ended(local.rows().subList(0, rows), "", true));
  }

  private Ended run(ExtremeCase wanted, boolean remote) {
    List<double[]> rows = new ArrayList<>();
    try {
      String words = context.with(wanted, session -> run(session, remote, rows));
      return new Ended(rows, words, true);
    } catch (ServiceException e) {
      return new Ended(rows, String.valueOf(e.getMessage()), false);
    }
  }

  private String run(MechSession session, boolean remote, List<double[]> rows) {
    SimulationOptions options = SimulationOptions.asInFile();
    ScheduledExecutorService watch = Executors.newSingleThreadScheduledExecutor();
    try (PreparedRun run =
        remote ? session.prepareRemoteRun(options) : session.prepareLocalRun(options)) {
      ScheduledFuture<?> alarm =
          watch.schedule(run::cancel, (long) (1000 * limit), TimeUnit.MILLISECONDS);
      RunResult result = run.toEnd(new StudyContext.KeptRows(rows));
      alarm.cancel(false);
      if (result.outcome() instanceof Outcome.Failed failed) {
        return failed.failure().message();
      }
      String notes = String.valueOf(result.report().getOrDefault("notes", ""));
      return result.outcome() instanceof Outcome.Stopped
          ? OUT_OF_TIME
          : ("completed " + notes).strip();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } finally {
      watch.shutdownNow();
    }
  }
}
