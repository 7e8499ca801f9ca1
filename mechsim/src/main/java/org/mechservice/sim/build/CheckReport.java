package org.mechservice.sim.build;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.mechservice.mechml.Diagnostic;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.build.dynamics.ArticulatedBodyEquations;
import org.mechservice.sim.build.dynamics.Links;
import org.mechservice.sim.scene.Finding;
import org.mechservice.sim.scene.FormulationChoice;
import org.mechservice.sim.scene.GenerationLimits;
import org.mechservice.sim.scene.RoadmapEntry;
import org.mechservice.sim.scene.SceneAnalysis;
import org.mechservice.sim.scene.TreeDrawing;
import org.mechservice.sim.symbolic.Program;
import org.mechservice.solver.standalone.ShortestDecimal;

/**
 * What can be said of a model before it runs: its tree, its degrees of freedom, where each joint is
 * in the state, what looks odd, and what a class generated from it leaves out.
 */
public final class CheckReport {
  private final MechmlModel model;
  private final SceneAnalysis scene;
  private final FormulationChoice choice;
  private final int operations;
  private final List<Omission> leftOut;

  private CheckReport(
      MechmlModel model,
      SceneAnalysis scene,
      FormulationChoice choice,
      int operations,
      List<Omission> leftOut) {
    this.model = model;
    this.scene = scene;
    this.choice = choice;
    this.operations = operations;
    this.leftOut = leftOut;
  }

  /**
   * Checks a model.
   *
   * @throws org.mechservice.sim.scene.ModelBuildException (an {@link IllegalArgumentException}) if
   *     the formulation its file asks for does not fit
   */
  public static CheckReport of(MechmlModel model) {
    SceneAnalysis scene = SceneAnalysis.of(model.mechanism());
    FormulationChoice choice =
        FormulationChoice.of(
            model.settings().formulation(),
            model.settings().closure(),
            model.settings().run().integrator(),
            model.mechanism());
    if (!GenerationLimits.notGenerated(model.mechanism(), choice).isEmpty()) {
      return new CheckReport(model, scene, choice, 0, List.of());
    }
    Links links = Links.of(model.mechanism());
    Program derivative = ArticulatedBodyEquations.derive(links);
    BuildOptions options = new BuildOptions(choice.formulation(), Set.of(), model.settings().run());
    return new CheckReport(
        model,
        scene,
        choice,
        derivative.operationCount(),
        LeftOut.of(scene, links, options, derivative));
  }

  /** Returns what looks odd: what the file's reader noticed, then what the scene shows. */
  public List<String> warnings() {
    List<String> warnings = new ArrayList<>();
    model.warnings().forEach(diagnostic -> warnings.add(diagnostic.toString()));
    scene.findings().forEach(finding -> warnings.add(finding.toString()));
    return warnings;
  }

  /** Returns the roadmap of the state. */
  public List<RoadmapEntry> roadmap() {
    return scene.roadmap();
  }

  /** Returns the report for people, lines separated by line feeds. */
  public String text() {
    StringBuilder text = new StringBuilder();
    text.append(scene.mechanism().name()).append("\n\n");
    TreeDrawing.of(scene.mechanism()).forEach(line -> text.append("  ").append(line).append('\n'));
    text.append('\n').append(freedoms()).append('\n');
    text.append("Formulation: ")
        .append(choice.formulation())
        .append(" (")
        .append(choice.reason())
        .append(')')
        .append(operations == 0 ? "" : ", " + operations + " operations per evaluation")
        .append('\n');
    roadmap(text);
    list(text, "Warnings", warnings());
    list(
        text,
        "Left out of the generated class",
        leftOut.stream().map(omission -> omission.what() + ": " + omission.why()).toList());
    return text.toString();
  }

  private String freedoms() {
    int massless = scene.massless().size();
    return "Degrees of freedom: "
        + scene.degreesOfFreedom()
        + "; bodies: "
        + scene.mechanism().bodies().size()
        + (massless == 0 ? "" : " (" + massless + " massless)")
        + "; mass: "
        + ShortestDecimal.format(scene.mass())
        + " kg; loops: 0; redundant equations: 0";
  }

  private void roadmap(StringBuilder text) {
    text.append("\nState y = [q; v]:\n");
    int width = roadmap().stream().mapToInt(entry -> entry.joint().length()).max().orElse(0);
    for (RoadmapEntry entry : roadmap()) {
      text.append("  q[")
          .append(entry.position())
          .append("] v[")
          .append(entry.velocity())
          .append("]  ")
          .append(entry.joint())
          .append(" ".repeat(width - entry.joint().length()))
          .append("  ")
          .append(entry.type())
          .append("  ")
          .append(entry.positionUnit())
          .append(", ")
          .append(entry.velocityUnit())
          .append("  axis ")
          .append(entry.axis())
          .append('\n');
    }
  }

  private static void list(StringBuilder text, String title, List<String> lines) {
    text.append('\n').append(title).append(lines.isEmpty() ? ": none\n" : ":\n");
    lines.forEach(line -> text.append("  ").append(line).append('\n'));
  }

  /** Returns the report as one JSON object. */
  public String json() {
    JsonObject report = new JsonObject();
    report.addProperty("scene", scene.mechanism().name());
    report.addProperty("degreesOfFreedom", scene.degreesOfFreedom());
    report.addProperty("bodies", scene.mechanism().bodies().size());
    report.addProperty("mass", scene.mass());
    report.addProperty("loops", 0);
    report.addProperty("redundantEquations", 0);
    report.addProperty("formulation", choice.formulation());
    report.addProperty("formulationReason", choice.reason());
    report.addProperty("operations", operations);
    Gson gson = new GsonBuilder().disableHtmlEscaping().create();
    report.add("massless", gson.toJsonTree(scene.massless()));
    report.add("tree", gson.toJsonTree(TreeDrawing.of(scene.mechanism())));
    report.add("roadmap", jsonRoadmap());
    report.add("warnings", jsonWarnings());
    report.add("leftOut", gson.toJsonTree(leftOut));
    return gson.toJson(report);
  }

  private JsonArray jsonRoadmap() {
    JsonArray entries = new JsonArray();
    for (RoadmapEntry entry : roadmap()) {
      JsonObject object = new JsonObject();
      object.addProperty("joint", entry.joint());
      object.addProperty("type", entry.type().name());
      object.addProperty("axis", entry.axis());
      object.addProperty("q", entry.position());
      object.addProperty("v", entry.velocity());
      object.addProperty("positionUnit", entry.positionUnit());
      object.addProperty("velocityUnit", entry.velocityUnit());
      entries.add(object);
    }
    return entries;
  }

  private JsonArray jsonWarnings() {
    JsonArray warnings = new JsonArray();
    for (Diagnostic diagnostic : model.warnings()) {
      warnings.add(
          warning(diagnostic.code(), diagnostic.message(), diagnostic.file(), diagnostic.line()));
    }
    for (Finding finding : scene.findings()) {
      warnings.add(
          warning(
              finding.code(), finding.text(), finding.origin().file(), finding.origin().line()));
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
