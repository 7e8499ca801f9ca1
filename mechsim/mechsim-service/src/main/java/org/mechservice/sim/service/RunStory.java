package org.mechservice.sim.service;

import java.util.Optional;
import org.mechservice.idl.Progress;
import org.mechservice.idl.SimSummary;
import org.mechservice.solver.api.RunControl;
import org.mechservice.solver.api.RunSettings;

/**
 * What there is to tell of a run at any moment.
 *
 * @param plan what was asked for
 * @param queue in which it waits
 * @param entry it is there
 * @param control of its solver
 * @param phase how far it is
 * @param clock when it began and ended
 * @param rows it has put out
 * @param curves how it goes
 */
record RunStory(
    RunPlan plan,
    RunQueue queue,
    Runnable entry,
    RunControl control,
    RunPhase phase,
    RunClock clock,
    RunRows rows,
    RunCurves curves) {
  /** Returns its place among those that wait, from 1; 0 if it does not wait. */
  int place() {
    return phase.waits() ? queue.positionOf(entry) : 0;
  }

  /** Returns how far the run is. */
  Progress progress() {
    RunSettings settings = plan.task().settings();
    double wall = clock.wallSeconds();
    double reached = BrokenOffReport.timeReached(plan, control);
    return new Progress(
        plan.identity().simId(),
        phase.state(),
        place(),
        reached,
        settings.tStart(),
        settings.tEnd(),
        control.steps(),
        control.stepSize(),
        control.order(),
        wall > 0 ? (reached - settings.tStart()) / wall : 0,
        rows.spool().rows());
  }

  /**
   * Returns it as administrators see it.
   *
   * @param leaseEnd when its session's lease ends; UTC, ms since 1970-01-01
   */
  SimSummary summary(long leaseEnd) {
    RunIdentity who = plan.identity();
    return new SimSummary(
        who.simId(),
        who.sessionId(),
        who.hostName(),
        who.modelName(),
        who.owner(),
        progress(),
        who.createdAt(),
        clock.startedAt(),
        clock.endedAt(),
        leaseEnd,
        phase.text());
  }

  /** Returns the report as JSON. */
  String report(RunVerdict verdict) {
    return plan.facts()
        .json(
            verdict
                .report()
                .orElseGet(
                    () ->
                        BrokenOffReport.of(
                            plan, control, rows.spool().rows(), clock.wallSeconds())),
            verdict);
  }

  /**
   * Returns what is left of the run but its rows.
   *
   * @param verdict how it has ended, or is going to be said to have; empty: it has not
   */
  EndedRun afterwards(Optional<RunVerdict> verdict) {
    Progress last = progress();
    verdict.ifPresent(ended -> last.state = ended.state());
    return new EndedRun(
        plan.identity(),
        plan.columns(),
        plan.task().description().states(),
        last,
        clock.startedAt(),
        clock.endedAt(),
        verdict.map(ended -> ended.text(rows.lastTime())).orElseGet(phase::text),
        verdict.map(this::report).orElse(""),
        verdict.flatMap(RunVerdict::failure).map(Wire::failure),
        curves.all());
  }
}
