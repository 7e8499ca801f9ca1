package org.mechservice.benchmarks;

import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorFactory;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.adams.De;
import org.mechservice.solver.ode.adams.Ode113;
import org.mechservice.solver.ode.stiff.Ode15s;
import org.mechservice.solver.ode.suite.SuiteProblem;
import org.mechservice.solver.ode.switching.Switching;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;

/** One step of an integration without end; the profiler of JMH says how much memory it takes. */
@State(Scope.Benchmark)
public class StepMemory extends Measured {
  /**
   * More time than any measurement integrates, and not so much that the methods say after a million
   * steps that they will not get there.
   */
  private static final double NEVER = 1e9;

  /** The integrator. */
  @Param({"ODE113", "DE", "ODE15S", "SWITCHING"})
  public String method = "";

  private Integrator integrator = new Ode113(new IntegratorSettings(1e-6, 1e-6));

  /** Begins. */
  @Setup
  public void begin() {
    IntegratorFactory factory =
        switch (method) {
          case "ODE113" -> Ode113::new;
          case "DE" -> De::new;
          case "SWITCHING" -> Switching::new;
          default -> Ode15s::new;
        };
    integrator = factory.create(new IntegratorSettings(1e-6, 1e-6));
    SuiteProblem problem = SuiteProblem.named("VanDerPol");
    integrator.start(problem, 0, problem.reference().initialState(), NEVER);
  }

  /** Takes a step. */
  @Benchmark
  public StepResult step() {
    return integrator.step();
  }
}
