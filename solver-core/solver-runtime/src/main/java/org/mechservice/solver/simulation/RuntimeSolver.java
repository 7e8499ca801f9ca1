package org.mechservice.solver.simulation;

import java.io.IOException;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.api.capability.DependentStates;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.capability.ProjectedStates;
import org.mechservice.solver.api.capability.ResidualModel;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.run.Checkpoints;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.StepwiseRun;
import org.mechservice.solver.catalogue.IntegrationMethod;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.ode.IntegratorFactory;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.adams.De;
import org.mechservice.solver.ode.adams.Ode113;
import org.mechservice.solver.ode.jumps.UndeclaredJumps;
import org.mechservice.solver.ode.step.WatchedIntegrator;
import org.mechservice.solver.ode.stiff.Ode15s;
import org.mechservice.solver.ode.stiff.Ode15sR;
import org.mechservice.solver.ode.switching.Switching;
import org.mechservice.solver.simulation.equations.EquationForm;
import org.mechservice.solver.simulation.equations.ExplicitForm;
import org.mechservice.solver.simulation.equations.ExplicitLoopForm;
import org.mechservice.solver.simulation.equations.ResidualForm;
import org.mechservice.solver.simulation.equations.WatchedForm;

/**
 * The solver of the runtime JAR: selects the integrator that a run names, with the form of the
 * equations that fits the integrator and the model, and with {@link UndeclaredJumps} around it
 * exactly where a model has forces by classes of users.
 */
public final class RuntimeSolver implements Solver {
  @Override
  public RunReport run(Model model, RunRequest request, ResultSink sink, RunControl control)
      throws IOException {
    return run(model, request, sink, control, Checkpoints.NONE);
  }

  @Override
  public RunReport run(
      Model model, RunRequest request, ResultSink sink, RunControl control, Checkpoints checkpoints)
      throws IOException {
    if (AnalysisSolver.takes(model)) {
      return new AnalysisSolver().run(model, request, sink, control);
    }
    String name = request.settings().integrator();
    MotionObserver seen = new MotionObserver(sink, model.description());
    RunReport report =
        new Simulation(integrators(model, name), formOf(model, name))
            .run(model, request, seen, control, checkpoints);
    return seen.completed(report, request);
  }

  @Override
  public StepwiseRun stepped(Model model, RunRequest request, ResultSink sink, String modelHash)
      throws IOException {
    if (AnalysisSolver.takes(model)) {
      throw new IllegalArgumentException(
          MessageCode.RUN_CANNOT_BE_STEPPED
              + " model \""
              + model.description().name()
              + "\" is not integrated in time by this simulation, so it has no steps; choose a"
              + " simulation of kind <dynamic>");
    }
    String name = request.settings().integrator();
    return new Simulation(integrators(model, name), formOf(model, name))
        .stepped(model, request, sink, modelHash);
  }

  /** Returns the form of a model's equations for an integrator. */
  public static EquationForm formOf(Model model, String integrator) {
    ModelParts parts = ModelParts.of(model);
    EquationForm form = formOfEquations(parts.equations(), integrator);
    return parts.events().isPresent() ? new WatchedForm(form) : form;
  }

  private static EquationForm formOfEquations(Model model, String integrator) {
    if (takesResidual(integrator) && model instanceof ResidualModel) {
      return new ResidualForm();
    }
    boolean loops = model instanceof DependentStates || model instanceof ProjectedStates;
    return loops ? new ExplicitLoopForm() : new ExplicitForm();
  }

  private static boolean takesResidual(String integrator) {
    return IntegrationMethod.find(integrator).filter(IntegrationMethod::takesResidual).isPresent();
  }

  /**
   * Returns the factory of the integrator of a name, which searches for jumps in what classes of
   * users compute, if the model has any.
   */
  private static IntegratorFactory integrators(Model model, String name) {
    IntegrationMethod method = IntegrationMethod.of(name);
    return model.hasUserClasses()
        ? settings -> UndeclaredJumps.around(integrator(method, settings))
        : settings -> integrator(method, settings);
  }

  /** Returns the integrator of a method; the compiler requires a branch for each. */
  private static WatchedIntegrator integrator(
      IntegrationMethod method, IntegratorSettings settings) {
    return switch (method) {
      case ODE113 -> new Ode113(settings);
      case DE -> new De(settings);
      case ODE15S -> new Ode15s(settings);
      case ODE15SR -> new Ode15sR(settings);
      case SWITCHING -> new Switching(settings);
    };
  }
}
