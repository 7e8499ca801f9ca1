package org.mechservice.sim.equations.recursion;

import java.util.Arrays;
import java.util.List;
import org.mechservice.sim.equations.kinematics.Coordinates;
import org.mechservice.sim.equations.kinematics.JointSubspace;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.step.Twist;
import org.mechservice.solver.step.Wrench;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Scalar;

/** Components of wrenches on links along the velocities of the state: rows Sᵀ w. */
public final class VelocityRows {
  private final Expressions expressions;
  private final Links mechanism;
  private final ParentTransform toParent;
  private final JointSubspace subspace;

  public VelocityRows(Expressions expressions, Links mechanism, Coordinates coordinates) {
    this.expressions = expressions;
    this.mechanism = mechanism;
    this.toParent = new ParentTransform(coordinates);
    this.subspace = new JointSubspace(expressions, coordinates);
  }

  /** Returns a row of zeros, one per velocity of the state. */
  public Scalar[] zeros() {
    Scalar[] row = new Scalar[mechanism.velocityCount()];
    Arrays.fill(row, expressions.zero());
    return row;
  }

  /** Returns the index of a link's first velocity among those of the state. */
  public int velocity(Link link) {
    return link.velocity() - mechanism.positionCount();
  }

  /** Returns S of each velocity of a link. */
  List<Twist> subspace(Link link) {
    return link.isDriven() ? List.of() : subspace.of(link);
  }

  /**
   * Adds the components of a wrench on a link along the velocities between the link and an
   * ancestor, without those of the ancestor.
   */
  public void add(int link, int ancestor, Wrench wrench, Scalar[] row) {
    Wrench carried = wrench;
    for (int i = link; i != ancestor; i = mechanism.links().get(i).parent()) {
      Link on = mechanism.links().get(i);
      int at = velocity(on);
      for (Twist motion : subspace(on)) {
        row[at] = row[at].plus(motion.dot(carried));
        at++;
      }
      if (on.parent() != ancestor) {
        carried = toParent.wrench(on, carried);
      }
    }
  }

  /** Returns a wrench on a link in its parent's frame. */
  Wrench toParent(Link link, Wrench wrench) {
    return toParent.wrench(link, wrench);
  }
}
