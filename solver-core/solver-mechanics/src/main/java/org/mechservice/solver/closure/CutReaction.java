package org.mechservice.solver.closure;

import java.util.Arrays;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.spatial.Blocks;

/** The reaction of a cut joint on its second body. Workspace of one thread. */
public final class CutReaction {
  private final LoopEquations loops;
  private final int firstRow;
  private final int end;

  /** The link whose load is read: body 2, or body 1, with the opposite sign, if 2 is the root. */
  private final int link;

  private final double sign;
  private final int child;
  private final int ancestor;
  private final double[] point = new double[3];
  private final double[] reference = new double[3];
  private final double[] lever = new double[3];
  private final double[] load;
  private final double[] tau;

  /**
   * @param firstRow the joint's first equation
   */
  public CutReaction(JointClosure closure, TreeGeometry tree, LoopEquations loops, int firstRow) {
    this.loops = loops;
    this.firstRow = firstRow;
    int row = firstRow;
    while (row < loops.count() && loops.closure(row) == closure) {
      row++;
    }
    end = row;
    Attachment at = closure.joint().attachment();
    child = tree.linkOf(at.child());
    link = child == TreeGeometry.ROOT ? tree.linkOf(at.parent()) : child;
    sign = child == TreeGeometry.ROOT ? -1 : 1;
    ancestor = tree.commonAncestor(link, child);
    tree.fromReference(new BodyPoint(at.child(), at.childPoint()), point, 0);
    load = new double[6 * tree.linkCount];
    tau = new double[tree.velocityCount];
  }

  /**
   * Writes the reaction.
   *
   * @param multipliers λ of all equations
   * @param wrench [force; moment] at the joint's point on body 2, world axes; overwritten from
   *     {@code at}
   */
  public void write(TreeMotion motion, double[] multipliers, double[] wrench, int at) {
    Arrays.fill(load, 0);
    for (int row = firstRow; row < end; row++) {
      loops.addForces(row, -sign * multipliers[row], load, tau);
    }
    motion.toWorld(link, load, 6 * link + 3, wrench, at);
    motion.toWorld(link, load, 6 * link, wrench, at + 3);
    motion.points.difference(ancestor, child, point, 0, link, reference, 0, lever, 0);
    Blocks.addCross(lever, 0, wrench, at, wrench, at + 3);
  }
}
