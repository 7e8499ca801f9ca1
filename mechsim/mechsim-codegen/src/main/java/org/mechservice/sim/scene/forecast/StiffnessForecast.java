package org.mechservice.sim.scene.forecast;

import java.util.Locale;
import java.util.Optional;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.scene.FastestMotion;
import org.mechservice.sim.scene.Finding;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.IntegrationMethod;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.text.ShortestDecimal;

/**
 * Warns before a run if an explicit integrator will need very many steps; their number is the rate
 * of the fastest motion of the equations linearised at the start, times the length of the run.
 */
public final class StiffnessForecast {
  /**
   * Number of steps from which a warning is given; a run of this length takes seconds to minutes.
   */
  private static final double MANY_STEPS = 1e6;

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
        .filter(motion -> steps(motion, settings) >= MANY_STEPS)
        .map(motion -> finding(motion, settings));
  }

  /** Returns whether the forecast is the same for two integrators. */
  static boolean isSame(String integrator, String other) {
    return integrator.equals(other) || !(isAdams(integrator) || isAdams(other));
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

  private static double steps(FastestMotion motion, RunSettings settings) {
    return motion.modulus() * (settings.tEnd() - settings.tStart());
  }

  private static Finding finding(FastestMotion motion, RunSettings settings) {
    String advice =
        motion.isDamped()
            ? "use integrator \"auto\", \"ode15s\" or \"ode15sR\", whose steps such a motion does"
                + " not limit once it has died away"
            : "hardly damped, it has to be followed by every method as long as it is excited: end"
                + " the run earlier, lower the stiffness, make the part rigid, or give it damping"
                + " and use integrator \"auto\"";
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
            steps(motion, settings),
            advice),
        motion.joint().origin());
  }
}
