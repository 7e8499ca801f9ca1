package org.mechservice.sim.service;

import java.util.List;
import java.util.Optional;
import org.mechservice.idl.CurveSample;
import org.mechservice.idl.FailureRecord;
import org.mechservice.idl.Progress;
import org.mechservice.idl.SimSummary;
import org.mechservice.solver.api.Variable;

/**
 * What is left of a run but its rows.
 *
 * @param identity what it is called and whose it is
 * @param columns of its rows
 * @param states name and unit of its states
 * @param progress how far it came, with its final state
 * @param startedAt UTC, ms since 1970-01-01; 0 if it never began
 * @param endedAt UTC, ms since 1970-01-01; 0 if it was still going on when this was written
 * @param text how it ended
 * @param report the run report as JSON; empty if there is none
 * @param failure why it failed, if it did
 * @param curves how it went
 */
record EndedRun(
    RunIdentity identity,
    RunColumns columns,
    List<Variable> states,
    Progress progress,
    long startedAt,
    long endedAt,
    String text,
    String report,
    Optional<FailureRecord> failure,
    List<CurveSample> curves) {

  EndedRun {
    states = List.copyOf(states);
    curves = List.copyOf(curves);
  }

  /** Returns the same without the model's text, for those of whom there are many. */
  EndedRun withoutText() {
    return new EndedRun(
        identity.withoutText(),
        columns,
        states,
        progress,
        startedAt,
        endedAt,
        text,
        report,
        failure,
        curves);
  }

  /**
   * Returns it as administrators see it.
   *
   * @param until when it is deleted; UTC, ms since 1970-01-01
   */
  SimSummary summary(long until) {
    return new SimSummary(
        identity.simId(),
        identity.sessionId(),
        identity.hostName(),
        identity.modelName(),
        identity.owner(),
        progress,
        identity.createdAt(),
        startedAt,
        endedAt,
        until,
        text);
  }
}
