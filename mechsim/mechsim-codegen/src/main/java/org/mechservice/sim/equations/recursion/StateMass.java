package org.mechservice.sim.equations.recursion;

import java.util.List;
import org.mechservice.sim.equations.kinematics.Coordinates;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.step.RigidInertia;
import org.mechservice.solver.step.Twist;
import org.mechservice.solver.step.Wrench;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;

/**
 * The mass matrix for the velocities of the state, from composite inertias (Featherstone 2008,
 * §6.2) and the armatures on its diagonal.
 */
public final class StateMass {
  private final Program program;
  private final List<Link> links;
  private final Coordinates coordinates;
  private final VelocityRows rows;

  public StateMass(Program program, Links mechanism, Coordinates coordinates, VelocityRows rows) {
    this.program = program;
    this.coordinates = coordinates;
    this.links = mechanism.links();
    this.rows = rows;
  }

  /** Receives an element of M. */
  public interface Taker {
    void take(int row, int column, Scalar element);
  }

  /** Derives the elements between each velocity and its ancestors. */
  public void each(Taker taker) {
    RigidInertia[] composites = composites();
    for (int i = links.size() - 1; i >= 0; i--) {
      Link link = links.get(i);
      program.section(
          "Mass matrix: " + link.title() + ".\nM_kj = S_j.X I S_k on the way to the root",
          link.bodyLabel());
      List<Twist> own = rows.subspace(link);
      for (int c = 0; c < own.size(); c++) {
        column(i, rows.velocity(link) + c, composites[i].times(own.get(c)), taker);
      }
    }
  }

  /** Derives a column: the components of the momentum beyond a velocity along its ancestors. */
  private void column(int link, int velocity, Wrench momentum, Taker taker) {
    Wrench carried = momentum;
    for (int i = link; i != Links.ROOT; i = links.get(i).parent()) {
      Link on = links.get(i);
      int at = rows.velocity(on);
      for (Twist motion : rows.subspace(on)) {
        if (i == link && at == velocity && on.armature() != 0) {
          taker.take(velocity, at, motion.dot(carried).plus(constant(on.armature())));
        } else if (i != link || at <= velocity) {
          taker.take(velocity, at, motion.dot(carried));
        }
        at++;
      }
      if (on.parent() != Links.ROOT) {
        carried = rows.toParent(on, carried);
      }
    }
  }

  private Scalar constant(double value) {
    return program.expressions().constant(value);
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
      program.named("h_" + link.bodyLabel(), composites[i].first());
      program.named("J_" + link.bodyLabel(), composites[i].second());
      if (link.parent() != Links.ROOT) {
        int p = link.parent();
        composites[p] = composites[p].plus(coordinates.step(link).toParent(composites[i]));
      }
    }
    return composites;
  }
}
