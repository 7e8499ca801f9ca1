package org.mechservice.solver.force.formula;

import static org.mechservice.solver.spatial.Blocks.addCross;
import static org.mechservice.solver.spatial.Blocks.cross;

import java.util.Arrays;
import java.util.function.IntConsumer;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.force.applied.ForceJacobian;
import org.mechservice.solver.force.applied.GradientSink;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;

/**
 * A component of a point's position or velocity in world axes. With the world's axis e and the
 * point r in link axes: δ(e · p) = e · (δp + δθ × r), and e · u changes by e · (δθ × u) at held
 * velocity components.
 */
public final class PointInput extends LeafInput {
  private final TreeMotion motion;
  private final int link;
  private final int axis;
  private final boolean velocity;
  private final double[] r = new double[3];
  private final double[] world = new double[3];
  private final double[] e = new double[3];
  private final double[] unit = new double[3];
  private final double[] u = new double[3];
  private final double[] byPlace = new double[6];
  private final double[] byVelocity = new double[6];
  private final double[] turn = new double[3];
  private final double[] column = new double[6];
  private final double[] turned = new double[36];
  private final double[] still = new double[36];

  public PointInput(TreeMotion motion, BodyPoint point, int axis, boolean velocity) {
    this.motion = motion;
    this.axis = axis;
    this.velocity = velocity;
    link = motion.tree().linkOf(point.body());
    motion.tree().fromReference(point, r, 0);
    unit[axis] = 1;
  }

  @Override
  double value(double t) {
    if (velocity) {
      motion.points.velocity(link, r, 0, world, 0);
    } else {
      motion.points.position(link, r, 0, world, 0);
    }
    return world[axis];
  }

  @Override
  public void gradient(GradientSink sink) {
    if (link == TreeGeometry.ROOT) {
      return;
    }
    motion.fromWorld(link, unit, 0, e, 0);
    double[] direct = velocity ? byVelocity : byPlace;
    cross(r, 0, e, 0, direct, 0);
    System.arraycopy(e, 0, direct, 3, 3);
    if (velocity) {
      System.arraycopy(motion.linearVelocity, 3 * link, u, 0, 3);
      addCross(motion.angularVelocity, 3 * link, r, 0, u, 0);
      Arrays.fill(byPlace, 0);
      cross(u, 0, e, 0, byPlace, 0);
    }
    sink.byLink(link, byPlace, byVelocity);
  }

  /** The force turns against the link: e changes by −δθ × e. */
  @Override
  void addCurvature(double force, ForceJacobian sink) {
    if (link == TreeGeometry.ROOT) {
      return;
    }
    motion.fromWorld(link, unit, 0, e, 0);
    Arrays.fill(turned, 0);
    for (int j = 0; j < 3; j++) {
      Arrays.fill(turn, 0);
      turn[j] = force;
      cross(e, 0, turn, 0, column, 3);
      cross(r, 0, column, 3, column, 0);
      for (int i = 0; i < 6; i++) {
        turned[6 * i + j] = column[i];
      }
    }
    sink.wrenchByLink(link, link, turned, still);
  }

  @Override
  public void links(IntConsumer taker) {
    if (link != TreeGeometry.ROOT) {
      taker.accept(link);
    }
  }
}
