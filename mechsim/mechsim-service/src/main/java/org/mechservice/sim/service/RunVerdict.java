package org.mechservice.sim.service;

import java.io.IOException;
import java.util.Map;
import java.util.Optional;
import org.mechservice.idl.SimState;
import org.mechservice.orb.GuardedServant;
import org.mechservice.sim.worker.WorkerLostException;
import org.mechservice.sim.worker.WorkerResult;
import org.mechservice.solver.api.Failure;
import org.mechservice.solver.api.Outcome;
import org.mechservice.solver.api.ResultSink;
import org.mechservice.solver.api.RunControl;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * How a run ended.
 *
 * @param report entries of the solver's report; empty if it broke off
 * @param outcome as the service sees it: a run that was stopped at a limit has failed
 */
record RunVerdict(Optional<Map<String, Object>> report, Outcome outcome) {
  /** Computes a run to its end, however that comes. */
  static RunVerdict of(RunTask task, String simId, ResultSink sink, RunControl control) {
    try {
      WorkerResult result = task.run(sink, control);
      return new RunVerdict(Optional.of(result.report()), result.outcome());
    } catch (WorkerLostException e) {
      return lost(e, control);
    } catch (RunLimitException e) {
      return failed(atLimit(e, control));
    } catch (IllegalArgumentException e) {
      return failed(coded(MessageCode.OPTION_VALUE, String.valueOf(e.getMessage()), control));
    } catch (IOException e) {
      return failed(
          coded(
              MessageCode.RESULTS_NOT_KEPT,
              "the results cannot be kept: " + e.getMessage(),
              control));
    } catch (RuntimeException | OutOfMemoryError | StackOverflowError e) {
      String incident = GuardedServant.record("run " + simId, e);
      return failed(
          coded(
              MessageCode.INTERNAL_SERVER_ERROR,
              "the server failed unexpectedly, incident " + incident,
              control));
    }
  }

  /** A worker that does not stop when it is asked to is made to. */
  private static RunVerdict lost(WorkerLostException lost, RunControl control) {
    if (control.stopRequested()) {
      return new RunVerdict(Optional.empty(), new Outcome.Stopped());
    }
    return failed(
        failure(
            lost.outOfMemory() ? HostLimit.MEMORY.code() : MessageCode.WORKER_ENDED,
            String.valueOf(lost.getMessage()),
            control,
            "Look for what the classes of the model's users do there; the rows up to then are"
                + " kept."));
  }

  private static RunVerdict failed(Failure failure) {
    return new RunVerdict(Optional.empty(), new Outcome.Failed(failure));
  }

  /** The solver's messages begin with their code; others get the code given here. */
  private static Failure coded(MessageCode code, String message, RunControl control) {
    boolean hasCode = message.matches("(?s)[MNS]-\\d{3} .*");
    return failure(
        hasCode ? MessageCode.find(message.substring(0, 5)).orElse(code) : code,
        hasCode ? message.substring(6) : message,
        control,
        "");
  }

  private static Failure atLimit(RunLimitException limit, RunControl control) {
    return failure(
        limit.limit().code(),
        String.valueOf(limit.getMessage()) + ".",
        control,
        "The rows up to then are kept; the operator can raise the limit \""
            + limit.limit().label()
            + "\".");
  }

  private static Failure failure(MessageCode code, String text, RunControl control, String advice) {
    double time = Double.isNaN(control.time()) ? 0 : control.time();
    return new Failure(code, text, time, control.stepSize(), control.order(), "", advice);
  }

  /** Returns the same, but of a run that was stopped because it reached a limit. */
  RunVerdict stoppedAt(RunLimitException limit, RunControl control) {
    return new RunVerdict(report, new Outcome.Failed(atLimit(limit, control)));
  }

  /** Returns the same, but of a run that failed after all. */
  RunVerdict failed(IOException unkept, RunControl control) {
    return new RunVerdict(
        report,
        new Outcome.Failed(
            coded(
                MessageCode.RESULTS_NOT_KEPT,
                "the results cannot be kept: " + unkept.getMessage(),
                control)));
  }

  SimState state() {
    if (outcome instanceof Outcome.Failed) {
      return SimState.SIM_FAILED;
    }
    return outcome instanceof Outcome.Stopped ? SimState.SIM_CANCELLED : SimState.SIM_DONE;
  }

  /** Returns how it ended, for people. */
  String text(double time) {
    if (outcome instanceof Outcome.Failed failed) {
      return failed.failure().message();
    }
    return outcome instanceof Outcome.Stopped ? "cancelled at t=" + time + " s" : "done";
  }

  /** Returns why the run failed, if it did. */
  Optional<Failure> failure() {
    return outcome instanceof Outcome.Failed failed
        ? Optional.of(failed.failure())
        : Optional.empty();
  }
}
