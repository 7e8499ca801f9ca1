package org.mechservice.cli.model;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.mechservice.cli.shell.JUnitFile;
import org.mechservice.cli.shell.OutputFile;
import org.mechservice.client.failure.InvalidModelException;
import org.mechservice.client.failure.ModelMessage;
import org.mechservice.client.failure.ModelMessage.Severity;
import org.mechservice.solver.simulation.SolverVersion;

/** What {@code mech check} has found, for programs: SARIF 2.1.0 and the XML of JUnit. */
final class CheckFindings {
  private static final Gson JSON =
      new GsonBuilder().setPrettyPrinting().disableHtmlEscaping().create();
  private static final String SCHEMA = "https://json.schemastore.org/sarif-2.1.0.json";
  private static final String UNUSABLE = "a run of the model can begin";

  private final Path model;
  private final List<ModelMessage> messages;

  private CheckFindings(Path model, List<ModelMessage> messages) {
    this.model = model;
    this.messages = messages;
  }

  /** Takes the messages of a model that cannot be read. */
  static CheckFindings of(Path model, InvalidModelException refused) {
    List<ModelMessage> messages = new ArrayList<>(refused.messages());
    if (messages.isEmpty()) {
      messages.add(
          error(model, String.valueOf(refused.code()), String.valueOf(refused.getMessage())));
    }
    return new CheckFindings(model, messages);
  }

  /**
   * Takes a report.
   *
   * @param json as JSON
   */
  static CheckFindings of(Path model, String json) {
    JsonObject report = JsonParser.parseString(json).getAsJsonObject();
    List<ModelMessage> messages = new ArrayList<>();
    for (JsonElement one : report.getAsJsonArray("warnings")) {
      JsonObject said = one.getAsJsonObject();
      messages.add(
          new ModelMessage(
              Severity.WARNING,
              said.get("code").getAsString(),
              said.get("message").getAsString(),
              said.get("file").getAsString(),
              said.get("line").getAsInt(),
              0,
              ""));
    }
    if (report.has("unusable")) {
      String why = report.get("unusable").getAsString();
      messages.add(
          error(model, why.matches("(?s)[MNS]-\\d{3} .*") ? why.substring(0, 5) : "", why));
    }
    return new CheckFindings(model, messages);
  }

  private static ModelMessage error(Path model, String code, String text) {
    return new ModelMessage(Severity.ERROR, code, text, model.toString(), 0, 0, "");
  }

  /**
   * Writes the findings as a log of SARIF.
   *
   * @throws IOException if the file cannot be written
   */
  void writeSarif(Path file) throws IOException {
    Map<String, JsonObject> rules = new TreeMap<>();
    JsonArray results = new JsonArray();
    for (ModelMessage message : messages) {
      rules.computeIfAbsent(message.code(), CheckFindings::rule);
      JsonObject result = new JsonObject();
      result.addProperty("ruleId", message.code());
      result.addProperty(
          "level",
          switch (message.severity()) {
            case INFO -> "note";
            case WARNING -> "warning";
            case ERROR -> "error";
          });
      result.add("message", text(message.text()));
      result.add("locations", locations(message));
      results.add(result);
    }
    JsonArray listed = new JsonArray();
    rules.values().forEach(listed::add);
    JsonObject driver = new JsonObject();
    driver.addProperty("name", "mech check");
    driver.addProperty("version", SolverVersion.CURRENT);
    driver.add("rules", listed);
    JsonObject tool = new JsonObject();
    tool.add("driver", driver);
    JsonObject run = new JsonObject();
    run.add("tool", tool);
    run.addProperty("columnKind", "utf16CodeUnits");
    run.add("results", results);
    JsonArray runs = new JsonArray();
    runs.add(run);
    JsonObject log = new JsonObject();
    log.addProperty("$schema", SCHEMA);
    log.addProperty("version", "2.1.0");
    log.add("runs", runs);
    OutputFile.write(file, (JSON.toJson(log) + "\n").getBytes(StandardCharsets.UTF_8));
  }

  private static JsonObject rule(String code) {
    JsonObject rule = new JsonObject();
    rule.addProperty("id", code);
    return rule;
  }

  private static JsonObject text(String text) {
    JsonObject object = new JsonObject();
    object.addProperty("text", text);
    return object;
  }

  private JsonArray locations(ModelMessage message) {
    String name = message.fileName();
    boolean own = name.isEmpty() || name.equals(String.valueOf(model.getFileName()));
    JsonObject artifact = new JsonObject();
    artifact.addProperty(
        "uri", (own ? model.toString() : name).replace('\\', '/').replace(" ", "%20"));
    JsonObject physical = new JsonObject();
    physical.add("artifactLocation", artifact);
    if (message.line() > 0) {
      JsonObject region = new JsonObject();
      region.addProperty("startLine", message.line());
      if (message.column() > 0) {
        region.addProperty("startColumn", message.column());
      }
      physical.add("region", region);
    }
    JsonObject location = new JsonObject();
    location.add("physicalLocation", physical);
    JsonArray locations = new JsonArray();
    locations.add(location);
    return locations;
  }

  /**
   * Writes the findings as test cases: one for the model, which fails by its errors, and one for
   * each warning, which fails if warnings are errors.
   *
   * @throws IOException if the file cannot be written
   */
  void writeJUnit(Path file, boolean strict) throws IOException {
    JUnitFile cases = new JUnitFile("mech check " + model);
    List<String> errors =
        messages.stream()
            .filter(one -> one.severity() == Severity.ERROR)
            .map(ModelMessage::toString)
            .toList();
    if (errors.isEmpty()) {
      cases.passed(UNUSABLE);
    } else {
      cases.failed(UNUSABLE, String.join("\n", errors));
    }
    for (ModelMessage message : messages) {
      if (message.severity() != Severity.ERROR) {
        if (strict) {
          cases.failed(message.code(), message.toString());
        } else {
          cases.passed(message.toString());
        }
      }
    }
    cases.write(file);
  }
}
