package org.mechservice.sim.scene;

import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import org.mechservice.solver.analysis.equation.FastSpectrum;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.api.run.Stiffness;
import org.mechservice.solver.catalogue.Formulation;
import org.mechservice.solver.closure.ClosedMechanism;
import org.mechservice.solver.closure.assembly.ClosedStart;
import org.mechservice.solver.closure.model.ProjectionModel;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.force.UserForceElement;
import org.mechservice.solver.mechanism.joint.Joint;

/**
 * The fastest motion of a mechanism's equations linearised at the start, or one at least half as
 * fast that is not damped.
 *
 * @param swings whether it oscillates
 * @param modulus |λ|, rad/s
 * @param real Re λ, 1/s
 * @param isDamped whether it decays soon, so that an implicit method need not resolve it, {@link
 *     Stiffness}; a spring whose preload buckles it has λ and −λ, and does not
 * @param joint the joint with the largest velocity in it
 */
public record FastestMotion(
    boolean swings, double modulus, double real, boolean isDamped, Joint joint) {
  /**
   * Largest number of velocities of a scene that is examined: 62 evaluations of larger ones take
   * too long.
   */
  private static final int MOST_VELOCITIES = 1000;

  /**
   * Finds the fastest motion at the start of a run.
   *
   * @param settings settings of the run
   * @param start its closed start, asked for if the mechanism has loops
   * @return empty with user forces, with more than 1000 velocities, and if the equations have no
   *     derivative
   */
  public static Optional<FastestMotion> of(
      Mechanism mechanism, RunSettings settings, Supplier<ClosedStart> start) {
    boolean user = mechanism.forces().stream().anyMatch(UserForceElement.class::isInstance);
    if (user || mechanism.velocityCount() == 0 || mechanism.velocityCount() > MOST_VELOCITIES) {
      return Optional.empty();
    }
    try {
      ExplicitModel model = equations(mechanism, settings, start);
      double[] y = new double[model.description().stateCount()];
      model.initialState(y);
      return new FastSpectrum(model).at(settings.tStart(), y).map(found -> of(mechanism, found));
    } catch (IllegalArgumentException e) {
      // A mechanism that cannot be built is refused, with the reason, when the run starts.
      return Optional.empty();
    }
  }

  /** Returns the motion in words, as a predicate. */
  public String text() {
    return swings
        ? String.format(
            Locale.ROOT,
            "swings with %.3g rad/s, %.1e of critically damped",
            modulus,
            Math.max(0, -real / modulus))
        : String.format(
            Locale.ROOT, "%s with %.3g 1/s", isDamped ? "decays" : "moves away", modulus);
  }

  /**
   * Returns the equations that are linearised: formed from data, loops closed by projection.
   *
   * @param settings settings of the run
   * @param start its closed start, asked for if the mechanism has loops
   * @throws IllegalArgumentException if the mechanism cannot be built
   */
  public static ExplicitModel equations(
      Mechanism mechanism, RunSettings settings, Supplier<ClosedStart> start) {
    return mechanism.closures().isEmpty()
        ? new DataDrivenModel(mechanism, settings)
        : new ProjectionModel(
            new ClosedMechanism(mechanism, Formulation.DSR.label(), settings, start.get()),
            UserForceSource.NONE);
  }

  private static FastestMotion of(Mechanism mechanism, FastSpectrum.Found found) {
    double real = found.real()[found.deciding()];
    double imaginary = found.imaginary()[found.deciding()];
    return new FastestMotion(
        imaginary != 0,
        Math.hypot(real, imaginary),
        real,
        Stiffness.isDamped(real, imaginary),
        jointOf(mechanism, found.shape()));
  }

  /** Returns the joint with the largest velocity. */
  private static Joint jointOf(Mechanism mechanism, double[] shape) {
    int positions = mechanism.positionCount();
    int largest = 0;
    for (int i = 0; i < mechanism.velocityCount(); i++) {
      if (Math.abs(shape[positions + i]) > Math.abs(shape[positions + largest])) {
        largest = i;
      }
    }
    Joint found = mechanism.joints().get(0);
    for (int j = 0; j < mechanism.joints().size(); j++) {
      Joint joint = mechanism.joints().get(j);
      boolean moves = !mechanism.isDriven(j) && joint.type().velocityCount() > 0;
      if (moves && mechanism.velocityOffset(j) <= largest) {
        found = joint;
      }
    }
    return found;
  }
}
