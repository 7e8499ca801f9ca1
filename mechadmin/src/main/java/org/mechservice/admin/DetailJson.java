package org.mechservice.admin;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonNull;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;
import java.util.Arrays;
import java.util.List;
import org.mechservice.idl.CurveSample;
import org.mechservice.idl.Diagnostic;
import org.mechservice.idl.FailureRecord;
import org.mechservice.idl.SimDetail;
import org.mechservice.idl.SimEvent;
import org.mechservice.idl.StepTried;

/** Everything about one simulation, as JSON. */
public final class DetailJson {
  private DetailJson() {}

  /**
   * Returns everything about a simulation.
   *
   * @param server address of the server it came from
   */
  public static JsonObject of(String server, SimDetail detail) {
    JsonObject json = AdminJson.simulation(new KnownSimulation(server, detail.summary));
    json.add("failure", failure(detail.failed));
    json.add("report", parsed(detail.reportJson));
    json.add("checkReport", parsed(detail.checkReportJson));
    json.addProperty("modelText", detail.modelText);
    json.add("events", AdminJson.list(Arrays.asList(detail.events), DetailJson::event));
    json.add("curves", curves(Arrays.asList(detail.curves)));
    return json;
  }

  private static JsonElement failure(FailureRecord failed) {
    if (failed.code.isEmpty()) {
      return JsonNull.INSTANCE;
    }
    JsonObject json = new JsonObject();
    json.addProperty("code", failed.code);
    json.addProperty("text", failed.text);
    json.add("time", AdminJson.number(failed.simTime));
    json.add("stepSize", AdminJson.number(failed.stepSize));
    json.addProperty("order", failed.stepOrder);
    json.addProperty("part", failed.part);
    json.addProperty("advice", failed.advice);
    json.add("lastSteps", AdminJson.list(Arrays.asList(failed.lastSteps), DetailJson::step));
    return json;
  }

  private static JsonObject step(StepTried tried) {
    JsonObject json = new JsonObject();
    json.add("time", AdminJson.number(tried.simTime));
    json.add("stepSize", AdminJson.number(tried.stepSize));
    json.addProperty("order", tried.stepOrder);
    json.add("errorRatio", AdminJson.number(tried.errorRatio));
    return json;
  }

  /**
   * A server of another version may send text that is no JSON; the text is then shown unchanged.
   */
  private static JsonElement parsed(String text) {
    if (text.isEmpty()) {
      return JsonNull.INSTANCE;
    }
    try {
      return JsonParser.parseString(text);
    } catch (JsonParseException e) {
      return AdminJson.named("text", AdminJson.texts(text).get(0));
    }
  }

  private static JsonObject event(SimEvent event) {
    JsonObject json = new JsonObject();
    json.addProperty("number", event.seqNo);
    json.addProperty("at", QuantityText.instant(event.happenedAt));
    json.addProperty("state", KnownSimulation.label(event.info.state));
    json.add("time", AdminJson.number(event.info.simTime));
    json.addProperty("text", event.text);
    json.add("messages", AdminJson.list(Arrays.asList(event.messages), DetailJson::message));
    return json;
  }

  private static JsonObject message(Diagnostic said) {
    JsonObject json = new JsonObject();
    json.addProperty("level", AdminJson.level(said.level));
    json.addProperty("code", said.code);
    json.addProperty("text", said.text);
    return json;
  }

  /** Returns curves as one array each, which is shorter and ready to be drawn. */
  public static JsonObject curves(List<CurveSample> samples) {
    JsonArray at = new JsonArray();
    JsonArray time = new JsonArray();
    JsonArray stepSize = new JsonArray();
    JsonArray order = new JsonArray();
    JsonArray energyDrift = new JsonArray();
    JsonArray residual = new JsonArray();
    for (CurveSample sample : samples) {
      at.add(sample.takenAt);
      time.add(AdminJson.number(sample.simTime));
      stepSize.add(AdminJson.number(sample.stepSize));
      order.add(sample.stepOrder);
      energyDrift.add(AdminJson.number(sample.energyDrift));
      residual.add(AdminJson.number(sample.residual));
    }
    JsonObject json = AdminJson.named("at", at);
    json.add("time", time);
    json.add("stepSize", stepSize);
    json.add("order", order);
    json.add("energyDrift", energyDrift);
    json.add("residual", residual);
    return json;
  }
}
