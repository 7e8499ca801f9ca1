package org.mechservice.client.run;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.mechservice.solver.api.run.RunNotes;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Accuracy;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.catalogue.Severity;

/** Converts the report of a run at a server to that of a run in this process. */
public final class ReportReader {
  private static final Pattern NOTE =
      Pattern.compile("(?<code>[MNS]-\\d{3}) t=(?<time>\\S+) s: (?<text>.*)");
  private static final Pattern LIMIT =
      Pattern.compile("(?<state>\\S+)( error (?<errors>\\d+))?( equations (?<equations>\\d+))?");

  private final Map<String, Object> facts;

  private ReportReader(Map<String, Object> facts) {
    this.facts = facts;
  }

  /**
   * Returns the report of a run; {@link RunReport#asMap} of it has the entries that the server
   * sent.
   *
   * @param result of the run
   * @param tStart start of its interval, s
   * @param tEnd end of its interval, s
   * @param tStep distance of its rows, s
   */
  public static RunReport of(RunResult result, double tStart, double tEnd, double tStep) {
    ReportReader read = new ReportReader(result.report());
    return new RunReport(
        result.outcome(),
        read.text("scene"),
        read.text("formulation"),
        read.settings(tStart, tEnd, tStep),
        read.count("steps"),
        read.count("rejectedSteps"),
        read.count("evaluations"),
        read.count("rows"),
        tStart + read.number("simulatedTime", 0),
        read.number("wallTime", 0),
        read.number("energyDrift"),
        read.number("energyScale"),
        read.facts.containsKey("stiffness"),
        read.count("jacobians"),
        read.count("factorisations"),
        limits(read.text("rejectedBy")),
        notes(read.text("notes")),
        read.text("solverVersion"));
  }

  private RunSettings settings(double tStart, double tEnd, double tStep) {
    double absolute = number("absoluteTolerance", 0);
    return new RunSettings(
            tStart,
            tEnd,
            tStep,
            text("integrator"),
            number("relativeTolerance", 0),
            absolute,
            Double.POSITIVE_INFINITY,
            0,
            0,
            number("angleTolerance", absolute),
            number("velocityTolerance", absolute),
            number("angularVelocityTolerance", absolute))
        .withAccuracy(
            facts.get(Accuracy.OPTION) instanceof String label
                ? Accuracy.of(label)
                : Accuracy.STANDARD);
  }

  private String text(String key) {
    return facts.get(key) instanceof String text ? text : "";
  }

  private long count(String key) {
    return facts.get(key) instanceof Number number ? number.longValue() : 0;
  }

  private double number(String key, double otherwise) {
    return number(key).orElse(otherwise);
  }

  private OptionalDouble number(String key) {
    return facts.get(key) instanceof Number number
        ? OptionalDouble.of(number.doubleValue())
        : OptionalDouble.empty();
  }

  private static List<RunReport.Limit> limits(String text) {
    List<RunReport.Limit> limits = new ArrayList<>();
    for (String one : text.split(", ", -1)) {
      Matcher found = LIMIT.matcher(one);
      if (found.matches()) {
        limits.add(
            new RunReport.Limit(
                found.group("state"), countOf(found, "errors"), countOf(found, "equations")));
      }
    }
    return limits;
  }

  private static long countOf(Matcher found, String group) {
    return found.group(group) == null ? 0 : Long.parseLong(found.group(group));
  }

  private static List<RunNotes.Note> notes(String text) {
    return Arrays.stream(text.split("\n", -1))
        .map(NOTE::matcher)
        .filter(Matcher::matches)
        .map(ReportReader::note)
        .toList();
  }

  private static RunNotes.Note note(Matcher found) {
    MessageCode code =
        MessageCode.find(found.group("code")).orElse(MessageCode.ANSWER_NOT_UNDERSTOOD);
    return new RunNotes.Note(
        code,
        Double.parseDouble(found.group("time")),
        code.severity() == Severity.WARNING,
        found.group("text"));
  }
}
