package org.mechservice.sim.check;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.util.List;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.sim.model.CodeForecast;
import org.mechservice.sim.scene.Finding;
import org.mechservice.sim.scene.RoadmapEntry;
import org.mechservice.sim.scene.SceneAnalysis;

/** A check's report as one JSON object. */
final class CheckJson {
  private final CheckReport report;
  private final Gson gson = new GsonBuilder().disableHtmlEscaping().create();

  CheckJson(CheckReport report) {
    this.report = report;
  }

  String json() {
    SceneAnalysis scene = report.scene();
    JsonObject object = new JsonObject();
    object.addProperty("scene", scene.mechanism().name());
    object.addProperty("degreesOfFreedom", report.degreesOfFreedom());
    object.addProperty("degreesOfFreedomByCount", report.freedomsByCount());
    object.addProperty("treeFreedoms", scene.degreesOfFreedom());
    object.addProperty("bodies", scene.mechanism().bodies().size());
    object.addProperty("mass", scene.mass() + scene.rodMass());
    object.addProperty("loops", report.loops().loops().size());
    object.addProperty("equations", report.loops().equations());
    if (report.loops().isJudged()) {
      object.addProperty("independentEquations", report.loops().independent());
      object.addProperty("redundantEquations", report.loops().redundant());
    }
    object.addProperty(
        "formulation", report.generation().map(g -> g.choice().formulation()).orElse("none"));
    object.addProperty(
        "formulationReason",
        report.generation().map(g -> g.choice().reason()).orElse(report.noGeneration()));
    report.generation().ifPresent(g -> object.addProperty("operations", g.operations()));
    object.add("massless", gson.toJsonTree(scene.massless()));
    object.add("tree", gson.toJsonTree(TreeDrawing.of(scene.mechanism())));
    object.add("constraints", gson.toJsonTree(report.loops().loops()));
    object.add("roadmap", roadmap());
    if (!scene.mechanism().furtherStates().isEmpty()) {
      object.add("states", gson.toJsonTree(scene.mechanism().stateVariables()));
    }
    object.add("forces", gson.toJsonTree(scene.forces()));
    object.add("unused", gson.toJsonTree(report.model().unused()));
    object.add("dataFiles", gson.toJsonTree(report.model().dataFiles()));
    object.add("warnings", warnings());
    report.refusal().ifPresent(why -> object.addProperty("unusable", why));
    object.add("simpler", gson.toJsonTree(scene.offers()));
    object.add(
        "leftOut",
        gson.toJsonTree(report.generation().map(CodeForecast::leftOut).orElse(List.of())));
    return gson.toJson(object);
  }

  private JsonArray roadmap() {
    JsonArray entries = new JsonArray();
    for (RoadmapEntry entry : report.roadmap()) {
      JsonObject object = new JsonObject();
      object.addProperty("joint", entry.joint());
      object.addProperty("type", entry.type().name());
      object.addProperty("axis", entry.axis());
      object.addProperty("q", entry.position());
      object.addProperty("v", entry.velocity());
      object.addProperty("positionUnit", entry.positionUnit());
      object.addProperty("velocityUnit", entry.velocityUnit());
      object.addProperty("driven", entry.driven());
      entries.add(object);
    }
    return entries;
  }

  private JsonArray warnings() {
    JsonArray warnings = new JsonArray();
    for (Diagnostic said : report.model().warnings()) {
      warnings.add(warning(said.code().code(), said.message(), said.file(), said.line()));
    }
    for (Finding finding : report.findings()) {
      warnings.add(
          warning(
              finding.code().code(),
              finding.text(),
              finding.origin().file(),
              finding.origin().line()));
    }
    return warnings;
  }

  private static JsonObject warning(String code, String text, String file, int line) {
    JsonObject warning = new JsonObject();
    warning.addProperty("code", code);
    warning.addProperty("message", text);
    warning.addProperty("file", file);
    warning.addProperty("line", line);
    return warning;
  }
}
