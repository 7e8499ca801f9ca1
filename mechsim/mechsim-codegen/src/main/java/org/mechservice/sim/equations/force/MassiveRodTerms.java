package org.mechservice.sim.equations.force;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.sim.equations.kinematics.BodyPoints;
import org.mechservice.sim.equations.kinematics.LinkKinematics;
import org.mechservice.sim.equations.recursion.ForceSweep;
import org.mechservice.sim.equations.recursion.VelocityRows;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.links.RigidGroups;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.step.Wrench;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * Uniform slender rods between two points (docs/theory/motion.md#bodies). The squares in the energy
 * (m/6) (v_A·v_A + v_A·v_B + v_B·v_B) are those of a mass m/3 at each end, which is added to the
 * links. This class has the remaining terms: the product, and the weight of m/6 at each end.
 */
public final class MassiveRodTerms {
  private final Expressions expressions;
  private final LinkKinematics kinematics;
  private final BodyPoints points;
  private final VelocityRows rows;
  private final List<DistanceClosure> rods;

  /**
   * @param mechanism mechanism with end masses of rods in its links, {@link #withEnds}
   */
  public MassiveRodTerms(
      Expressions expressions, Links mechanism, LinkKinematics kinematics, VelocityRows rows) {
    this.expressions = expressions;
    this.kinematics = kinematics;
    this.points = new BodyPoints(expressions, mechanism);
    this.rows = rows;
    this.rods = rods(mechanism);
  }

  private static List<DistanceClosure> rods(Links mechanism) {
    List<DistanceClosure> rods = new ArrayList<>();
    for (LoopClosure closure : mechanism.mechanism().closures()) {
      if (closure instanceof DistanceClosure distance && distance.hasRod()) {
        rods.add(distance);
      }
    }
    return rods;
  }

  /** Returns a mechanism whose links include a third of each rod's mass at each end. */
  public static Links withEnds(Links mechanism) {
    List<Link> links = new ArrayList<>(mechanism.links());
    for (DistanceClosure rod : rods(mechanism)) {
      for (BodyPoint point : List.of(rod.point1(), rod.point2())) {
        int link =
            point.body() == BodyPoint.ROOT
                ? Links.ROOT
                : mechanism.bodies().get(point.body()).link();
        if (link != Links.ROOT) {
          Vector3 place = BodyPoints.place(mechanism, point);
          RigidGroups.MassProperties end =
              new RigidGroups.MassProperties(rod.rodMass() / 3, place, InertiaTensor.ZERO);
          links.set(link, links.get(link).carrying(end));
        }
      }
    }
    return mechanism.with(links);
  }

  /**
   * Adds the remaining inertia forces of the ends: m/6 times the acceleration of the other end,
   * gravity included.
   */
  public void addNeeded(ForceSweep sweep, Wrench[] needed) {
    for (DistanceClosure rod : rods) {
      int a = points.link(rod.point1().body());
      int b = points.link(rod.point2().body());
      ScalarVector atA = points.inLink(rod.point1());
      ScalarVector atB = points.inLink(rod.point2());
      ScalarVector ofA = force(a, atA, b, rod, sweep);
      ScalarVector ofB = force(b, atB, a, rod, sweep);
      add(needed, b, atB, ofA);
      add(needed, a, atA, ofB);
    }
  }

  private ScalarVector force(
      int link, ScalarVector point, int other, DistanceClosure rod, ForceSweep sweep) {
    int ancestor = kinematics.commonAncestor(link, other);
    ScalarVector acceleration =
        kinematics.toAncestor(ancestor, link, sweep.motion(link).accelerationAt(point));
    return kinematics
        .fromAncestor(ancestor, other, acceleration)
        .map(c -> c.times(rod.rodMass() / 6));
  }

  private static void add(Wrench[] needed, int link, ScalarVector point, ScalarVector force) {
    if (link != Links.ROOT) {
      needed[link] = needed[link].plus(new Wrench(point.cross(force), force));
    }
  }

  /** Adds m/6 (J_Aᵀ J_B + J_Bᵀ J_A) of each rod to the lower triangle of M. */
  public void addMass(Scalar[][] mass) {
    for (DistanceClosure rod : rods) {
      int a = points.link(rod.point1().body());
      int b = points.link(rod.point2().body());
      int ancestor = kinematics.commonAncestor(a, b);
      for (int axis = 0; axis < 3; axis++) {
        Scalar[] ofA = row(a, points.inLink(rod.point1()), ancestor, axis);
        Scalar[] ofB = row(b, points.inLink(rod.point2()), ancestor, axis);
        addProduct(ofA, ofB, rod.rodMass() / 6, mass);
      }
    }
  }

  private static void addProduct(Scalar[] a, Scalar[] b, double sixth, Scalar[][] mass) {
    for (int i = 0; i < a.length; i++) {
      for (int j = 0; j <= i; j++) {
        Scalar sum = a[i].times(b[j]).plus(b[i].times(a[j]));
        mass[i][j] = mass[i][j].plus(sum.times(sixth));
      }
    }
  }

  /**
   * Returns m/6 v_A·v_B of all rods: the kinetic energy in addition to that of the end masses, J.
   */
  public Scalar kinetic() {
    Scalar sum = expressions.zero();
    for (DistanceClosure rod : rods) {
      int a = points.link(rod.point1().body());
      int b = points.link(rod.point2().body());
      int ancestor = kinematics.commonAncestor(a, b);
      ScalarVector ofA = kinematics.velocityAt(a, points.inLink(rod.point1()));
      ScalarVector ofB = kinematics.velocityAt(b, points.inLink(rod.point2()));
      Scalar product =
          kinematics.toAncestor(ancestor, a, ofA).dot(kinematics.toAncestor(ancestor, b, ofB));
      sum = sum.plus(product.times(rod.rodMass() / 6));
    }
    return sum;
  }

  /** Returns the potential energy of all rods in addition to that of the end masses, J. */
  public Scalar potential(Mechanism described) {
    ScalarVector gravity = ScalarVector.of(expressions, described.gravity());
    Scalar sum = expressions.zero();
    for (DistanceClosure rod : rods) {
      for (BodyPoint point : List.of(rod.point1(), rod.point2())) {
        int link = points.link(point.body());
        double carried = link == Links.ROOT ? 0 : rod.rodMass() / 3;
        Scalar depth = kinematics.placeInWorld(link, points.inLink(point)).dot(gravity);
        sum = sum.minus(depth.times(rod.rodMass() / 2 - carried));
      }
    }
    return sum;
  }

  /**
   * Returns the derivatives of a point's velocity along an axis of the ancestor by the velocities
   * of the state.
   */
  private Scalar[] row(int link, ScalarVector point, int ancestor, int axis) {
    Scalar[] row = rows.zeros();
    if (link != Links.ROOT) {
      Scalar zero = expressions.zero();
      Scalar one = expressions.one();
      ScalarVector along =
          new ScalarVector(axis == 0 ? one : zero, axis == 1 ? one : zero, axis == 2 ? one : zero);
      ScalarVector force = kinematics.fromAncestor(ancestor, link, along);
      rows.add(link, Links.ROOT, new Wrench(point.cross(force), force), row);
    }
    return row;
  }
}
