package org.mechservice.sim.equations.recursion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.mechservice.sim.equations.kinematics.Coordinates;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.step.ArticulatedInertia;
import org.mechservice.solver.step.DegreeOfFreedom;
import org.mechservice.solver.step.LinkStep;
import org.mechservice.solver.step.LinkStep.Elimination;
import org.mechservice.solver.step.Wrench;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarMatrix;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * Second sweep, inwards: articulated inertias and bias wrenches (Featherstone 2008, §7.2, with the
 * residual wrenches of the first sweep as bias forces).
 *
 * <p>With U the column of the articulated inertia along the joint's axis, D its element on the axis
 * plus the armature, and u the joint force less the wrench along the axis, I − U Uᵀ / D and p + U u
 * / D are added to the parent.
 */
public final class InertiaSweep {
  private final Program program;
  private final Expressions expressions;
  private final List<Link> links;
  private final JointForces jointForces;
  private final Coordinates coordinates;
  private final Pivots pivots;
  private final CarriedEquations carried;
  private final ArticulatedInertia[] inertias;
  private final Wrench[] wrenches;
  private final List<List<Wrench>> shares = new ArrayList<>();
  private final List<List<Scalar>> atRest = new ArrayList<>();

  /**
   * @param wrenches inertia wrench of each body; overwritten with the sum over all bodies beyond it
   * @param jointForces applied joint forces
   * @param carried equations with multipliers
   * @param checked whether the program checks pivots
   */
  public InertiaSweep(
      Program program,
      Links mechanism,
      Coordinates coordinates,
      Wrench[] wrenches,
      JointForces jointForces,
      CarriedEquations carried,
      boolean checked) {
    this.program = program;
    this.expressions = program.expressions();
    this.links = mechanism.links();
    this.jointForces = jointForces;
    this.coordinates = coordinates;
    this.pivots = new Pivots(program, links, coordinates, checked);
    this.inertias = new ArticulatedInertia[links.size()];
    this.wrenches = wrenches;
    this.carried = carried;
    for (int i = 0; i < links.size(); i++) {
      shares.add(new ArrayList<>());
      atRest.add(new ArrayList<>());
    }
  }

  /**
   * Sweeps from the leaves to the root.
   *
   * @return whether every joint can have an inertia; if not, the program ends with a guard that
   *     always holds
   */
  public boolean sweep() {
    ScalarMatrix none = ScalarMatrix.zero(expressions);
    Arrays.fill(inertias, new ArticulatedInertia(none, none, none));
    for (int i = links.size() - 1; i >= 0; i--) {
      if (!inwards(i, links.get(i))) {
        return false;
      }
    }
    return true;
  }

  /**
   * Adds what an eliminated equation leaves in a link: I + k kᵀ / Λ, p + k r / Λ.
   *
   * @param k wrench of its multiplier
   * @param reciprocal 1 / Λ
   * @param right r, its right side
   */
  public void add(int link, Wrench k, Scalar reciprocal, Scalar right) {
    Wrench share = new Wrench(k.moment().times(reciprocal), k.force().times(reciprocal));
    inertias[link] = inertias[link].plusProduct(k, share);
    wrenches[link] =
        wrenches[link].plus(new Wrench(share.moment().times(right), share.force().times(right)));
  }

  /** Returns U / D of each degree of freedom of a link; the element of a plain one is 1. */
  List<Wrench> shares(int link) {
    return shares.get(link);
  }

  /**
   * Returns u / D of each degree of freedom of a link: its acceleration for a parent without
   * acceleration.
   */
  List<Scalar> atRest(int link) {
    return atRest.get(link);
  }

  /**
   * Returns the articulated inertia of a link and all links beyond it, with its own joint locked.
   */
  public ArticulatedInertia inertia(int link) {
    return inertias[link];
  }

  /** Returns the bias wrench of a link and all links beyond it. */
  public Wrench wrench(int link) {
    return wrenches[link];
  }

  private boolean inwards(int i, Link link) {
    program.section("Sweep 2, inwards: " + link.title() + ".\n" + equation(link), link.bodyLabel());
    inertias[i] = coordinates.step(link).inertia().plus(inertias[i]);
    named(link, inertias[i]);
    carried.enter(i, this);
    if (!link.isDriven()) {
      List<DegreeOfFreedom> freedoms = coordinates.step(link).freedoms();
      ScalarVector forces = jointForces.of(i);
      for (int k = 0; k < freedoms.size(); k++) {
        DegreeOfFreedom freedom = freedoms.get(k);
        boolean passedOn = link.parent() != Links.ROOT || k + 1 < freedoms.size();
        if (!eliminate(i, link, freedom, forces.at(freedom.axis()), passedOn)) {
          return false;
        }
      }
    }
    if (link.parent() != Links.ROOT) {
      pass(link, inertias[i], wrenches[i]);
      carried.pass(i, link);
    }
    return true;
  }

  private static String equation(Link link) {
    return link.isDriven()
        ? "I_p += X I X', p_p += X p"
        : "k = U / D, u = tau - p.z, I_p += X (I - U k') X', p_p += X (p + k u)";
  }

  /** Eliminates a degree of freedom; returns whether it can have an inertia. */
  private boolean eliminate(
      int i, Link link, DegreeOfFreedom freedom, Scalar force, boolean passedOn) {
    String label = link.jointLabel() + (link.isBall() ? "_" + "xyz".charAt(freedom.axis()) : "");
    Elimination of =
        coordinates.step(link).eliminate(freedom, inertias[i], wrenches[i], force, passedOn);
    program.named("D_" + label, of.pivot());
    if (pivots.guarded(i, freedom, of.pivot())) {
      return false;
    }
    program.named("one_over_D_" + label, of.reciprocal());
    program.named("kn_" + label, of.share().moment());
    program.named("kf_" + label, of.share().force());
    program.named("u_over_D_" + label, of.rate());
    shares.get(i).add(of.share());
    atRest.get(i).add(of.rate());
    carried.eliminate(i, freedom, of);
    wrenches[i] = of.wrench();
    inertias[i] = of.inertia();
    return true;
  }

  private void named(Link link, ArticulatedInertia inertia) {
    program.named("J_" + link.bodyLabel(), inertia.rotational());
    program.named("H_" + link.bodyLabel(), inertia.coupling());
    program.named("M_" + link.bodyLabel(), inertia.translational());
  }

  /** Adds the inertia and wrench of a link to its parent. */
  private void pass(Link link, ArticulatedInertia inertia, Wrench wrench) {
    int p = link.parent();
    LinkStep step = coordinates.step(link);
    inertias[p] = inertias[p].plus(step.toParent(inertia));
    wrenches[p] = wrenches[p].plus(step.toParent(wrench));
  }
}
