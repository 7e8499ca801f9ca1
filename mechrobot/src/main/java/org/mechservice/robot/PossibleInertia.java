package org.mechservice.robot;

import java.util.Arrays;
import java.util.List;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.robot.Robot.Inertial;
import org.mechservice.robot.Robot.Link;

/**
 * Inertias that a body can have in place of those that none can: tensors with a negative principal
 * moment, as conversions leave them in public files. The engines of URDF and SDF compute with them
 * as they are, until the mass matrix is singular somewhere.
 */
final class PossibleInertia {
  /** Part of the largest moment that rounding of a file's digits may make negative. */
  private static final double ROUNDING = 1e-6;

  private PossibleInertia() {}

  /** Returns a robot with zero in place of negative principal moments, each of which is a loss. */
  static Robot of(Robot robot, ImportLosses losses) {
    List<Link> links =
        robot.links().stream()
            .map(link -> link.with(link.inertial().map(inertial -> of(inertial, losses))))
            .toList();
    return robot.with(links, robot.joints());
  }

  private static Inertial of(Inertial inertial, ImportLosses losses) {
    PrincipalAxes axes = PrincipalAxes.of(inertial.moments());
    double[] moments = axes.moments();
    double least = Arrays.stream(moments).min().orElse(0);
    double most = Arrays.stream(moments).map(Math::abs).max().orElse(0);
    if (!(least < -ROUNDING * most)) {
      return inertial;
    }
    losses.motion(
        inertial.element(),
        Phrase.of(
            "the principal moments, in kg*m^2, are %.6g, %.6g and %.6g, and those of a body are"
                + " not negative: 0 takes the place of negative ones",
            moments[0], moments[1], moments[2]));
    return new Inertial(
        inertial.element(),
        inertial.frame(),
        inertial.mass(),
        axes.tensor(Arrays.stream(moments).map(m -> Math.max(m, 0)).toArray()));
  }
}
