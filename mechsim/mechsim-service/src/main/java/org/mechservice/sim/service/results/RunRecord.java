package org.mechservice.sim.service.results;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.mechservice.idl.CurveSample;
import org.mechservice.idl.FailureRecord;
import org.mechservice.idl.Progress;
import org.mechservice.idl.SimDetail;
import org.mechservice.idl.SimEvent;
import org.mechservice.idl.SimState;
import org.mechservice.idl.SimSummary;
import org.mechservice.idl.StepTried;
import org.mechservice.sim.service.contract.ShortText;
import org.mechservice.solver.api.result.Variable;

/**
 * The record of a run: all that is kept of it besides its rows.
 *
 * @param identity its names and its owner
 * @param columns of its rows
 * @param states name and unit of its states
 * @param progress at its end, with its final state
 * @param startedAt UTC, ms since 1970-01-01; 0 if it never began
 * @param endedAt UTC, ms since 1970-01-01; 0 if it had not ended when this was written
 * @param text how it ended
 * @param report the run report as JSON; empty if there is none
 * @param failure why it failed, if it did
 * @param curves samples of step size, order, energy drift and residual
 */
public record RunRecord(
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

  private static final int VERSION = 1;

  /** Some thousand of them are one message from a host to its server. */
  private static final int LONGEST_SHOWN = 500;

  public RunRecord {
    states = List.copyOf(states);
    curves = List.copyOf(curves);
  }

  /** Returns the same record without the model's text, which may be long. */
  RunRecord withoutText() {
    return new RunRecord(
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

  /** Returns the same record with curves, which are not on disk. */
  RunRecord withCurves(List<CurveSample> others) {
    return new RunRecord(
        identity, columns, states, progress, startedAt, endedAt, text, report, failure, others);
  }

  /** Returns about how many characters its texts have. */
  long size() {
    return identity.modelText().length() + columns.characters() + text.length() + report.length();
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
        shown(text));
  }

  /** Returns what lists show of what was said of a run last. */
  public static String shown(String text) {
    return ShortText.of(text, LONGEST_SHOWN);
  }

  /**
   * Returns everything about the run, as administrators see it.
   *
   * @param until when it is deleted; UTC, ms since 1970-01-01
   * @param checkReport of its model, as JSON
   * @param events of it
   */
  public SimDetail detail(long until, String checkReport, List<SimEvent> events) {
    return new SimDetail(
        summary(until),
        identity.modelText(),
        checkReport,
        report,
        failure.orElse(new FailureRecord("", "", 0, 0, 0, "", "", new StepTried[0])),
        curves.toArray(CurveSample[]::new),
        events.toArray(SimEvent[]::new));
  }

  /** Returns the record as it is stored on disk, without its curves. */
  String toJson() {
    JsonObject json = new JsonObject();
    json.addProperty("version", VERSION);
    json.addProperty("simId", identity.simId());
    json.addProperty("sessionId", identity.sessionId());
    json.addProperty("hostName", identity.hostName());
    json.addProperty("owner", identity.owner());
    json.addProperty("modelName", identity.modelName());
    json.addProperty("fileName", identity.fileName());
    json.addProperty("modelText", identity.modelText());
    json.addProperty("createdAt", identity.createdAt());
    JsonArray earlier = new JsonArray();
    identity.earlierIds().forEach(earlier::add);
    json.add("earlierIds", earlier);
    json.add("columns", variables(columns.variables()));
    JsonArray groups = new JsonArray();
    columns.groups().forEach(groups::add);
    json.add("groups", groups);
    json.add("states", variables(states));
    json.add("progress", progress(progress));
    json.addProperty("startedAt", startedAt);
    json.addProperty("endedAt", endedAt);
    json.addProperty("text", text);
    json.addProperty("report", report);
    failure.ifPresent(why -> json.add("failure", failure(why)));
    return json.toString();
  }

  private static JsonArray variables(List<Variable> variables) {
    JsonArray array = new JsonArray();
    for (Variable variable : variables) {
      array.add(variable.name());
      array.add(variable.unit());
    }
    return array;
  }

  private static JsonObject progress(Progress progress) {
    JsonObject json = new JsonObject();
    json.addProperty("state", progress.state.value());
    json.addProperty("simTime", progress.simTime);
    json.addProperty("startTime", progress.startTime);
    json.addProperty("endTime", progress.endTime);
    json.addProperty("stepsDone", progress.stepsDone);
    json.addProperty("stepSize", progress.stepSize);
    json.addProperty("stepOrder", progress.stepOrder);
    json.addProperty("realTimeFactor", progress.realTimeFactor);
    json.addProperty("rowsReady", progress.rowsReady);
    return json;
  }

  private static JsonObject failure(FailureRecord failure) {
    JsonObject json = new JsonObject();
    json.addProperty("code", failure.code);
    json.addProperty("text", failure.text);
    json.addProperty("simTime", failure.simTime);
    json.addProperty("stepSize", failure.stepSize);
    json.addProperty("stepOrder", failure.stepOrder);
    json.addProperty("part", failure.part);
    json.addProperty("advice", failure.advice);
    JsonArray steps = new JsonArray();
    for (StepTried tried : failure.lastSteps) {
      steps.add(step(tried));
    }
    json.add("lastSteps", steps);
    return json;
  }

  /** A step that did not get as far as an error has none. */
  private static JsonObject step(StepTried tried) {
    JsonObject json = new JsonObject();
    json.addProperty("simTime", tried.simTime);
    json.addProperty("stepSize", tried.stepSize);
    json.addProperty("stepOrder", tried.stepOrder);
    if (Double.isFinite(tried.errorRatio)) {
      json.addProperty("errorRatio", tried.errorRatio);
    }
    return json;
  }

  private static StepTried step(JsonObject json) {
    JsonElement error = json.get("errorRatio");
    return new StepTried(
        json.get("simTime").getAsDouble(),
        json.get("stepSize").getAsDouble(),
        json.get("stepOrder").getAsInt(),
        error == null ? Double.NaN : error.getAsDouble());
  }

  /**
   * Reads what {@link #toJson} has written.
   *
   * @throws JsonParseException if it is something else
   */
  static RunRecord ofJson(String text) {
    try {
      JsonObject json = JsonParser.parseString(text).getAsJsonObject();
      if (json.get("version").getAsInt() != VERSION) {
        throw new JsonParseException("version " + json.get("version"));
      }
      List<String> groups = new ArrayList<>();
      json.getAsJsonArray("groups").forEach(group -> groups.add(group.getAsString()));
      String simId = string(json, "simId");
      return new RunRecord(
          identity(json),
          new RunColumns(variables(json.getAsJsonArray("columns")), groups),
          variables(json.getAsJsonArray("states")),
          progress(simId, json.getAsJsonObject("progress")),
          json.get("startedAt").getAsLong(),
          json.get("endedAt").getAsLong(),
          string(json, "text"),
          string(json, "report"),
          Optional.ofNullable(json.getAsJsonObject("failure")).map(RunRecord::failure),
          List.of());
    } catch (IllegalStateException
        | NullPointerException
        | ClassCastException
        | UnsupportedOperationException
        | NumberFormatException
        | IndexOutOfBoundsException e) {
      throw new JsonParseException("not the record of a run", e);
    }
  }

  private static RunIdentity identity(JsonObject json) {
    return new RunIdentity(
        string(json, "simId"),
        string(json, "sessionId"),
        string(json, "hostName"),
        string(json, "owner"),
        string(json, "modelName"),
        string(json, "fileName"),
        string(json, "modelText"),
        json.get("createdAt").getAsLong(),
        earlierIds(json.getAsJsonArray("earlierIds")));
  }

  /** Files written before runs moved have none. */
  private static List<String> earlierIds(@Nullable JsonArray ids) {
    return ids == null ? List.of() : ids.asList().stream().map(JsonElement::getAsString).toList();
  }

  private static String string(JsonObject json, String name) {
    return json.get(name).getAsString();
  }

  private static List<Variable> variables(JsonArray array) {
    List<Variable> variables = new ArrayList<>();
    for (int i = 0; i < array.size(); i += 2) {
      JsonElement unit = array.get(i + 1);
      variables.add(new Variable(array.get(i).getAsString(), unit.getAsString()));
    }
    return variables;
  }

  private static Progress progress(String simId, JsonObject json) {
    return new Progress(
        simId,
        SimState.from_int(json.get("state").getAsInt()),
        0,
        json.get("simTime").getAsDouble(),
        json.get("startTime").getAsDouble(),
        json.get("endTime").getAsDouble(),
        json.get("stepsDone").getAsLong(),
        json.get("stepSize").getAsDouble(),
        json.get("stepOrder").getAsInt(),
        json.get("realTimeFactor").getAsDouble(),
        json.get("rowsReady").getAsLong());
  }

  private static FailureRecord failure(JsonObject json) {
    return new FailureRecord(
        string(json, "code"),
        string(json, "text"),
        json.get("simTime").getAsDouble(),
        json.get("stepSize").getAsDouble(),
        json.get("stepOrder").getAsInt(),
        string(json, "part"),
        string(json, "advice"),
        steps(json.getAsJsonArray("lastSteps")));
  }

  /** Files written before steps were kept have none. */
  private static StepTried[] steps(@Nullable JsonArray tried) {
    return tried == null
        ? new StepTried[0]
        : tried.asList().stream()
            .map(element -> step(element.getAsJsonObject()))
            .toArray(StepTried[]::new);
  }
}
