package org.mechservice.sim.equations.recursion;

import java.util.List;
import org.mechservice.sim.equations.kinematics.Coordinates;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.step.DegreeOfFreedom;
import org.mechservice.solver.step.Wrench;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * Inward sweep: the joint forces for the inertia wrenches of the bodies and armatures, minus the
 * applied joint forces (recursive Newton-Euler, Featherstone 2008, §5.3).
 */
public final class JointSweep {
  private final Program program;
  private final List<Link> links;
  private final Coordinates coordinates;

  public JointSweep(Program program, Links mechanism, Coordinates coordinates) {
    this.program = program;
    this.links = mechanism.links();
    this.coordinates = coordinates;
  }

  /**
   * Sweeps from the leaves to the root.
   *
   * @param wrenches inertia wrench of each body; overwritten with the sum over all bodies beyond it
   * @param applied applied joint forces
   * @return forces along each link's degrees of freedom, by axis
   */
  public ScalarVector[] sweep(Wrench[] wrenches, JointForces applied) {
    ScalarVector[] borne = new ScalarVector[wrenches.length];
    for (int i = wrenches.length - 1; i >= 0; i--) {
      Link link = links.get(i);
      program.section(
          "Inwards: " + link.title() + ".\ntau = p.z - tau applied, p_p += X p", link.bodyLabel());
      borne[i] = ScalarVector.zero(program.expressions());
      for (DegreeOfFreedom freedom : coordinates.step(link).freedoms()) {
        Scalar force = freedom.along(wrenches[i]).minus(applied.of(i).at(freedom.axis()));
        Scalar byArmature = coordinates.step(link).armatureForce(freedom);
        borne[i] = freedom.replaced(borne[i], force.plus(byArmature));
      }
      program.named("tau_" + link.jointLabel(), borne[i]);
      if (link.parent() != Links.ROOT) {
        int p = link.parent();
        wrenches[p] = wrenches[p].plus(coordinates.step(link).toParent(wrenches[i]));
      }
    }
    return borne;
  }
}
