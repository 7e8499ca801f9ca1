package org.mechservice.sim.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.equations.links.Links;
import org.mechservice.sim.scene.Finding;
import org.mechservice.sim.scene.FormulationChoice;
import org.mechservice.sim.scene.GenerationLimits;
import org.mechservice.sim.scene.LoopAnalysis;
import org.mechservice.sim.scene.ModelBuildException;
import org.mechservice.sim.scene.RoadmapEntry;
import org.mechservice.sim.scene.RunForecast;
import org.mechservice.sim.scene.SceneAnalysis;
import org.mechservice.sim.symbolic.Program;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * What can be said of a model before it runs: its tree and loops, its degrees of freedom, how well
 * the start closes the loops, where each joint is in the state, what looks odd, and what a class
 * generated from it leaves out.
 *
 * @param model what was read
 * @param scene its tree
 * @param loops its loops
 * @param findings what looks odd in the scene
 * @param generation what code would be generated; empty if none is
 * @param noGeneration why not; empty if code is generated
 */
public record CheckReport(
    MechmlModel model,
    SceneAnalysis scene,
    LoopAnalysis loops,
    List<Finding> findings,
    Optional<Generation> generation,
    String noGeneration) {

  /**
   * What a generated class would be.
   *
   * @param choice the formulation and why
   * @param operations operations per evaluation
   * @param leftOut what the class does not hold
   */
  public record Generation(FormulationChoice choice, int operations, List<Omission> leftOut) {
    public Generation {
      leftOut = List.copyOf(leftOut);
    }
  }

  public CheckReport {
    findings = List.copyOf(findings);
  }

  /** Checks a model. */
  public static CheckReport of(MechmlModel model) {
    Mechanism mechanism = model.mechanism();
    SceneAnalysis scene = SceneAnalysis.of(mechanism);
    LoopAnalysis loops = LoopAnalysis.of(mechanism, model.settings().run());
    List<Finding> findings =
        new ArrayList<>(scene.findingsAtStart(model.settings().run().tStart()));
    findings.addAll(loops.findings());
    findings.addAll(
        RunForecast.of(mechanism, model.settings().formulation(), model.settings().run()));
    try {
      return new CheckReport(model, scene, loops, findings, Optional.of(generation(model)), "");
    } catch (ModelBuildException e) {
      String why = String.valueOf(e.getMessage());
      return new CheckReport(model, scene, loops, findings, Optional.empty(), why);
    }
  }

  private static Generation generation(MechmlModel model) {
    FormulationChoice choice =
        FormulationChoice.of(
            model.settings().formulation(),
            model.settings().closure(),
            model.settings().run(),
            model.mechanism());
    List<String> notGenerated = GenerationLimits.notGenerated(model.watchedMechanism(), choice);
    if (!notGenerated.isEmpty()) {
      return data(choice, notGenerated);
    }
    BuildOptions options = new BuildOptions(choice.formulation(), Set.of(), model.settings().run());
    Links links = Links.of(model.mechanism());
    Program derivative =
        model.mechanism().closures().isEmpty()
            ? TreeClass.derivative(links, choice)
            : LoopTermsClass.derive(model, links, options, choice).equations();
    List<String> noFaster =
        GenerationLimits.noFaster(choice.formulation(), derivative.operationCount());
    if (!noFaster.isEmpty()) {
      return data(choice, noFaster);
    }
    return new Generation(
        choice.callingForcesOf(model.mechanism()),
        derivative.operationCount(),
        LeftOut.of(model, links, options, derivative));
  }

  private static Generation data(FormulationChoice choice, List<String> notGenerated) {
    String why = "none is generated yet for " + String.join(", ", notGenerated);
    return new Generation(choice, 0, List.of(new Omission("code of its own", why)));
  }

  /** Returns what looks odd: what the file's reader noticed, then what the scene shows. */
  public List<String> warnings() {
    List<String> warnings = new ArrayList<>();
    model.warnings().forEach(diagnostic -> warnings.add(diagnostic.toString()));
    findings.forEach(finding -> warnings.add(finding.toString()));
    return warnings;
  }

  /** Returns the roadmap of the state. */
  public List<RoadmapEntry> roadmap() {
    return scene.roadmap();
  }

  /** Returns the number of degrees of freedom by count: negative where equations repeat others. */
  public int freedomsByCount() {
    return scene.degreesOfFreedom() - loops.equations();
  }

  /** Returns the number of degrees of freedom: by rank if it is known, else by count. */
  public int degreesOfFreedom() {
    return loops.isJudged() ? scene.degreesOfFreedom() - loops.independent() : freedomsByCount();
  }

  /** Returns the report for people, lines separated by line feeds. */
  public String text() {
    return new CheckText(this).text();
  }

  /** Returns the report as one JSON object. */
  public String json() {
    return new CheckJson(this).json();
  }
}
