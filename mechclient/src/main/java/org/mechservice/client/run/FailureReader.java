package org.mechservice.client.run;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.mechservice.idl.FailureRecord;
import org.mechservice.idl.StepTried;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.catalogue.MessageCode;

/** Converts the failure of a run at a server to that of a local run. */
final class FailureReader {
  private static final String STEPS = "lastSteps";
  private static final String RESULT = ": ";

  private FailureReader() {}

  /**
   * Returns the failure with the steps that led to it.
   *
   * @param report report of the same run, which has the outcome of each step in words; the
   *     contract's record has numbers only
   */
  static Failure of(FailureRecord said, Map<String, Object> report) {
    Optional<MessageCode> known = MessageCode.find(said.code);
    Failure failure =
        new Failure(
            known.orElse(MessageCode.ANSWER_NOT_UNDERSTOOD),
            known.isPresent() ? said.text : said.code + " " + said.text,
            said.simTime,
            said.stepSize,
            said.stepOrder,
            said.part,
            said.advice);
    return report.get(STEPS) instanceof String lines
        ? failure.after(steps(said.lastSteps, lines.split("\n", -1)))
        : failure;
  }

  private static List<Failure.Step> steps(StepTried[] tried, String[] lines) {
    List<Failure.Step> steps = new ArrayList<>();
    for (int i = 0; i < Math.min(tried.length, lines.length); i++) {
      String result = lines[i].substring(lines[i].lastIndexOf(RESULT) + RESULT.length());
      StepTried one = tried[i];
      steps.add(new Failure.Step(one.simTime, one.stepSize, one.stepOrder, one.errorRatio, result));
    }
    return steps;
  }
}
