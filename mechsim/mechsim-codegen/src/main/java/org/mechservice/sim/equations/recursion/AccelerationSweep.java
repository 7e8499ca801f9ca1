package org.mechservice.sim.equations.recursion;

import java.util.List;
import org.mechservice.sim.equations.kinematics.Coordinates;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.step.DegreeOfFreedom;
import org.mechservice.solver.step.LinkStep;
import org.mechservice.solver.step.LinkStep.Added;
import org.mechservice.solver.step.Wrench;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * Third sweep, outwards: joint accelerations q'' = u / D − (U / D) · A, with A the acceleration
 * that the joint accelerations nearer the root add to the motion of the first sweep (Featherstone
 * 2008, §7.2).
 */
public final class AccelerationSweep {
  private final Program program;
  private final Expressions expressions;
  private final List<Link> links;
  private final Coordinates coordinates;
  private final InertiaSweep inertias;
  private final Added[] added;
  private final CarriedEquations carried;
  private final int shift;
  private final boolean putOut;

  /** Outputs joint accelerations at the places of the velocities in [q; v], if requested. */
  public AccelerationSweep(
      Program program,
      Links mechanism,
      Coordinates coordinates,
      InertiaSweep inertias,
      boolean putOut) {
    this(program, mechanism, coordinates, inertias, CarriedEquations.NONE, 0, putOut);
  }

  /**
   * @param carried equations with multipliers
   * @param shift what is added to the index of a velocity in [q; v] to give that of its output
   * @param putOut whether joint accelerations are outputs
   */
  public AccelerationSweep(
      Program program,
      Links mechanism,
      Coordinates coordinates,
      InertiaSweep inertias,
      CarriedEquations carried,
      int shift,
      boolean putOut) {
    this.carried = carried;
    this.shift = shift;
    this.program = program;
    this.expressions = program.expressions();
    this.links = mechanism.links();
    this.coordinates = coordinates;
    this.inertias = inertias;
    this.added = new Added[links.size()];
    this.putOut = putOut;
  }

  /** Returns the angular acceleration that joint accelerations add to a link. */
  public ScalarVector alpha(int link) {
    return added[link].alpha();
  }

  /** Returns the acceleration that joint accelerations add to a link's origin. */
  public ScalarVector acceleration(int link) {
    return added[link].acceleration();
  }

  /** Sweeps from the root to the leaves and outputs the joint accelerations, if requested. */
  public void sweep() {
    for (int i = 0; i < added.length; i++) {
      Link link = links.get(i);
      program.section(
          "Sweep 3, outwards: " + link.title() + ".\nq'' = u / D - k.A, A = X' A_p + q'' z",
          link.bodyLabel());
      added[i] = coordinates.step(link).fromParent(ofParent(link));
      if (!link.isDriven()) {
        accelerate(i, link);
      }
      program.named("dalpha_" + link.bodyLabel(), added[i].alpha());
      program.named("da_" + link.bodyLabel(), added[i].acceleration());
      carried.moved(i, added[i].alpha(), added[i].acceleration());
    }
  }

  private void accelerate(int i, Link link) {
    List<DegreeOfFreedom> freedoms = coordinates.step(link).freedoms();
    Scalar[] rates = new Scalar[freedoms.size()];
    // degrees of freedom are solved for in reverse order of elimination
    for (int k = rates.length - 1; k >= 0; k--) {
      Wrench share = inertias.shares(i).get(k);
      rates[k] = carried.push(i, k, LinkStep.rate(inertias.atRest(i).get(k), share, added[i]));
      if (rates.length == 1) {
        program.named("qdd_" + link.jointLabel(), rates[k]);
      }
      added[i] = LinkStep.after(freedoms.get(k), added[i], rates[k]);
    }
    if (!putOut) {
      return;
    }
    if (link.isBall()) {
      putOutBall(link, new ScalarVector(rates[0], rates[1], rates[2]));
    } else {
      program.output(link.velocity() + shift, rates[0]);
    }
  }

  /** Outputs angular accelerations in link axes, converted to the axes of the file's body 1. */
  private void putOutBall(Link link, ScalarVector rates) {
    ScalarVector out = coordinates.ballToState(link, rates);
    program.named("vd_" + link.jointLabel(), out);
    for (int k = 0; k < 3; k++) {
      program.output(link.velocity() + shift + k, out.at(k));
    }
  }

  private Added ofParent(Link link) {
    ScalarVector none = ScalarVector.zero(expressions);
    return link.parent() == Links.ROOT ? new Added(none, none) : added[link.parent()];
  }
}
