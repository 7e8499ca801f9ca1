package org.mechservice.sim.service;

import java.util.List;
import org.mechservice.idl.CurveSample;
import org.mechservice.idl.FailureRecord;
import org.mechservice.idl.SimDetail;
import org.mechservice.idl.SimEvent;
import org.mechservice.idl.StepTried;

/** Everything about one run, in the type of the contract. */
final class RunDetail {
  private RunDetail() {}

  /**
   * @param until when it is deleted; UTC, ms since 1970-01-01
   * @param checkReport of its model, as JSON
   * @param events of it
   */
  static SimDetail of(EndedRun run, long until, String checkReport, List<SimEvent> events) {
    return new SimDetail(
        run.summary(until),
        run.identity().modelText(),
        checkReport,
        run.report(),
        run.failure().orElse(new FailureRecord("", "", 0, 0, 0, "", "", new StepTried[0])),
        run.curves().toArray(CurveSample[]::new),
        events.toArray(SimEvent[]::new));
  }
}
