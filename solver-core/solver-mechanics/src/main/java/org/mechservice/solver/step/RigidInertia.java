package org.mechservice.solver.step;

import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarMatrix;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * Inertia of a rigid body about the origin of its frame: a motion [ω; u] has the momentum J ω + h ×
 * u about the origin and m u − h × ω.
 *
 * @param mass m, kg
 * @param first h, kg·m
 * @param second J, symmetric, kg·m²
 */
public record RigidInertia(Scalar mass, ScalarVector first, ScalarMatrix second)
    implements Moved<RigidInertia> {

  public RigidInertia plus(RigidInertia other) {
    return new RigidInertia(
        mass.plus(other.mass), first.plus(other.first), second.plus(other.second));
  }

  @Override
  public RigidInertia in(ScalarMatrix rotation) {
    return new RigidInertia(mass, rotation.times(first), second.in(rotation));
  }

  @Override
  public RigidInertia turned(int axis, Scalar cosine, Scalar sine) {
    return new RigidInertia(
        mass, first.turned(axis, cosine, sine), second.turned(axis, cosine, sine));
  }

  /**
   * {@inheritDoc} h' = h + m r and J' = J + 2 (r·g) 1 − r gᵀ − g rᵀ with g half way, h + m r / 2.
   */
  @Override
  public RigidInertia shifted(ScalarVector r) {
    Scalar half = mass.times(0.5);
    ScalarVector g = first.plus(r.map(x -> x.times(half)));
    Scalar along = r.dot(g).times(2);
    ScalarMatrix j =
        ScalarMatrix.symmetric(
            (row, column) -> {
              Scalar product = r.at(row).times(g.at(column)).plus(g.at(row).times(r.at(column)));
              Scalar element = second.at(row, column).minus(product);
              return row == column ? element.plus(along) : element;
            });
    return new RigidInertia(mass, first.plus(r.map(x -> x.times(mass))), j);
  }

  /** Returns the momentum of a motion: the wrench of an acceleration [ω; u] at rest. */
  public Wrench times(Twist x) {
    return new Wrench(
        second.times(x.angular()).plus(first.cross(x.linear())),
        x.linear().map(u -> u.times(mass)).minus(first.cross(x.angular())));
  }

  /** Returns the column of a degree of freedom: the moment and force of a unit acceleration. */
  public Wrench along(DegreeOfFreedom freedom) {
    int axis = freedom.axis();
    Wrench turning =
        new Wrench(
            second.column(axis), ScalarMatrix.cross(first).column(axis).map(Scalar::negated));
    if (!freedom.slides()) {
      return turning;
    }
    Scalar zero = mass.expressions().zero();
    ScalarVector force = freedom.replaced(new ScalarVector(zero, zero, zero), mass);
    Wrench moving = new Wrench(ScalarMatrix.cross(first).column(axis), force).times(freedom.way());
    return freedom.turns() ? turning.plus(moving) : moving;
  }
}
