package org.mechservice.admin;

import java.time.Instant;
import java.util.Arrays;
import org.mechservice.idl.Diagnostic;
import org.mechservice.idl.FailureRecord;
import org.mechservice.idl.Progress;
import org.mechservice.idl.SimDetail;
import org.mechservice.idl.SimEvent;
import org.mechservice.idl.SimSummary;
import org.mechservice.idl.StepTried;

/** Shows one simulation in full. */
public final class DetailText {
  private static final int LAST_EVENTS = 20;

  private final Instant now;

  /**
   * @param now the time from which ages are counted
   */
  public DetailText(Instant now) {
    this.now = now;
  }

  /** Returns facts, failure and events as text, ending with a line feed. */
  public String format(SimDetail detail) {
    StringBuilder text = new StringBuilder().append(facts(detail.summary));
    if (!detail.failed.code.isEmpty()) {
      text.append('\n').append(failure(detail.failed));
    }
    TextTable events = events(detail);
    if (!events.isEmpty()) {
      text.append('\n').append(events);
    }
    return text.toString();
  }

  private String facts(SimSummary summary) {
    KnownSimulation known = new KnownSimulation("", summary);
    Progress info = summary.info;
    TextTable table = new TextTable("simulation", summary.simId);
    table.add("model", summary.modelName);
    table.add("owner", summary.owner);
    table.add("host", summary.hostName);
    table.add("session", summary.sessionId);
    table.add(
        "state", known.state() + (info.queuePosition > 0 ? ", number " + info.queuePosition : ""));
    table.add(
        "simulated",
        QuantityText.time(info) + QuantityText.format(", %.0f %%", 100 * known.progress()));
    table.add("x real time", QuantityText.number(info.realTimeFactor));
    table.add(
        "steps",
        QuantityText.format(
            "%d, the last of %s s, order %d",
            info.stepsDone, QuantityText.number(info.stepSize), info.stepOrder));
    table.add("rows", Long.toString(info.rowsReady));
    table.add(
        "created",
        QuantityText.instant(summary.createdAt)
            + ", "
            + QuantityText.age(summary.createdAt, now)
            + " ago");
    table.add("ended", QuantityText.instant(summary.endedAt));
    table.add("last message", summary.text);
    return table.toString();
  }

  private static String failure(FailureRecord failed) {
    StringBuilder text = new StringBuilder();
    text.append(PlainText.of(failed.code + " " + failed.text)).append('\n');
    if (!failed.part.isEmpty()) {
      text.append("at ").append(PlainText.of(failed.part)).append('\n');
    }
    if (!failed.advice.isEmpty()) {
      text.append(PlainText.of(failed.advice)).append('\n');
    }
    TextTable steps = new TextTable("TIME", "STEP SIZE", "ORDER", "ERROR RATIO");
    for (StepTried tried : failed.lastSteps) {
      steps.add(
          QuantityText.number(tried.simTime),
          QuantityText.number(tried.stepSize),
          Integer.toString(tried.stepOrder),
          QuantityText.number(tried.errorRatio));
    }
    return steps.isEmpty() ? text.toString() : text.append(steps).toString();
  }

  private static TextTable events(SimDetail detail) {
    TextTable table = new TextTable("AT", "STATE", "EVENT");
    Arrays.stream(detail.events)
        .skip(Math.max(0, detail.events.length - LAST_EVENTS))
        .forEach(event -> addEvent(table, event));
    return table;
  }

  private static void addEvent(TextTable table, SimEvent event) {
    String at = QuantityText.instant(event.happenedAt);
    if (!event.text.isEmpty()) {
      table.add(at, KnownSimulation.label(event.info.state), event.text);
    }
    for (Diagnostic said : event.messages) {
      table.add(at, KnownSimulation.label(event.info.state), said.code + " " + said.text);
    }
  }
}
