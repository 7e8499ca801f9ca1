package org.mechservice.sim.scene.forecast;

import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.scene.FastestMotion;
import org.mechservice.sim.scene.Finding;
import org.mechservice.sim.scene.IntegratorSelection;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.IntegrationMethod;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.catalogue.MethodNames;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.text.ShortestDecimal;

/**
 * Warns before a run if a fast motion will need very many steps. Whether there may be one is told
 * by the rate of the fastest motion of the equations linearised at the start, times the length of
 * the run; how many steps, by the first steps of the run, {@link TrialSteps}.
 */
public final class StiffnessForecast {
  /**
   * Number of steps from which a warning is given; a run of this length takes seconds to minutes.
   */
  private static final double MANY_STEPS = 1e6;

  /**
   * Product of the rate and the length of the run from which the first steps are taken: they are a
   * tenth of so many. Far from equilibrium a preloaded spring may swing many times as fast as
   * linearised.
   */
  private static final double WORTH_A_TRIAL = 2e4;

  /** Largest number of velocities for which the first steps are taken within a second. */
  private static final int MOST_VELOCITIES = 200;

  private StiffnessForecast() {}

  /**
   * Forecasts a run.
   *
   * @param settings settings of the run, with its integrator
   * @return the warning; empty if the run does not need very many steps, if its integrator is
   *     implicit, or if no forecast is possible: with user forces, or if the equations have no
   *     derivative
   */
  public static Optional<Finding> of(MechmlModel model, RunSettings settings) {
    return FastestMotion.of(model.mechanism(), settings, () -> model.closedStart(settings.tStart()))
        .filter(motion -> limits(motion, settings.integrator()))
        .filter(motion -> radians(motion, settings) >= WORTH_A_TRIAL)
        .flatMap(motion -> ofMany(steps(model, motion, settings), motion, settings));
  }

  private static Optional<Finding> ofMany(
      double steps, FastestMotion motion, RunSettings settings) {
    return steps >= MANY_STEPS ? Optional.of(finding(steps, motion, settings)) : Optional.empty();
  }

  /**
   * Returns whether a motion limits the steps of an integrator; every method must resolve an
   * undamped oscillation.
   */
  private static boolean limits(FastestMotion motion, String integrator) {
    return isAdams(integrator) || !motion.isDamped();
  }

  private static boolean isAdams(String integrator) {
    return IntegrationMethod.find(integrator)
        .filter(method -> method.family() == IntegrationMethod.Family.ADAMS)
        .isPresent();
  }

  private static double radians(FastestMotion motion, RunSettings settings) {
    return motion.modulus() * (settings.tEnd() - settings.tStart());
  }

  /** Returns the number of steps; about one per radian, if the first ones cannot be taken. */
  private static double steps(MechmlModel model, FastestMotion motion, RunSettings settings) {
    Mechanism mechanism = model.mechanism();
    if (mechanism.velocityCount() > MOST_VELOCITIES) {
      return radians(motion, settings);
    }
    ExplicitModel equations =
        FastestMotion.equations(mechanism, settings, () -> model.closedStart(settings.tStart()));
    RunSettings explicit = settings.withIntegrator(ofExplicitForm(mechanism, settings));
    double length = settings.tEnd() - settings.tStart();
    OptionalDouble step = TrialSteps.meanStep(equations, explicit);
    return step.isPresent() ? length / step.getAsDouble() : radians(motion, settings);
  }

  /** Returns the integrator for y' = f(t, y); the residual form takes about the same steps. */
  private static String ofExplicitForm(Mechanism mechanism, RunSettings settings) {
    String name =
        IntegrationMethod.find(settings.integrator()).isPresent()
            ? settings.integrator()
            : IntegratorSelection.of(MethodNames.AUTO, mechanism, settings).integrator();
    return IntegrationMethod.of(name).takesResidual() ? IntegrationMethod.ODE15S.label() : name;
  }

  private static Finding finding(double steps, FastestMotion motion, RunSettings settings) {
    String advice =
        motion.isDamped()
            ? "use integrator \"auto\", \"ode15s\" or \"ode15sR\", whose steps such a motion does"
                + " not limit once it has died away"
            : "hardly damped, it has to be followed by every method as long as it is excited: end"
                + " the run earlier, lower the stiffness, make the part rigid, or give it damping,"
                + " with which the steps of an implicit integrator grow once it has died away";
    return new Finding(
        MessageCode.VERY_MANY_STEPS,
        String.format(
            Locale.ROOT,
            "joint \"%s\" moves too fast%s: at the start it %s; to %s s, its end, the run"
                + " will take some %.0e steps; %s",
            motion.joint().name(),
            motion.isDamped() ? " for " + settings.integrator() : "",
            motion.text(),
            ShortestDecimal.format(settings.tEnd()),
            steps,
            advice),
        motion.joint().origin());
  }
}
