package org.mechservice.cli.sweep;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Timer;
import java.util.TimerTask;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.cli.shell.FailureReport;
import org.mechservice.cli.shell.ServerOption;
import org.mechservice.cli.shell.ServiceConnection;
import org.mechservice.cli.simulate.CancelOnInterrupt;
import org.mechservice.client.failure.ServiceException;
import org.mechservice.guard.UserCode;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.study.PointEvaluation;
import org.mechservice.study.run.Study;
import org.mechservice.study.run.StudyForecast;
import org.mechservice.study.run.StudyPart;
import org.mechservice.study.run.StudyPlan;

/**
 * A study on the threads of this process or on hosts: says how it goes, and how it ended.
 *
 * @param threads runs at once
 * @param out takes what is said of the end
 * @param err takes what is said on the way, and errors
 * @param quiet whether nothing but errors is said
 * @param printed whether the table is printed: of the end nothing is said but which points failed
 */
record StudyRun(
    StudyPlan plan,
    StudyPart part,
    ThreadsOption threads,
    PrintWriter out,
    PrintWriter err,
    boolean quiet,
    boolean printed) {
  private static final long LOOK_MILLIS = 500;

  /**
   * Runs it here.
   *
   * @return the exit status
   */
  int here(Path table) throws IOException, InterruptedException {
    return run(table, plan.model(), threads.or(Runtime.getRuntime().availableProcessors()));
  }

  /**
   * Runs it on the hosts of a server.
   *
   * @param userCode the folders whose classes of forces are sent
   * @return the exit status
   */
  int onHosts(Path table, ServerOption server, UserCode userCode)
      throws IOException, InterruptedException {
    int processors = Runtime.getRuntime().availableProcessors();
    try (ServiceConnection service = ServiceConnection.open(server, processors, userCode);
        HostsEvaluation hosts = new HostsEvaluation(plan, service.connection(), userCode)) {
      return run(table, hosts, threads.or(service.connection().places()));
    } catch (ServiceException lost) {
      if (!Files.exists(Study.journal(table))) {
        throw lost;
      }
      print(lost.getMessage() + "; finished rows are kept, and the same command goes on");
      return FailureReport.status(lost);
    }
  }

  private int run(Path table, PointEvaluation evaluation, int atOnce)
      throws IOException, InterruptedException {
    plan.userCodeWarning().ifPresent(this::print);
    if (!quiet) {
      plan.model().model().content().warnings().forEach(err::println);
      err.flush();
    }
    Study study = new Study(plan, part, evaluation);
    StudyForecast forecast =
        new StudyForecast(() -> System.nanoTime() * 1e-9, part.size(plan.points()));
    Timer looks = new Timer("mechservice-forecast", true);
    if (!quiet) {
      TimerTask look =
          new TimerTask() {
            @Override
            public void run() {
              forecast.word().ifPresent(word -> print(word));
            }
          };
      looks.schedule(look, LOOK_MILLIS, LOOK_MILLIS);
    }
    try (CancelOnInterrupt interrupt = new CancelOnInterrupt()) {
      interrupt.cancels(study::stop);
      return print(study.run(table, atOnce, forecast), table);
    } finally {
      looks.cancel();
    }
  }

  private void print(String word) {
    err.println(word);
    err.flush();
  }

  private int print(Study.Result result, Path table) {
    int done = result.statistics().rows();
    if (!result.complete()) {
      print(
          MessageCode.RUN_STOPPED
              + " stopped on request: "
              + done
              + " of "
              + result.points()
              + " points are finished; the same command goes on");
      return ExitStatus.INTERRUPTED;
    }
    int failed = result.statistics().failed();
    String ofFailed = failed + " failed: their rows say why";
    if (printed && failed > 0) {
      print(done + " points; " + ofFailed);
    } else if (!printed && !quiet) {
      out.println(
          table
              + ": "
              + done
              + " points"
              + (result.before() > 0 ? ", " + result.before() + " of them finished before" : "")
              + (result.endedByRule() ? "; the stop rule ended the study" : "")
              + (failed > 0 ? "; " + ofFailed : ""));
      result.statistics().lines().forEach(line -> out.println("  " + line));
      out.flush();
    }
    return ExitStatus.DONE;
  }
}
