package org.mechservice.sim.service.run;

import java.io.IOException;
import java.util.Map;
import java.util.Optional;
import org.mechservice.guard.worker.WorkerLostException;
import org.mechservice.guard.worker.WorkerResult;
import org.mechservice.idl.SimState;
import org.mechservice.orb.GuardedServant;
import org.mechservice.sim.service.limits.LimitReachedException;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * The outcome of a run in the service.
 *
 * @param report entries of the solver's report; empty if the computation broke off
 * @param outcome of the run: one that was stopped at a limit has failed
 */
record RunOutcome(Optional<Map<String, Object>> report, Outcome outcome) {
  /** The outcome of a run that was cancelled without a report of its solver. */
  static final RunOutcome CANCELLED = new RunOutcome(Optional.empty(), new Outcome.Stopped());

  /** The outcome that the solver has reported. */
  static RunOutcome of(WorkerResult result) {
    return new RunOutcome(Optional.of(result.report()), result.outcome());
  }

  /**
   * The outcome of a run whose computation ended with an exception; an unexpected one is logged as
   * an incident.
   */
  static RunOutcome ofException(Throwable thrown, String simId, RunControl control) {
    if (thrown instanceof WorkerLostException lost) {
      return ofLostWorker(lost, control);
    } else if (thrown instanceof LimitReachedException limit) {
      return failed(atLimit(limit, control));
    } else if (thrown instanceof IllegalArgumentException refusal) {
      return failed(coded(MessageCode.OPTION_VALUE, String.valueOf(refusal.getMessage()), control));
    } else if (thrown instanceof IOException unkept) {
      return failed(notKept(unkept, control));
    }
    String incident = GuardedServant.record("run " + simId, thrown);
    return failed(
        coded(
            MessageCode.INTERNAL_SERVER_ERROR,
            "the server failed unexpectedly, incident " + incident,
            control));
  }

  /** A worker process that ignores a stop request is killed: then its run was cancelled. */
  private static RunOutcome ofLostWorker(WorkerLostException lost, RunControl control) {
    if (control.stopRequested()) {
      return CANCELLED;
    }
    return failed(
        failure(
            lost.code(),
            String.valueOf(lost.getMessage()),
            control,
            lost.advice() + " The rows up to then are kept."));
  }

  private static RunOutcome failed(Failure failure) {
    return new RunOutcome(Optional.empty(), new Outcome.Failed(failure));
  }

  /** Takes the code at the start of a solver's message; a message without one gets that given. */
  private static Failure coded(MessageCode code, String message, RunControl control) {
    boolean hasCode = message.matches("(?s)[MNS]-\\d{3} .*");
    return failure(
        hasCode ? MessageCode.find(message.substring(0, 5)).orElse(code) : code,
        hasCode ? message.substring(6) : message,
        control,
        "");
  }

  private static Failure notKept(IOException unkept, RunControl control) {
    return coded(
        MessageCode.RESULTS_NOT_KEPT,
        "the results cannot be kept: " + unkept.getMessage(),
        control);
  }

  private static Failure atLimit(LimitReachedException limit, RunControl control) {
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
  RunOutcome stoppedAt(LimitReachedException limit, RunControl control) {
    return new RunOutcome(report, new Outcome.Failed(atLimit(limit, control)));
  }

  /** Returns the same, but of a run whose results could not be kept. */
  RunOutcome failed(IOException unkept, RunControl control) {
    return new RunOutcome(report, new Outcome.Failed(notKept(unkept, control)));
  }

  SimState state() {
    if (outcome instanceof Outcome.Failed) {
      return SimState.SIM_FAILED;
    }
    return outcome instanceof Outcome.Stopped ? SimState.SIM_CANCELLED : SimState.SIM_DONE;
  }

  /**
   * Returns how the run ended, for people.
   *
   * @param time of the last row, s
   */
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
