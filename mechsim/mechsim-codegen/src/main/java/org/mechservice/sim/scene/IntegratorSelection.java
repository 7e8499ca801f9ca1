package org.mechservice.sim.scene;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Formulation;
import org.mechservice.solver.catalogue.IntegrationMethod;
import org.mechservice.solver.catalogue.MethodNames;
import org.mechservice.solver.closure.assembly.ClosedStart;
import org.mechservice.solver.force.law.Side;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.force.Bushing;
import org.mechservice.solver.mechanism.force.CouplingSpringDamper;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.JointForce;
import org.mechservice.solver.mechanism.force.JointSpringDamper;
import org.mechservice.solver.mechanism.force.SpringDamper;

/**
 * The choice of the integrator {@code auto} for a scene.
 *
 * <p>The usual choice is {@code switching}, which decides during the run. An open chain gets an
 * implicit method instead if its fastest motion decays many times within the run and its forces are
 * linear: springs, dampers, bushings and drives that are linear in joint coordinates have constant
 * coefficients, whereas stiffness at the start from contacts, friction and other formulas may
 * vanish later. For a larger chain the residual form with {@code ode15sR}, which has derivatives by
 * recursion and solves for half as many unknowns, and {@code ode15s} are tried, {@link
 * MethodTrial}; so are they where nothing damps the fastest motion, which may be too small to be
 * followed.
 *
 * @param integrator its name
 * @param reason the reason as a clause; empty if {@code switching} decides during the run
 */
public record IntegratorSelection(String integrator, Optional<String> reason) {
  private static final String SWITCHING = IntegrationMethod.SWITCHING.label();
  private static final String STIFF = IntegrationMethod.ODE15S.label();
  private static final String RESIDUAL = IntegrationMethod.ODE15SR.label();

  /**
   * Number of time constants of the fastest motion in a run above which an implicit method is
   * cheaper: an Adams method takes at least one step per time constant, and an implicit one about a
   * hundred steps in all at usual tolerances.
   */
  private static final double MANY_TIME_CONSTANTS = 3000;

  /**
   * Number of velocities from which the residual form is cheaper. Measured on chains of stiff
   * hinges: at 10 velocities it takes 1.2 times the processor time of ode15s on DTR, at 20 three
   * quarters, at 40 two thirds.
   */
  private static final int RESIDUAL_VELOCITIES = 16;

  /**
   * Chooses.
   *
   * @param formulation requested formulation, {@code auto} or a name
   * @param settings settings of the run: start and end
   */
  public static IntegratorSelection of(
      String formulation, Mechanism mechanism, RunSettings settings) {
    if (Formulation.find(formulation.toUpperCase(Locale.ROOT))
        .filter(Formulation::isResidual)
        .isPresent()) {
      return new IntegratorSelection(RESIDUAL, Optional.empty());
    }
    Optional<FastestMotion> lasting = lastingMotion(mechanism, settings);
    return lasting
        .filter(FastestMotion::isDamped)
        .map(motion -> stiff(formulation, mechanism, settings, motion))
        .or(
            () ->
                lasting
                    .filter(motion -> formulation.equalsIgnoreCase(MethodNames.AUTO))
                    .flatMap(motion -> hardlyExcited(mechanism, settings, motion)))
        .orElseGet(() -> new IntegratorSelection(SWITCHING, Optional.empty()));
  }

  /**
   * Chooses an implicit method for a fast motion without damping if the whole run takes it no more
   * than the steps of a trial: a spring that swings below the tolerance need not be followed, but
   * limits the steps of an Adams method.
   */
  private static Optional<IntegratorSelection> hardlyExcited(
      Mechanism mechanism, RunSettings settings, FastestMotion motion) {
    MethodTrial implicit =
        MethodTrial.of(mechanism, Formulation.RR_JF, IntegrationMethod.ODE15SR, settings);
    if (!implicit.isWhole()) {
      return Optional.empty();
    }
    MethodTrial explicit =
        implicit.against(mechanism, Formulation.DTR, IntegrationMethod.ODE113, settings);
    String why = "joint \"" + motion.joint().name() + "\" " + motion.text();
    return MethodTrial.better(explicit, implicit).equals(implicit)
        ? Optional.of(
            new IntegratorSelection(RESIDUAL, MethodTrial.reason(why, implicit, explicit)))
        : Optional.empty();
  }

  private static IntegratorSelection stiff(
      String formulation, Mechanism mechanism, RunSettings settings, FastestMotion motion) {
    String why = "joint \"" + motion.joint().name() + "\" " + motion.text();
    if (!formulation.equalsIgnoreCase(MethodNames.AUTO)
        || mechanism.velocityCount() < RESIDUAL_VELOCITIES) {
      return new IntegratorSelection(STIFF, Optional.of(why));
    }
    MethodTrial residual =
        MethodTrial.of(mechanism, Formulation.RR_JF, IntegrationMethod.ODE15SR, settings);
    MethodTrial articulated =
        residual.against(mechanism, Formulation.DTR, IntegrationMethod.ODE15S, settings);
    return new IntegratorSelection(
        MethodTrial.better(residual, articulated).integrator(),
        MethodTrial.reason(why, residual, articulated));
  }

  /**
   * Returns the fastest motion if it is much shorter than the run and has constant coefficients.
   */
  private static Optional<FastestMotion> lastingMotion(Mechanism mechanism, RunSettings settings) {
    List<ForceElement> lasting =
        mechanism.forces().stream().filter(IntegratorSelection::holdsAllAlong).toList();
    if (!mechanism.closures().isEmpty() || lasting.isEmpty()) {
      return Optional.empty();
    }
    double length = settings.tEnd() - settings.tStart();
    Mechanism forced = withForces(mechanism, lasting);
    return FastestMotion.of(forced, settings, () -> new ClosedStart(forced, settings.tStart()))
        .filter(motion -> motion.modulus() * length >= MANY_TIME_CONSTANTS);
  }

  private static boolean holdsAllAlong(ForceElement force) {
    return force instanceof Bushing
        || (force instanceof SpringDamper spring && spring.side() == Side.BOTH)
        || (force instanceof JointSpringDamper spring && spring.side() == Side.BOTH)
        || (force instanceof CouplingSpringDamper spring
            && spring.side() == Side.BOTH
            && Linearity.of(spring.along()) == Linearity.LINEAR)
        || (force instanceof JointForce drive && Linearity.of(drive.force()) == Linearity.LINEAR);
  }

  private static Mechanism withForces(Mechanism mechanism, List<ForceElement> forces) {
    Mechanism other =
        new Mechanism(
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
    return other.withFurtherStates(mechanism.furtherStates()).withArmatures(mechanism.armatures());
  }
}
