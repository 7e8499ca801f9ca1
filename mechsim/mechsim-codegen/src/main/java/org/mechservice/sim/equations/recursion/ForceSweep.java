package org.mechservice.sim.equations.recursion;

import org.mechservice.sim.equations.kinematics.Coordinates;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.step.LinkStep;
import org.mechservice.solver.step.Motion;
import org.mechservice.solver.step.Wrench;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.ScalarMatrix;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * First sweep, outwards: the motion of each body and its inertia wrench, with zero or given joint
 * accelerations (recursive Newton-Euler, Featherstone 2008, §5.3).
 *
 * <p>Accelerations are those of points of the bodies, so no linear velocity occurs; W is formed
 * once per body and used for its centre of mass and all its joints.
 */
public final class ForceSweep {
  private final Program program;
  private final Expressions expressions;
  private final Links mechanism;
  private final Coordinates coordinates;
  private final Motion[] motions;
  private final ScalarMatrix[] spreads;
  private final Motion root;

  public ForceSweep(Program program, Links mechanism, Coordinates coordinates) {
    this.program = program;
    this.expressions = program.expressions();
    this.mechanism = mechanism;
    this.coordinates = coordinates;
    this.motions = new Motion[mechanism.links().size()];
    this.spreads = new ScalarMatrix[mechanism.links().size()];
    ScalarVector none = ScalarVector.zero(expressions);
    // An acceleration of the root opposite to gravity represents gravity on every body.
    this.root = new Motion(none, none, ScalarVector.of(expressions, mechanism.gravity().negated()));
  }

  /** Returns the inertia wrench of each link's body, about its computing origin. */
  public Wrench[] sweep() {
    Wrench[] needed = new Wrench[motions.length];
    for (int i = 0; i < motions.length; i++) {
      Link link = mechanism.links().get(i);
      program.section(title(link), link.bodyLabel());
      motions[i] = moved(link);
      String label = link.bodyLabel();
      program.named("omega_" + label, motions[i].omega());
      program.named("alpha_" + label, motions[i].alpha());
      program.named("a_" + label, motions[i].acceleration());
      spreads[i] = program.named("W_" + label, motions[i].spread());
      needed[i] = needed(link, motions[i], spreads[i]);
    }
    return needed;
  }

  /** Returns the motion of a link after the sweep, with gravity as an acceleration of the root. */
  public Motion motion(int link) {
    return link == Links.ROOT ? root : motions[link];
  }

  private static String title(Link link) {
    return "Sweep 1, outwards: "
        + link.title()
        + ".\n"
        + equation(link)
        + (link.mass() == 0 ? "" : ", f = m (a + W c), n = I alpha + omega x I omega + c x f");
  }

  private static String equation(Link link) {
    return switch (link.kind()) {
      case TURN ->
          "omega = R' omega_p + v z, alpha = R' alpha_p + v omega x z, a = R' (a_p + W_p r)";
      case SLIDE ->
          "omega = R' omega_p, alpha = R' alpha_p, a = R' (a_p + W_p r) + q W z + 2 v omega x z";
      case SCREW ->
          "omega = R' omega_p + v z, alpha = R' alpha_p + v omega x z,"
              + " a = R' (a_p + W_p (r + h q z) + 2 h v omega_p x z)";
      default ->
          link.inverse()
              ? "omega = R' omega_p - v, alpha = R' (alpha_p) - R' omega_p x v, a = R' (a_p + W_p"
                  + " r)"
              : "omega = R' (omega_p + v), alpha = R' (alpha_p + omega_p x v), a = R' (a_p + W_p"
                  + " r)";
    };
  }

  private Motion moved(Link link) {
    boolean onRoot = link.parent() == Links.ROOT;
    return coordinates
        .step(link)
        .motion(motion(link.parent()), onRoot ? root.spread() : spreads[link.parent()]);
  }

  private Wrench needed(Link link, Motion motion, ScalarMatrix spread) {
    LinkStep step = coordinates.step(link);
    ScalarVector force = program.named("f_" + link.bodyLabel(), step.inertiaForce(motion, spread));
    ScalarVector moment = step.inertiaMoment(motion, spread, force);
    return new Wrench(program.named("n_" + link.bodyLabel(), moment), force);
  }
}
