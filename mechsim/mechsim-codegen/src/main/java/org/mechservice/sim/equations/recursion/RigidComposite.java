package org.mechservice.sim.equations.recursion;

import org.mechservice.solver.step.Moved;
import org.mechservice.solver.step.RigidInertia;
import org.mechservice.solver.step.Twist;
import org.mechservice.solver.step.Wrench;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarMatrix;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * A link with all links beyond it as one rigid body, and the velocity derivative of its inertia
 * force: the operator 2 B = V ×* I − I V × + (·) ×* (I V), summed over the links. With momentum I V
 * = [n; l] and h = m c most terms cancel: 2 B [ω; u] = [T ω; −2 l × ω] with T = W + Wᵀ − h uᵀ − u
 * hᵀ + 2 (h·u) 1 − n×, W = ω× J.
 *
 * @param inertia I, with h and J about the origin
 * @param turning T, kg·m²/s
 * @param momentum l, N·s
 */
public record RigidComposite(RigidInertia inertia, ScalarMatrix turning, ScalarVector momentum)
    implements Moved<RigidComposite> {

  /** Returns a body, moving at a velocity. */
  public static RigidComposite of(RigidInertia body, Twist velocity) {
    Wrench momentum = body.times(velocity);
    ScalarVector h = body.first();
    ScalarVector u = velocity.linear();
    ScalarMatrix w = ScalarMatrix.cross(velocity.angular()).times(body.second());
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
    return new RigidComposite(body, even.plus(odd), momentum.force());
  }

  public RigidComposite plus(RigidComposite other) {
    return new RigidComposite(
        inertia.plus(other.inertia), turning.plus(other.turning), momentum.plus(other.momentum));
  }

  @Override
  public RigidComposite in(ScalarMatrix rotation) {
    return new RigidComposite(inertia.in(rotation), turning.in(rotation), rotation.times(momentum));
  }

  @Override
  public RigidComposite turned(int axis, Scalar cosine, Scalar sine) {
    return new RigidComposite(
        inertia.turned(axis, cosine, sine),
        turning.turned(axis, cosine, sine),
        momentum.turned(axis, cosine, sine));
  }

  /** {@inheritDoc} T' = T + 2 ((r·l) 1 − l rᵀ). */
  @Override
  public RigidComposite shifted(ScalarVector r) {
    Scalar carried = r.dot(momentum).times(2);
    ScalarMatrix t =
        ScalarMatrix.of(
            (row, column) -> {
              Scalar element =
                  turning.at(row, column).minus(momentum.at(row).times(2).times(r.at(column)));
              return row == column ? element.plus(carried) : element;
            });
    return new RigidComposite(inertia.shifted(r), t, momentum);
  }

  /** Returns I x. */
  public Wrench times(Twist x) {
    return inertia.times(x);
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
