package org.mechservice.sim.scene;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Formulation;
import org.mechservice.solver.catalogue.IntegrationMethod;
import org.mechservice.solver.catalogue.MethodNames;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.force.Bushing;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.JointForce;
import org.mechservice.solver.mechanism.force.JointSpringDamper;
import org.mechservice.solver.mechanism.force.Side;
import org.mechservice.solver.mechanism.force.SpringDamper;

/**
 * What the integrator {@code auto} means for a scene.
 *
 * <p>As a rule {@code switching}, which finds out along the run. An open chain whose fastest motion
 * dies away many times within the run begins with an implicit method instead, if that motion is one
 * of springs, dampers, bushings and drives that are linear in joint coordinates alone, whose
 * coefficients hold all along: what contacts, friction and other formulas make stiff at the start
 * may be soft later. A larger one takes {@code ode15sR}, which has its derivatives by recursion and
 * solves for half as many unknowns.
 *
 * @param integrator its name
 * @param reason why, in a clause; empty if {@code switching} decides along the run
 */
public record IntegratorSelection(String integrator, Optional<String> reason) {
  private static final String SWITCHING = IntegrationMethod.SWITCHING.label();
  private static final String STIFF = IntegrationMethod.ODE15S.label();
  private static final String RESIDUAL = IntegrationMethod.ODE15SR.label();

  /**
   * Time constants of the fastest motion in a run from which on an implicit method is cheaper from
   * its start: an Adams method takes at least one step for each, and an implicit one some hundred
   * steps in all at the tolerances in use.
   */
  private static final double MANY_TIME_CONSTANTS = 3000;

  /**
   * Velocities from which on the residual form costs less. Measured on chains of stiff hinges: at
   * 10 velocities it takes 1.2 times the processor time of ode15s on DTR, at 20 three quarters, at
   * 40 two thirds.
   */
  private static final int RESIDUAL_VELOCITIES = 16;

  /**
   * Chooses.
   *
   * @param formulation asked for, {@code auto} or a name
   * @param settings of the run: start and end
   */
  public static IntegratorSelection of(
      String formulation, Mechanism mechanism, RunSettings settings) {
    if (Formulation.find(formulation.toUpperCase(Locale.ROOT))
        .filter(Formulation::isResidual)
        .isPresent()) {
      return new IntegratorSelection(RESIDUAL, Optional.empty());
    }
    return lastingStiffness(mechanism, settings)
        .map(motion -> stiff(formulation, mechanism, motion))
        .orElseGet(() -> new IntegratorSelection(SWITCHING, Optional.empty()));
  }

  private static IntegratorSelection stiff(
      String formulation, Mechanism mechanism, FastestMotion motion) {
    boolean residual =
        formulation.equalsIgnoreCase(MethodNames.AUTO)
            && mechanism.velocityCount() >= RESIDUAL_VELOCITIES;
    return new IntegratorSelection(
        residual ? RESIDUAL : STIFF,
        Optional.of("joint \"" + motion.joint().name() + "\" " + motion.text()));
  }

  /** Returns the fastest motion, if it is damped, many times shorter than the run, and stays so. */
  private static Optional<FastestMotion> lastingStiffness(
      Mechanism mechanism, RunSettings settings) {
    List<ForceElement> lasting =
        mechanism.forces().stream().filter(IntegratorSelection::holdsAllAlong).toList();
    if (!mechanism.closures().isEmpty() || lasting.isEmpty()) {
      return Optional.empty();
    }
    double length = settings.tEnd() - settings.tStart();
    return FastestMotion.of(withForces(mechanism, lasting), settings)
        .filter(FastestMotion::isDamped)
        .filter(motion -> motion.modulus() * length >= MANY_TIME_CONSTANTS);
  }

  private static boolean holdsAllAlong(ForceElement force) {
    return force instanceof Bushing
        || (force instanceof SpringDamper spring && spring.side() == Side.BOTH)
        || (force instanceof JointSpringDamper spring && spring.side() == Side.BOTH)
        || (force instanceof JointForce drive && Linearity.of(drive.force()) == Linearity.LINEAR);
  }

  private static Mechanism withForces(Mechanism mechanism, List<ForceElement> forces) {
    return new Mechanism(
        mechanism.name(),
        mechanism.root(),
        mechanism.gravity(),
        mechanism.bodies(),
        mechanism.joints(),
        mechanism.motions(),
        mechanism.startRoles(),
        mechanism.closures(),
        forces,
        mechanism.parameters());
  }
}
