package org.mechservice.sim.service;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.mechservice.idl.CurveSample;
import org.mechservice.idl.FailureRecord;
import org.mechservice.idl.SimDetail;
import org.mechservice.idl.SimEvent;
import org.mechservice.idl.StepTried;
import org.mechservice.mechml.MechmlException;
import org.mechservice.mechml.MechmlReader;
import org.mechservice.sim.build.CheckReport;

/** Everything about one run, in the type of the contract. */
final class RunDetail {
  private RunDetail() {}

  static SimDetail of(EndedRun run, long until, List<SimEvent> events) {
    return new SimDetail(
        run.summary(until),
        run.identity().modelText(),
        checkReport(run.identity()),
        run.report(),
        run.failure().orElse(new FailureRecord("", "", 0, 0, 0, "", "", new StepTried[0])),
        run.curves().toArray(CurveSample[]::new),
        events.toArray(SimEvent[]::new));
  }

  /** The model is read again: keeping what was read of every run would take much memory. */
  private static String checkReport(RunIdentity run) {
    if (run.modelText().isEmpty()) {
      return "";
    }
    try {
      byte[] content = run.modelText().getBytes(StandardCharsets.UTF_8);
      return CheckReport.of(MechmlReader.read(run.fileName(), content)).json();
    } catch (MechmlException e) {
      return ""; // its encoding is not UTF-8
    }
  }
}
