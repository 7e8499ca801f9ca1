package org.mechservice.sim.scene.forecast;

import java.util.Locale;
import java.util.Optional;
import org.mechservice.sim.scene.Finding;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.joint.Joint;

/**
 * Warns before a run if a body rotates so fast in a spherical or free joint at the start that its
 * Euler parameters, which oscillate with half the angular velocity, need very many steps.
 */
final class SpinForecast {
  /** Number of radians within a run that causes a warning, as in {@link StiffnessForecast}. */
  private static final double MANY = 1e6;

  private SpinForecast() {}

  /** Returns the warning about the first such joint. */
  static Optional<Finding> of(Mechanism mechanism, RunSettings settings) {
    double[] y = new double[mechanism.positionCount() + mechanism.velocityCount()];
    mechanism.initialState(y);
    for (int j = 0; j < mechanism.joints().size(); j++) {
      Joint joint = mechanism.joints().get(j);
      if (joint.type().hasEulerParameters() && !mechanism.isDriven(j)) {
        double spin =
            spin(joint.type(), y, mechanism.positionCount() + mechanism.velocityOffset(j));
        double length = settings.tEnd() - settings.tStart();
        if (0.5 * spin * length >= MANY) {
          return Optional.of(finding(joint, spin, length));
        }
      }
    }
    return Optional.empty();
  }

  private static double spin(JointType type, double[] y, int at) {
    double square = 0;
    for (int i = 0; i < type.velocityCount(); i++) {
      square += type.velocityUnit(i).startsWith("rad") ? y[at + i] * y[at + i] : 0;
    }
    return Math.sqrt(square);
  }

  private static Finding finding(Joint joint, double spin, double length) {
    return new Finding(
        MessageCode.VERY_MANY_STEPS,
        String.format(
            Locale.ROOT,
            "joint \"%s\" spins with %.3g rad/s at the start; a run of %.3g s needs some %.0e steps"
                + " to follow its orientation, whatever the integrator; end the run earlier, or"
                + " let it turn about a joint of type R, whose angle grows evenly",
            joint.name(),
            spin,
            length,
            0.5 * spin * length),
        joint.origin());
  }
}
