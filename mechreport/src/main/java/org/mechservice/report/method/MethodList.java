package org.mechservice.report.method;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.DependentStates;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.capability.ProjectedStates;
import org.mechservice.solver.catalogue.ClosureMethod;
import org.mechservice.solver.catalogue.Formulation;
import org.mechservice.solver.catalogue.IntegrationMethod;
import org.mechservice.solver.catalogue.MethodNames;

/**
 * Every formulation, closure and integrator, tried on a scene: those that fit, built, and the
 * others with the reason why they do not.
 *
 * @param candidates methods that can be run
 * @param leftOut methods that cannot be run
 */
public record MethodList(List<Candidate> candidates, List<OmittedMethod> leftOut) {
  private static final List<String> FORMULATIONS = Formulation.labels();
  private static final List<String> INTEGRATORS =
      Arrays.stream(IntegrationMethod.values())
          .filter(method -> method.family() != IntegrationMethod.Family.SWITCHING)
          .map(IntegrationMethod::label)
          .toList();
  private static final List<String> CLOSURES = ClosureMethod.labels();

  public MethodList {
    candidates = List.copyOf(candidates);
    leftOut = List.copyOf(leftOut);
  }

  /**
   * Builds a model with all methods. Throws what the builder refuses it with if it cannot be built
   * at all.
   */
  public static MethodList of(MethodBuilds builds) {
    List<Candidate> candidates = new ArrayList<>();
    List<OmittedMethod> leftOut = new ArrayList<>();
    boolean loops = hasLoops(builds.chosen());
    for (String formulation : FORMULATIONS) {
      for (String closure : loops ? CLOSURES : List.of(MethodNames.NONE)) {
        for (String integrator : INTEGRATORS) {
          SimulationMethod method = new SimulationMethod(formulation, closure, integrator);
          try {
            candidates.add(builds.candidate(method));
          } catch (BuildRefusedException e) {
            leftOut.add(new OmittedMethod(method, e.reason()));
          }
        }
      }
    }
    return new MethodList(candidates, leftOut);
  }

  /** Returns whether the equations of a model close loops. */
  static boolean hasLoops(Model model) {
    Model equations = ModelParts.of(model).equations();
    return equations instanceof DependentStates || equations instanceof ProjectedStates;
  }
}
