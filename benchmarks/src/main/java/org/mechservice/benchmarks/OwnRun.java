package org.mechservice.benchmarks;

import org.mechservice.solver.ode.IntegrationStatistics;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.suite.SuiteProblem;
import org.mechservice.solver.ode.suite.VerifiedValues;

/** Runs of one of our integrators. */
record OwnRun(Integrator integrator) implements ComparedIntegrator.ProblemRun {
  @Override
  public ComparedIntegrator.Cost toEnd(SuiteProblem problem) {
    VerifiedValues reference = problem.reference();
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
