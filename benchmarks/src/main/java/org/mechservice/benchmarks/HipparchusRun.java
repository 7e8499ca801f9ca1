package org.mechservice.benchmarks;

import org.hipparchus.ode.ODEIntegrator;
import org.hipparchus.ode.ODEState;
import org.hipparchus.ode.OrdinaryDifferentialEquation;
import org.hipparchus.ode.sampling.ODEStateInterpolator;
import org.hipparchus.ode.sampling.ODEStepHandler;
import org.mechservice.solver.ode.suite.SuiteProblem;
import org.mechservice.solver.ode.suite.VerifiedValues;

/** Runs of an integrator of Hipparchus. */
final class HipparchusRun implements ComparedIntegrator.ProblemRun {
  private final ODEIntegrator integrator;
  private final StepCount count = new StepCount();

  HipparchusRun(ODEIntegrator integrator) {
    this.integrator = integrator;
    integrator.addStepHandler(count);
  }

  @Override
  public ComparedIntegrator.Cost toEnd(SuiteProblem problem) {
    VerifiedValues reference = problem.reference();
    count.steps = 0;
    integrator.integrate(
        new Equations(problem), new ODEState(0, reference.initialState()), reference.end());
    return new ComparedIntegrator.Cost(count.steps, integrator.getEvaluations());
  }

  private static final class StepCount implements ODEStepHandler {
    private long steps;

    @Override
    public void handleStep(ODEStateInterpolator interpolator) {
      steps++;
    }
  }

  private record Equations(SuiteProblem problem) implements OrdinaryDifferentialEquation {
    @Override
    public int getDimension() {
      return problem.dimension();
    }

    @Override
    public double[] computeDerivatives(double t, double[] y) {
      double[] yDot = new double[y.length];
      problem.derivative(t, y, yDot);
      return yDot;
    }
  }
}
