package org.mechservice.sim.model;

import java.util.List;
import java.util.Set;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.emit.TermsClass;
import org.mechservice.sim.scene.FormulationChoice;
import org.mechservice.sim.scene.GenerationLimits;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.symbol.Program;

/**
 * Description of the class that would be generated from a model.
 *
 * @param choice the formulation and the reason for it
 * @param operations operations per evaluation; 0 if the model is data
 * @param leftOut parts that the class omits
 */
public record CodeForecast(FormulationChoice choice, int operations, List<Omission> leftOut) {
  public CodeForecast {
    leftOut = List.copyOf(leftOut);
  }

  /**
   * Derives the equations of a model and describes its code without writing it.
   *
   * @throws org.mechservice.sim.scene.ModelBuildException S-081 if the formulation or closure does
   *     not fit the scene or does not exist
   */
  public static CodeForecast of(MechmlModel model) {
    FormulationChoice choice =
        FormulationChoice.of(
            model.settings().formulation(),
            model.settings().closure(),
            model.settings().run(),
            model);
    List<String> notGenerated =
        GenerationLimits.leftToData(
            model.watchedMechanism(),
            choice,
            () -> model.closedStart(model.settings().run().tStart()).rank());
    if (!notGenerated.isEmpty()) {
      return data(choice, notGenerated);
    }
    BuildOptions options = new BuildOptions(choice.formulation(), Set.of(), model.settings().run());
    Links links = Links.of(model.mechanism());
    Program derivative;
    List<String> noFaster;
    if (model.mechanism().closures().isEmpty()) {
      derivative = TreeClass.derivative(links, choice);
      noFaster = GenerationLimits.noFaster(choice.formulation(), derivative.operationCount());
    } else {
      TermsClass terms = LoopTermsClass.derive(model, links, options, choice);
      derivative = terms.equations();
      noFaster = LoopTermsClass.noFaster(terms, choice);
    }
    if (!noFaster.isEmpty()) {
      return data(choice, noFaster);
    }
    return new CodeForecast(
        choice.callingForcesOf(model.mechanism()),
        derivative.operationCount(),
        Omissions.unneeded(model, links, options, derivative));
  }

  private static CodeForecast data(FormulationChoice choice, List<String> notGenerated) {
    String why = "none is generated yet for " + String.join(", ", notGenerated);
    return new CodeForecast(choice, 0, List.of(new Omission("code of its own", why)));
  }
}
