package org.mechservice.solver.spatial;

/**
 * A symmetric inertia tensor, kg·m²: matrix elements, so {@code xy} is the element itself, −∫ x y
 * dm.
 *
 * @param xx first diagonal element
 * @param yy second diagonal element
 * @param zz third diagonal element
 * @param xy element of row 1, column 2
 * @param xz element of row 1, column 3
 * @param yz element of row 2, column 3
 */
public record InertiaTensor(double xx, double yy, double zz, double xy, double xz, double yz) {
  public static final InertiaTensor ZERO = new InertiaTensor(0, 0, 0, 0, 0, 0);

  /** Returns whether all components are zero. */
  public boolean isZero() {
    return xx == 0 && yy == 0 && zz == 0 && xy == 0 && xz == 0 && yz == 0;
  }

  /** Returns the product with a vector in the same axes. */
  public Vector3 times(Vector3 v) {
    return new Vector3(
        xx * v.x() + xy * v.y() + xz * v.z(),
        xy * v.x() + yy * v.y() + yz * v.z(),
        xz * v.x() + yz * v.y() + zz * v.z());
  }

  /**
   * Returns the same tensor in parent axes, R I Rᵀ.
   *
   * @param r takes the tensor's axes to the parent axes
   */
  public InertiaTensor in(Rotation r) {
    Vector3 cx = r.apply(times(new Vector3(r.xx(), r.xy(), r.xz())));
    Vector3 cy = r.apply(times(new Vector3(r.yx(), r.yy(), r.yz())));
    Vector3 cz = r.apply(times(new Vector3(r.zx(), r.zy(), r.zz())));
    return new InertiaTensor(cx.x(), cy.y(), cz.z(), cy.x(), cz.x(), cz.y());
  }

  /** Returns the sum of the diagonal. */
  public double trace() {
    return xx + yy + zz;
  }
}
