package org.mechservice.sim.service;

import com.google.gson.JsonNull;
import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;
import java.util.LinkedHashMap;
import java.util.Map;
import org.mechservice.orb.ServiceVersion;
import org.mechservice.sim.model.GeneratedFacts;

/**
 * What the service knows of a run beyond the solver's report.
 *
 * @param host name of the host it runs on
 * @param modelSha256 of the MechML file
 * @param formulationReason why this formulation
 * @param times what setting it up has cost this process, s
 */
record RunFacts(
    String host, String modelSha256, String formulationReason, Map<String, Double> times) {

  static RunFacts of(String host, LoadedModel loaded, GeneratedFacts generated, SetUpTimes times) {
    Map<String, Double> ofRemoteRun = new LinkedHashMap<>(times.asMap());
    ofRemoteRun.remove("t2s"); // no JAR is made for a run here
    return new RunFacts(host, loaded.sha256(), generated.formulationReason(), ofRemoteRun);
  }

  /**
   * Returns the run report as one flat JSON object; a number that is not finite is null.
   *
   * @param ofSolver the solver's report
   * @param verdict how the service saw the run end
   */
  String json(Map<String, Object> ofSolver, RunVerdict verdict) {
    Map<String, Object> all = new LinkedHashMap<>(ofSolver);
    verdict
        .failure()
        .ifPresent(
            failure -> {
              all.put("outcome", "failed");
              all.put("failure", failure.message());
            });
    all.put("where", "remote, host " + host);
    all.put("modelSha256", modelSha256);
    all.put("formulationReason", formulationReason);
    all.putAll(times);
    all.put("serverVersion", ServiceVersion.CURRENT);
    JsonObject json = new JsonObject();
    all.forEach((key, value) -> add(json, key, value));
    return json.toString();
  }

  private static void add(JsonObject json, String key, Object value) {
    if (value instanceof Double number) {
      json.add(key, Double.isFinite(number) ? new JsonPrimitive(number) : JsonNull.INSTANCE);
    } else if (value instanceof Long number) {
      json.addProperty(key, number);
    } else if (value instanceof Boolean flag) {
      json.addProperty(key, flag);
    } else {
      json.addProperty(key, value.toString());
    }
  }
}
