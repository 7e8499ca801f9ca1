package org.mechservice.sim.equations;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.mechservice.sim.equations.force.AppliedForces;
import org.mechservice.sim.equations.kinematics.Coordinates;
import org.mechservice.sim.equations.kinematics.JointOutputs;
import org.mechservice.sim.equations.kinematics.PositionRates;
import org.mechservice.sim.equations.recursion.ForceSweep;
import org.mechservice.sim.equations.recursion.JointSweep;
import org.mechservice.sim.equations.recursion.Loads;
import org.mechservice.sim.equations.recursion.ParentTransform;
import org.mechservice.sim.equations.recursion.Pivots;
import org.mechservice.sim.equations.recursion.TreeFactors;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.step.DegreeOfFreedom;
import org.mechservice.solver.step.RigidInertia;
import org.mechservice.solver.step.Wrench;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * y' = f(t, y) of an open chain, semi-recursive (DSR,
 * docs/theory/formulations.md#dsr-composite-inertias): M a = τ − b, with M from composite inertias,
 * nonzero only between each joint and its ancestors, factored as LᵀDL along the tree without
 * fill-in (Featherstone 2008, §6.2 and §6.5), and b from one outward and one inward sweep.
 */
public final class CompositeInertiaEquations {
  private final Program program = new Program();
  private final Expressions expressions = program.expressions();
  private final Links mechanism;
  private final List<Link> links;
  private final Coordinates coordinates;
  private final ParentTransform toParent;

  /**
   * A velocity in link axes: its link and degree of freedom; velocities nearer the root come first.
   */
  private record Velocity(int link, DegreeOfFreedom freedom) {}

  private final List<Velocity> velocities = new ArrayList<>();

  private CompositeInertiaEquations(Links mechanism) {
    this.mechanism = mechanism;
    this.links = mechanism.links();
    this.coordinates = new Coordinates(program, mechanism);
    this.toParent = new ParentTransform(coordinates);
    for (int i = 0; i < links.size(); i++) {
      if (!links.get(i).isDriven()) {
        // the last is eliminated first
        List<DegreeOfFreedom> freedoms = DegreeOfFreedom.of(expressions, links.get(i));
        for (int f = freedoms.size() - 1; f >= 0; f--) {
          velocities.add(new Velocity(i, freedoms.get(f)));
        }
      }
    }
  }

  /**
   * Derives the program from the state [q; v] to its derivative [q'; v'].
   *
   * @return a program whose guards return the index, among the joints that have states, of the
   *     joint beyond which there is no inertia
   */
  public static Program derive(Links mechanism) {
    return new CompositeInertiaEquations(mechanism).derive();
  }

  private Program derive() {
    new PositionRates(program, mechanism, coordinates).putOut();
    ArticulatedBodyEquations.putOutFurtherRates(program, mechanism, coordinates);
    Wrench[] needed = new ForceSweep(program, mechanism, coordinates).sweep();
    Loads loads = new AppliedForces(program, mechanism, coordinates).loads(true);
    for (int i = 0; i < needed.length; i++) {
      needed[i] = needed[i].minus(loads.on(i));
    }
    ScalarVector[] bias = new JointSweep(program, mechanism, coordinates).sweep(needed, loads);
    TreeFactors factors =
        new TreeFactors(program, massMatrix(), ancestors(), k -> label(velocities.get(k)));
    Pivots pivots = new Pivots(program, links, coordinates, true);
    boolean regular =
        factors.factor(
            (k, pivot) ->
                pivots.guarded(velocities.get(k).link(), velocities.get(k).freedom(), pivot));
    if (regular) {
      Scalar[] forces = new Scalar[velocities.size()];
      for (int k = 0; k < forces.length; k++) {
        Velocity velocity = velocities.get(k);
        forces[k] = bias[velocity.link()].at(velocity.freedom().axis()).negated();
      }
      putOut(factors.solve(forces));
    }
    return program;
  }

  private String label(Velocity velocity) {
    Link link = links.get(velocity.link());
    String component = link.isBall() ? "_" + "xyz".charAt(velocity.freedom().axis()) : "";
    return link.jointLabel() + component;
  }

  /** Returns the ancestors of each velocity, the nearest first. */
  private List<List<Integer>> ancestors() {
    List<List<Integer>> ancestors = new ArrayList<>();
    for (int k = 0; k < velocities.size(); k++) {
      List<Integer> own = new ArrayList<>();
      for (int i = velocities.get(k).link(); i != Links.ROOT; i = links.get(i).parent()) {
        for (int j = k - 1; j >= 0; j--) {
          if (velocities.get(j).link() == i) {
            own.add(j);
          }
        }
      }
      ancestors.add(own);
    }
    return ancestors;
  }

  /** Returns each link with all links beyond it as one rigid body. */
  private RigidInertia[] composites() {
    RigidInertia[] composites = new RigidInertia[links.size()];
    for (int i = 0; i < composites.length; i++) {
      composites[i] = coordinates.step(links.get(i)).rigidInertia();
    }
    for (int i = composites.length - 1; i >= 0; i--) {
      Link link = links.get(i);
      program.section("Composite inertia: " + link.title() + ".\nI_p += X I X'", link.bodyLabel());
      program.named("J_" + link.bodyLabel(), composites[i].second());
      program.named("h_" + link.bodyLabel(), composites[i].first());
      if (link.parent() != Links.ROOT) {
        int p = link.parent();
        composites[p] = composites[p].plus(coordinates.step(link).toParent(composites[i]));
      }
    }
    return composites;
  }

  /** Returns M_kj for all ancestors j of k, zero elsewhere. */
  private Scalar[][] massMatrix() {
    RigidInertia[] composites = composites();
    int n = velocities.size();
    Scalar[][] mass = new Scalar[n][n];
    for (int k = n - 1; k >= 0; k--) {
      Velocity velocity = velocities.get(k);
      Link link = links.get(velocity.link());
      program.section(
          "Mass matrix: " + link.title() + ".\nM_kj = S_j.X I S_k on the way to the root",
          link.bodyLabel());
      Wrench column = composites[velocity.link()].along(velocity.freedom());
      for (int i = velocity.link(); i != Links.ROOT; i = links.get(i).parent()) {
        for (int j = 0; j <= k; j++) {
          if (velocities.get(j).link() == i) {
            String name = "M_" + label(velocity) + "_" + label(velocities.get(j));
            DegreeOfFreedom along = velocities.get(j).freedom();
            mass[k][j] = program.named(name, j == k ? along.pivot(column) : along.along(column));
          }
        }
        column = toParent.wrench(links.get(i), column);
      }
    }
    return mass;
  }

  private void putOut(Scalar[] accelerations) {
    program.section("v' in the order of the state.", "a");
    ScalarVector[] ofLink = new ScalarVector[links.size()];
    Arrays.fill(ofLink, ScalarVector.zero(expressions));
    for (int k = 0; k < accelerations.length; k++) {
      int i = velocities.get(k).link();
      ofLink[i] = velocities.get(k).freedom().replaced(ofLink[i], accelerations[k]);
    }
    new JointOutputs(mechanism, coordinates).putOut(ofLink, program);
  }
}
