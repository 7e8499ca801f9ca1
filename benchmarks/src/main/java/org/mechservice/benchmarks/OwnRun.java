package org.mechservice.benchmarks;

import org.mechservice.solver.ode.IntegrationStatistics;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.suite.Reference;
import org.mechservice.solver.ode.suite.SuiteProblem;

/** Runs of one of our integrators. */
record OwnRun(Integrator integrator) implements ComparedIntegrator.ProblemRun {
  @Override
  public ComparedIntegrator.Cost toEnd(SuiteProblem problem) {
    Reference reference = problem.reference();
    StepResult result = integrator.start(problem, 0, reference.initialState(), reference.end());
    while (result == StepResult.ADVANCED) {
      result = integrator.step();
    }
    if (result != StepResult.REACHED_END) {
      throw new IllegalStateException(problem.name() + ": " + integrator.failure());
    }
    IntegrationStatistics done = integrator.statistics();
    return new ComparedIntegrator.Cost(done.steps(), done.evaluations());
  }
}
