package org.mechservice.solver.closure;

import java.util.List;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.closure.JumpingLoops.Law;
import org.mechservice.solver.closure.JumpingLoops.Side;
import org.mechservice.solver.closure.model.ProjectionModel;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.OdeSystem;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.adams.Ode113;
import org.mechservice.solver.simulation.RuntimeSolver;

/** The motion of a loop from any of its states, far more accurate than a run to be judged. */
interface ExactMotion {
  /**
   * Returns the state reached.
   *
   * @param start time
   * @param state coordinates and velocities then; not modified
   * @param end time
   */
  double[] after(double start, double[] state, double end);

  /** Returns the motion of a scene. */
  static ExactMotion of(JumpingLoops scene) {
    RunSettings sharp = new RunSettings(0, scene.end(), scene.end(), "ode113", 1e-12, 1e-13);
    return scene.law() == Law.STAIRS || scene.law() == Law.STOP
        ? new BySmallSteps((ProjectionModel) LoopModels.of(scene.mechanism(Side.OWN), "DSR", sharp))
        : new SlidingReference(scene, sharp);
  }

  /** Across many jumps, each of which the integrator narrows down. */
  final class BySmallSteps implements ExactMotion {
    private static final double LONGEST = 0.005;

    private final ProjectionModel model;
    private final OdeSystem equations;
    private final Ode113 integrator =
        new Ode113(
            new IntegratorSettings(
                1e-12, List.of(1e-13), LONGEST, 0, 0, Long.MAX_VALUE, () -> false));

    private BySmallSteps(ProjectionModel model) {
      this.model = model;
      equations = (OdeSystem) RuntimeSolver.formOf(model, "ode113").of(model);
    }

    @Override
    public double[] after(double start, double[] state, double end) {
      double[] y = state.clone();
      require(model.complete(start, y));
      StepResult result = integrator.start(equations, start, y, end);
      while (result == StepResult.ADVANCED) {
        result = integrator.step();
      }
      require(result == StepResult.REACHED_END);
      integrator.interpolate(end, y, new double[y.length]);
      require(model.complete(end, y));
      return y;
    }

    private static void require(boolean done) {
      if (!done) {
        throw new IllegalStateException("the motion does not go on");
      }
    }
  }
}
