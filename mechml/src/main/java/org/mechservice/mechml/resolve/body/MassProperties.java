package org.mechservice.mechml.resolve.body;

import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Vector3;

/**
 * Mass, centre of mass and inertia of a rigid body or a part of it.
 *
 * @param mass kg
 * @param center centre of mass from the body's origin, in body axes, m
 * @param inertia about the centre of mass, in body axes, kg·m²
 */
record MassProperties(double mass, Vector3 center, InertiaTensor inertia) {
  /**
   * Returns those of a part that is the same about every axis through its centre at right angles to
   * one axis.
   *
   * @param axial moment of inertia about the axis, kg·m²
   * @param transverse moment of inertia about axes at right angles to it, kg·m²
   * @param axis unit vector, body axes
   */
  static MassProperties about(
      Vector3 axis, double mass, Vector3 center, double axial, double transverse) {
    double d = axial - transverse;
    return new MassProperties(
        mass,
        center,
        new InertiaTensor(
            transverse + d * axis.x() * axis.x(),
            transverse + d * axis.y() * axis.y(),
            transverse + d * axis.z() * axis.z(),
            d * axis.x() * axis.y(),
            d * axis.x() * axis.z(),
            d * axis.y() * axis.z()));
  }

  /**
   * Returns those of two parts together, by Steiner's theorem with the reduced mass, which is exact
   * for parts of any ratio of masses. Both masses are positive.
   */
  MassProperties plus(MassProperties other) {
    double total = mass + other.mass;
    double share = other.mass / total;
    Vector3 d = other.center.minus(center);
    double reduced = mass * share;
    InertiaTensor b = other.inertia;
    return new MassProperties(
        total,
        center.plus(d.times(share)),
        new InertiaTensor(
            inertia.xx() + b.xx() + reduced * (d.y() * d.y() + d.z() * d.z()),
            inertia.yy() + b.yy() + reduced * (d.x() * d.x() + d.z() * d.z()),
            inertia.zz() + b.zz() + reduced * (d.x() * d.x() + d.y() * d.y()),
            inertia.xy() + b.xy() - reduced * d.x() * d.y(),
            inertia.xz() + b.xz() - reduced * d.x() * d.z(),
            inertia.yz() + b.yz() - reduced * d.y() * d.z()));
  }
}
