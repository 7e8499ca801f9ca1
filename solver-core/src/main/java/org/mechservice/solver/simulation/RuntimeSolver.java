package org.mechservice.solver.simulation;

import java.io.IOException;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ResultSink;
import org.mechservice.solver.api.RunControl;
import org.mechservice.solver.api.RunReport;
import org.mechservice.solver.api.RunRequest;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.integration.De;
import org.mechservice.solver.integration.IntegratorFactory;
import org.mechservice.solver.integration.Ode113;

/** The solver of the runtime JAR: holds every integrator and takes the one a run names. */
public final class RuntimeSolver implements Solver {
  @Override
  public RunReport run(Model model, RunRequest request, ResultSink sink, RunControl control)
      throws IOException {
    return new Simulation(integrator(request.settings().integrator()))
        .run(model, request, sink, control);
  }

  private static IntegratorFactory integrator(String name) {
    return switch (name) {
      case "ode113" -> Ode113::new;
      case "DE" -> De::new;
      default ->
          throw new IllegalArgumentException(
              "S-063 integrator \"" + name + "\" is unknown; this version has ode113 and DE");
    };
  }
}
