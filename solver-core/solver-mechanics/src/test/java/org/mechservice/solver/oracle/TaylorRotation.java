package org.mechservice.solver.oracle;

import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/** A rotation that moves, by the columns of its matrix: child axes in parent axes. */
public record TaylorRotation(TaylorVector x, TaylorVector y, TaylorVector z) {
  public static TaylorRotation of(Rotation r) {
    return new TaylorRotation(
        TaylorVector.of(new Vector3(r.xx(), r.yx(), r.zx())),
        TaylorVector.of(new Vector3(r.xy(), r.yy(), r.zy())),
        TaylorVector.of(new Vector3(r.xz(), r.yz(), r.zz())));
  }

  /** The rotation that starts as r with angular velocity ω and angular acceleration α, world. */
  public static TaylorRotation of(Rotation r, Vector3 omega, Vector3 alpha) {
    TaylorRotation fixed = of(r);
    return new TaylorRotation(
        turning(fixed.x.value(), omega, alpha),
        turning(fixed.y.value(), omega, alpha),
        turning(fixed.z.value(), omega, alpha));
  }

  private static TaylorVector turning(Vector3 v, Vector3 omega, Vector3 alpha) {
    Vector3 rate = omega.cross(v);
    return TaylorVector.of(v, rate, alpha.cross(v).plus(omega.cross(rate)));
  }

  /** Rot(axis, φ) by Rodrigues' formula. */
  public static TaylorRotation about(Vector3 axis, Taylor angle) {
    return new TaylorRotation(
        turned(new Vector3(1, 0, 0), axis, angle),
        turned(new Vector3(0, 1, 0), axis, angle),
        turned(new Vector3(0, 0, 1), axis, angle));
  }

  private static TaylorVector turned(Vector3 v, Vector3 u, Taylor angle) {
    Vector3 along = u.times(u.dot(v));
    return TaylorVector.of(along)
        .plus(TaylorVector.of(v.minus(along)).times(angle.cos()))
        .plus(TaylorVector.of(u.cross(v)).times(angle.sin()));
  }

  /** R(e) of Euler parameters of any length. */
  public static TaylorRotation ofEulerParameters(Taylor e0, TaylorVector e) {
    Taylor scale = e0.times(e0).plus(e.dot(e)).inverse();
    return new TaylorRotation(
        turned(new Vector3(1, 0, 0), e0, e, scale),
        turned(new Vector3(0, 1, 0), e0, e, scale),
        turned(new Vector3(0, 0, 1), e0, e, scale));
  }

  /** v → (e ∘ v ∘ e*) / |e|² = ((e0² − e·e) v + 2 (e·v) e + 2 e0 e × v) / |e|². */
  private static TaylorVector turned(Vector3 v, Taylor e0, TaylorVector e, Taylor scale) {
    return TaylorVector.of(v)
        .times(e0.times(e0).minus(e.dot(e)))
        .plus(e.times(e.dot(v).times(2)))
        .plus(e.cross(TaylorVector.of(v)).times(e0.times(2)))
        .times(scale);
  }

  public TaylorVector apply(TaylorVector v) {
    return x.times(v.x()).plus(y.times(v.y())).plus(z.times(v.z()));
  }

  public TaylorVector apply(Vector3 v) {
    return apply(TaylorVector.of(v));
  }

  public TaylorVector applyTransposed(TaylorVector v) {
    return new TaylorVector(x.dot(v), y.dot(v), z.dot(v));
  }

  public TaylorRotation times(TaylorRotation b) {
    return new TaylorRotation(apply(b.x), apply(b.y), apply(b.z));
  }

  public TaylorRotation transposed() {
    return new TaylorRotation(
        new TaylorVector(x.x(), y.x(), z.x()),
        new TaylorVector(x.y(), y.y(), z.y()),
        new TaylorVector(x.z(), y.z(), z.z()));
  }

  public Rotation value() {
    return Rotation.ofColumns(x.value(), y.value(), z.value());
  }

  /** Angular velocity in parent axes, ½ Σ columns × their rates. */
  public Vector3 angularVelocity() {
    return halfSumOfCrosses(x.rate(), y.rate(), z.rate());
  }

  /** Angular acceleration in parent axes: R'' Rᵀ = [α] + [ω][ω], of which [α] is the skew part. */
  public Vector3 angularAcceleration() {
    return halfSumOfCrosses(x.acceleration(), y.acceleration(), z.acceleration());
  }

  private Vector3 halfSumOfCrosses(Vector3 ofX, Vector3 ofY, Vector3 ofZ) {
    return x.value().cross(ofX).plus(y.value().cross(ofY)).plus(z.value().cross(ofZ)).times(0.5);
  }
}
