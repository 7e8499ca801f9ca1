package org.mechservice.solver.ode.solve;

import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.OdeSystem;
import org.mechservice.solver.ode.ResidualIntegrator;
import org.mechservice.solver.ode.ResidualSystem;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.step.WatchedIntegrator;

/** A problem in the form that the chosen method takes. */
sealed interface PosedProblem {
  int dimension();

  /** Returns an integrator that takes the form. */
  WatchedIntegrator integrator(IntegratorSettings settings);

  /** Begins the problem with that integrator, or with one that looks for events in its steps. */
  StepResult start(Integrator integrator, double t0, double[] y0, double t1);

  StepResult resume(Integrator integrator, byte[] saved);

  /** Returns where the solution is close ahead, to second order if the problem is explicit. */
  double[] solutionAhead(double t0, double[] y0, double ahead);

  /** y' = f(t, y). */
  record Explicit(OdeSystem system, OdeMethod method) implements PosedProblem {
    @Override
    public int dimension() {
      return system.dimension();
    }

    @Override
    public WatchedIntegrator integrator(IntegratorSettings settings) {
      return method.integrator(settings);
    }

    @Override
    public StepResult start(Integrator integrator, double t0, double[] y0, double t1) {
      return integrator.start(system, t0, y0, t1);
    }

    @Override
    public StepResult resume(Integrator integrator, byte[] saved) {
      return integrator.resume(system, saved);
    }

    /** Heun's formula. */
    @Override
    public double[] solutionAhead(double t0, double[] y0, double ahead) {
      int n = y0.length;
      double h = ahead - t0;
      double[] first = new double[n];
      double[] second = new double[n];
      double[] y = new double[n];
      system.derivative(t0, y0.clone(), first);
      for (int i = 0; i < n; i++) {
        y[i] = y0[i] + h * first[i];
      }
      system.derivative(ahead, y, second);
      for (int i = 0; i < n; i++) {
        y[i] = y0[i] + 0.5 * h * (first[i] + second[i]);
      }
      return y;
    }
  }

  /**
   * F(t, y, y') = 0.
   *
   * @param slope y' at the start
   */
  @SuppressWarnings("ArrayRecordComponent") // compared by nobody
  record Residual(ResidualSystem system, double[] slope, OdeMethod method) implements PosedProblem {
    @Override
    public int dimension() {
      return system.dimension();
    }

    @Override
    public WatchedIntegrator integrator(IntegratorSettings settings) {
      return method.residualIntegrator(settings);
    }

    @Override
    public StepResult start(Integrator integrator, double t0, double[] y0, double t1) {
      return ((ResidualIntegrator) integrator).start(system, t0, y0, slope, t1);
    }

    @Override
    public StepResult resume(Integrator integrator, byte[] saved) {
      return ((ResidualIntegrator) integrator).resume(system, saved);
    }

    /** Along the slope that was given. */
    @Override
    public double[] solutionAhead(double t0, double[] y0, double ahead) {
      double[] y = y0.clone();
      for (int i = 0; i < y.length; i++) {
        y[i] += (ahead - t0) * slope[i];
      }
      return y;
    }
  }
}
