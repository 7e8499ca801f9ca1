package org.mechservice.benchmarks;

import org.mechservice.solver.ode.suite.SuiteProblem;
import org.openjdk.jmh.annotations.AuxCounters;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;

/**
 * Whole runs of small problems, and the right-hand sides alone: what is left per step is the
 * integrator's own work. {@code run:step} is the time of a step with its evaluations.
 */
@State(Scope.Benchmark)
public class StepOverhead extends Measured {
  /** Relative and absolute tolerance of all runs. */
  static final double TOLERANCE = 1e-6;

  /** Name of a problem of the suite. */
  @Param({"VanDerPol", "EulerRigidBody", "Kepler", "Hires"})
  public String problem = "";

  /** The integrator. */
  @Param public ComparedIntegrator method = ComparedIntegrator.ODE113;

  private SuiteProblem equations = SuiteProblem.named("VanDerPol");
  private ComparedIntegrator.ProblemRun run = ComparedIntegrator.ODE113.run(TOLERANCE);

  /** Prepares a run. */
  @Setup
  public void prepare() {
    equations = SuiteProblem.named(problem);
    run = method.run(TOLERANCE);
  }

  /** Integrates from start to end. */
  @Benchmark
  public ComparedIntegrator.Cost run(Work work) {
    ComparedIntegrator.Cost cost = run.toEnd(equations);
    work.step += cost.steps();
    work.evaluation += cost.evaluations();
    return cost;
  }

  /**
   * What the time is shared among: JMH tells that of a step, and of an evaluation with its part.
   */
  @State(Scope.Thread)
  @AuxCounters(AuxCounters.Type.OPERATIONS)
  public static class Work {
    /** Accepted steps. */
    public long step;

    /** Evaluations of the right-hand side. */
    public long evaluation;
  }
}
