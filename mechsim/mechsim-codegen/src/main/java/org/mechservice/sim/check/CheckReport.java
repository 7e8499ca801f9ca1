package org.mechservice.sim.check;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.SimulationSettings;
import org.mechservice.sim.model.CodeForecast;
import org.mechservice.sim.scene.Finding;
import org.mechservice.sim.scene.LoopAnalysis;
import org.mechservice.sim.scene.ModelBuildException;
import org.mechservice.sim.scene.RoadmapEntry;
import org.mechservice.sim.scene.SceneAnalysis;
import org.mechservice.sim.scene.forecast.RunForecast;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * Report of a model before it runs: its tree and loops, its degrees of freedom, the residuals of
 * the loops at the start, the layout of the state, suspicious data, and the parts that a generated
 * class omits.
 *
 * @param model the model as read
 * @param scene its tree
 * @param loops its loops
 * @param findings suspicious data in the scene
 * @param generation the code that would be generated; empty if the model cannot be built
 * @param noGeneration why the model cannot be built; empty if it can
 */
public record CheckReport(
    MechmlModel model,
    SceneAnalysis scene,
    LoopAnalysis loops,
    List<Finding> findings,
    Optional<CodeForecast> generation,
    String noGeneration) {

  /** Heading, in the text of a report, of the reason why no run can begin. */
  public static final String UNUSABLE = "Cannot be used";

  public CheckReport {
    findings = List.copyOf(findings);
  }

  /** Checks a model with the settings of its file. */
  public static CheckReport of(MechmlModel model) {
    SimulationSettings settings = model.settings();
    return of(model, settings.formulation(), settings.closure(), settings.run());
  }

  /**
   * Checks a model.
   *
   * @param formulation of the run, {@code auto} or a name
   * @param closure of the run, {@code auto} or a name
   * @param run settings of the run
   */
  public static CheckReport of(
      MechmlModel model, String formulation, String closure, RunSettings run) {
    Mechanism mechanism = model.mechanism();
    SceneAnalysis scene = SceneAnalysis.of(mechanism);
    LoopAnalysis loops = LoopAnalysis.of(model);
    List<Finding> findings = RunForecast.of(model, formulation, closure, run);
    try {
      return new CheckReport(
          model, scene, loops, findings, Optional.of(CodeForecast.of(model)), "");
    } catch (ModelBuildException e) {
      String why = String.valueOf(e.getMessage());
      return new CheckReport(model, scene, loops, findings, Optional.empty(), why);
    }
  }

  /** Returns the warnings: those of the file's reader, then those of the scene. */
  public List<String> warnings() {
    List<String> warnings = new ArrayList<>();
    model.warnings().forEach(diagnostic -> warnings.add(diagnostic.toString()));
    findings.forEach(finding -> warnings.add(finding.toString()));
    return warnings;
  }

  /** Returns why no run of the model can begin; empty if one can. */
  public Optional<String> refusal() {
    if (generation.isEmpty()) {
      return Optional.of(noGeneration);
    }
    if (loops.isJudged()) {
      return Optional.empty();
    }
    return findings.stream()
        .filter(finding -> finding.code() == MessageCode.LOOPS_OPEN_AT_START)
        .map(Finding::toString)
        .findFirst();
  }

  /** Returns the roadmap of the state. */
  public List<RoadmapEntry> roadmap() {
    return scene.roadmap();
  }

  /**
   * Returns velocities minus equations, the degrees of freedom by count; too small if equations are
   * redundant.
   */
  public int freedomsByCount() {
    return scene.degreesOfFreedom() - loops.equations();
  }

  /** Returns the number of degrees of freedom: by rank if it is known, otherwise by count. */
  public int degreesOfFreedom() {
    return loops.isJudged() ? scene.degreesOfFreedom() - loops.independent() : freedomsByCount();
  }

  /** Returns the report as text, lines separated by line feeds. */
  public String text() {
    return new CheckText(this).text();
  }

  /** Returns the report as one JSON object. */
  public String json() {
    return new CheckJson(this).json();
  }
}
