package org.mechservice.report.method;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.mechservice.client.MechSession;
import org.mechservice.client.SimulationOptions;
import org.mechservice.client.failure.InvalidOptionException;
import org.mechservice.client.failure.NotAvailableException;
import org.mechservice.client.failure.ServerLostException;
import org.mechservice.client.failure.ServiceException;
import org.mechservice.client.jar.LocalModel;
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
   * Asks the service for all methods of the model a session has loaded.
   *
   * @throws ServiceException if the model cannot be built at all; says why
   */
  public static MethodList of(MechSession session) {
    List<Candidate> candidates = new ArrayList<>();
    List<OmittedMethod> leftOut = new ArrayList<>();
    boolean loops = hasLoops(chosenByService(session));
    for (String formulation : FORMULATIONS) {
      for (String closure : loops ? CLOSURES : List.of(MethodNames.NONE)) {
        for (String integrator : INTEGRATORS) {
          SimulationMethod method = new SimulationMethod(formulation, closure, integrator);
          try {
            LocalModel model = session.fetchModel(options(method));
            candidates.add(new Candidate(method, model::newModel, model.solver()));
          } catch (InvalidOptionException | NotAvailableException e) {
            leftOut.add(new OmittedMethod(method, String.valueOf(e.getMessage())));
          } catch (ServerLostException e) {
            // A build that takes too long is no reason to be silent about the other methods.
            if (candidates.isEmpty()) {
              throw e;
            }
            leftOut.add(new OmittedMethod(method, String.valueOf(e.getMessage())));
          }
        }
      }
    }
    return new MethodList(candidates, leftOut);
  }

  /** Builds the model with the service's own choice; a refusal of it holds for all methods. */
  private static Model chosenByService(MechSession session) {
    LocalModel chosen =
        session.fetchModel(
            SimulationOptions.asInFile()
                .formulation(MethodNames.AUTO)
                .integrator(MethodNames.AUTO));
    return chosen.newModel();
  }

  /** Returns whether the equations of a model close loops. */
  static boolean hasLoops(Model model) {
    Model equations = ModelParts.of(model).equations();
    return equations instanceof DependentStates || equations instanceof ProjectedStates;
  }

  /** Returns the options that choose a method. */
  public static SimulationOptions options(SimulationMethod method) {
    SimulationOptions options =
        SimulationOptions.asInFile()
            .formulation(method.formulation())
            .integrator(method.integrator());
    return method.closure().equals(MethodNames.NONE) ? options : options.closure(method.closure());
  }
}
