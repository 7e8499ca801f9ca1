package org.mechservice.sim.equations.recursion;

import org.mechservice.solver.links.Link;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.step.Twist;
import org.mechservice.solver.step.Wrench;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarMatrix;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * A link with all links beyond it as one rigid body, and the velocity derivative of its inertia
 * force: the operator 2 B = V ×* I − I V × + (·) ×* (I V), summed over the links. With momentum I V
 * = [n; l] and h = m c most terms cancel: 2 B [ω; u] = [T ω; −2 l × ω] with T = W + Wᵀ − h uᵀ − u
 * hᵀ + 2 (h·u) 1 − n×, W = ω× J.
 *
 * @param mass m, kg
 * @param moment h, kg·m
 * @param second J about the origin, symmetric, kg·m²
 * @param turning T, kg·m²/s
 * @param momentum l, N·s
 */
public record RigidComposite(
    double mass,
    ScalarVector moment,
    ScalarMatrix second,
    ScalarMatrix turning,
    ScalarVector momentum) {

  /** Returns a link's own body, moving at a velocity. */
  public static RigidComposite of(Expressions expressions, Link link, Twist velocity) {
    InertiaTensor own = link.inertiaAtOrigin();
    double[][] elements = {
      {own.xx(), own.xy(), own.xz()}, {own.xy(), own.yy(), own.yz()}, {own.xz(), own.yz(), own.zz()}
    };
    ScalarMatrix j = ScalarMatrix.of((r, c) -> expressions.constant(elements[r][c]));
    ScalarVector h = ScalarVector.of(expressions, link.centerOfMass().times(link.mass()));
    ScalarMatrix none = ScalarMatrix.zero(expressions);
    RigidComposite still =
        new RigidComposite(link.mass(), h, j, none, ScalarVector.zero(expressions));
    Wrench momentum = still.times(velocity);
    ScalarVector u = velocity.linear();
    ScalarMatrix w = ScalarMatrix.cross(velocity.angular()).times(j);
    Scalar twice = h.dot(u).times(2);
    ScalarMatrix even =
        ScalarMatrix.symmetric(
            (r, c) -> {
              Scalar sum = w.at(r, c).plus(w.at(c, r));
              Scalar product = h.at(r).times(u.at(c)).plus(u.at(r).times(h.at(c)));
              Scalar element = sum.minus(product);
              return r == c ? element.plus(twice) : element;
            });
    ScalarMatrix odd = ScalarMatrix.cross(momentum.moment().map(Scalar::negated));
    return new RigidComposite(link.mass(), h, j, even.plus(odd), momentum.force());
  }

  public RigidComposite plus(RigidComposite other) {
    return new RigidComposite(
        mass + other.mass,
        moment.plus(other.moment),
        second.plus(other.second),
        turning.plus(other.turning),
        momentum.plus(other.momentum));
  }

  /** Returns the same inertia in other axes, given the rotation of vectors and matrices. */
  RigidComposite in(AxesOf axes) {
    return new RigidComposite(
        mass,
        axes.vector(moment),
        axes.matrix(second),
        axes.matrix(turning),
        axes.vector(momentum));
  }

  /** Rotation of vectors and matrices to other axes. */
  interface AxesOf {
    ScalarVector vector(ScalarVector v);

    ScalarMatrix matrix(ScalarMatrix m);
  }

  /**
   * Returns the same inertia about a point from which this origin is at {@code p}: h' = h + m p, J'
   * = J + 2 (p·h) 1 − p hᵀ − h pᵀ + m ((p·p) 1 − p pᵀ), T' = T + 2 ((p·l) 1 − l pᵀ).
   */
  RigidComposite shifted(ScalarVector p) {
    ScalarVector half = moment.plus(p.map(x -> x.times(mass / 2)));
    Scalar along = p.dot(half).times(2);
    ScalarMatrix j =
        ScalarMatrix.symmetric(
            (r, c) -> {
              Scalar product = p.at(r).times(half.at(c)).plus(half.at(r).times(p.at(c)));
              Scalar element = second.at(r, c).minus(product);
              return r == c ? element.plus(along) : element;
            });
    Scalar carried = p.dot(momentum).times(2);
    ScalarMatrix t =
        ScalarMatrix.of(
            (r, c) -> {
              Scalar element = turning.at(r, c).minus(momentum.at(r).times(2).times(p.at(c)));
              return r == c ? element.plus(carried) : element;
            });
    return new RigidComposite(mass, moment.plus(p.map(x -> x.times(mass))), j, t, momentum);
  }

  /** Returns I x = [J ω + h × u; m u − h × ω]. */
  public Wrench times(Twist x) {
    return new Wrench(
        second.times(x.angular()).plus(moment.cross(x.linear())),
        x.linear().map(u -> u.times(mass)).minus(moment.cross(x.angular())));
  }

  /** Returns 2 B x = [T ω; 2 ω × l]. */
  public Wrench changed(Twist x) {
    return new Wrench(turning.times(x.angular()), x.angular().cross(momentum).map(f -> f.times(2)));
  }

  /** Returns the moment (2 B)ᵀ x = Tᵀ ω + 2 l × u; the force is zero. */
  public ScalarVector changedBack(Twist x) {
    return turning
        .transposed()
        .times(x.angular())
        .plus(momentum.cross(x.linear()).map(n -> n.times(2)));
  }
}
