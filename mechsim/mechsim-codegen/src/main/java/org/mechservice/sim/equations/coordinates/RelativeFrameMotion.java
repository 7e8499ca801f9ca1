package org.mechservice.sim.equations.coordinates;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.mechservice.sim.equations.kinematics.BodyPoints;
import org.mechservice.sim.equations.kinematics.LinkKinematics;
import org.mechservice.sim.equations.recursion.ForceSweep;
import org.mechservice.sim.equations.recursion.Loads;
import org.mechservice.sim.equations.recursion.VelocityRows;
import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.Expression.RelativeMotion;
import org.mechservice.solver.force.law.Frames;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarMatrix;
import org.mechservice.solver.symbol.ScalarVector;

/** Pose and motion of a frame of body 2 relative to a frame of body 1, in the axes of frame 1. */
public final class RelativeFrameMotion implements Frames {
  private final LinkKinematics kinematics;
  private final int link1;
  private final int link2;
  private final int ancestor;
  private final ScalarVector r1;
  private final ScalarVector r2;

  /** Rotation from the axes of frame 1 to those of link 1. */
  private final ScalarMatrix axes1;

  private final ScalarMatrix axes2;

  /** Origin of frame 2 from that of frame 1, in link 1's axes. */
  private final ScalarVector between;

  public RelativeFrameMotion(
      LinkKinematics kinematics, BodyPoints points, BodyFrame frame1, BodyFrame frame2) {
    this.kinematics = kinematics;
    this.link1 = points.link(frame1.body());
    this.link2 = points.link(frame2.body());
    this.ancestor = kinematics.commonAncestor(link1, link2);
    this.r1 = points.inLink(frame1.origin());
    this.r2 = points.inLink(frame2.origin());
    this.axes1 = points.axes(frame1.body(), frame1.axes());
    this.axes2 = points.axes(frame2.body(), frame2.axes());
    ScalarVector first = kinematics.pointFrom(ancestor, link1, r1);
    ScalarVector second = kinematics.pointFrom(ancestor, link2, r2);
    ScalarVector way = second.minus(first);
    this.between = kinematics.fromAncestor(ancestor, link1, way);
  }

  private ScalarVector inFrame1(ScalarVector inLink1) {
    return axes1.transposed().times(inLink1);
  }

  /** Returns link 1 components of a vector given in link 2 components. */
  private ScalarVector fromLink2(ScalarVector v) {
    return kinematics.fromAncestor(ancestor, link1, kinematics.toAncestor(ancestor, link2, v));
  }

  @Override
  public ScalarVector displacement() {
    return inFrame1(between);
  }

  @Override
  public ScalarMatrix rotation() {
    ScalarVector x = inFrame1(fromLink2(axes2.column(0)));
    ScalarVector y = inFrame1(fromLink2(axes2.column(1)));
    ScalarVector z = inFrame1(fromLink2(axes2.column(2)));
    return ScalarMatrix.of((i, j) -> (j == 0 ? x : j == 1 ? y : z).at(i));
  }

  @Override
  public ScalarVector omega() {
    ScalarVector second = fromLink2(kinematics.omega(link2));
    return inFrame1(second.minus(kinematics.omega(link1)));
  }

  @Override
  public ScalarVector rate() {
    ScalarVector second = fromLink2(kinematics.velocityAt(link2, r2));
    ScalarVector carried = kinematics.velocityAt(link1, r1.plus(between));
    return inFrame1(second.minus(carried));
  }

  /** Returns a component in the order of {@link RelativeMotion}. */
  public Scalar component(int component) {
    if (component < RelativeMotion.ROTATION) {
      return displacement().at(component);
    } else if (component < RelativeMotion.ANGULAR_VELOCITY) {
      int entry = component - RelativeMotion.ROTATION;
      return rotation().at(entry / 3, entry % 3);
    } else if (component < RelativeMotion.RATE) {
      return omega().at(component - RelativeMotion.ANGULAR_VELOCITY);
    }
    return rate().at(component - RelativeMotion.RATE);
  }

  /**
   * Returns the second derivative of the displacement relative to body 1, m/s², for the
   * accelerations of a sweep: ρ'' = a_2 − a_1(r_2) − 2 ω_1 × ρ'.
   */
  public ScalarVector acceleration(ForceSweep sweep) {
    ScalarVector second = fromLink2(sweep.motion(link2).accelerationAt(r2));
    ScalarVector carried = sweep.motion(link1).accelerationAt(r1.plus(between));
    ScalarVector omega = inFrame1(kinematics.omega(link1));
    ScalarVector turned = omega.cross(rate()).map(c -> c.times(2));
    return inFrame1(second.minus(carried)).minus(turned);
  }

  /** Returns the derivative of the relative angular velocity relative to body 1, rad/s². */
  public ScalarVector alpha(ForceSweep sweep) {
    ScalarVector second = fromLink2(sweep.motion(link2).alpha());
    ScalarVector omega = inFrame1(kinematics.omega(link1));
    return inFrame1(second.minus(sweep.motion(link1).alpha())).minus(omega.cross(omega()));
  }

  /** Returns the links of the two bodies, without the root. */
  public List<Integer> links() {
    return Stream.of(link1, link2).filter(link -> link != Links.ROOT).distinct().toList();
  }

  /** Returns the nearest common ancestor of the two links, which may be one of them or the root. */
  public int ancestor() {
    return ancestor;
  }

  /**
   * Adds to a row the components of a force and a moment, as in {@link #addWrench}, along the
   * velocities.
   */
  public void addRow(ScalarVector force, ScalarVector moment, VelocityRows rows, Scalar[] row) {
    Loads loads = new Loads(force.x().expressions(), kinematics.mechanism());
    addWrench(force, moment, loads);
    if (link1 != link2) {
      for (int link : List.of(link1, link2)) {
        if (link != Links.ROOT) {
          rows.add(link, ancestor, loads.on(link), row);
        }
      }
    }
  }

  /**
   * Adds a force and a moment on body 2 at the origin of frame 2, in the axes of frame 1, and the
   * opposite ones on body 1 along the same line.
   */
  public void addWrench(ScalarVector force, ScalarVector moment, Loads loads) {
    ScalarVector force1 = axes1.times(force);
    ScalarVector moment1 = axes1.times(moment);
    if (link2 != Links.ROOT) {
      loads.add(link2, r2, inLink2(force1), inLink2(moment1));
    }
    if (link1 != Links.ROOT) {
      loads.add(link1, r1.plus(between), force1.map(Scalar::negated), moment1.map(Scalar::negated));
    }
  }

  /** Returns ancestor components of a vector given in the axes of frame 1. */
  public ScalarVector inAncestor(ScalarVector inFrame1) {
    return kinematics.toAncestor(ancestor, link1, axes1.times(inFrame1));
  }

  /** Returns the origin of frame 2 from the ancestor's, in the ancestor's axes, m. */
  public ScalarVector point2() {
    return kinematics.pointFrom(ancestor, link2, r2);
  }

  /** Returns the links from body 1 inwards, without the ancestor. */
  public List<Integer> way1() {
    return way(link1);
  }

  /** Returns the links from body 2 inwards, without the ancestor. */
  public List<Integer> way2() {
    return way(link2);
  }

  private List<Integer> way(int end) {
    List<Integer> way = new ArrayList<>();
    for (int i = end; i != ancestor; i = kinematics.mechanism().links().get(i).parent()) {
      way.add(i);
    }
    return way;
  }

  private ScalarVector inLink2(ScalarVector inLink1) {
    return kinematics.fromAncestor(
        ancestor, link2, kinematics.toAncestor(ancestor, link1, inLink1));
  }
}
