package org.mechservice.solver.oracle;

import org.mechservice.solver.spatial.Vector3;

/** A vector that moves. */
public record TaylorVector(Taylor x, Taylor y, Taylor z) {
  static final TaylorVector ZERO = of(Vector3.ZERO);

  public static TaylorVector of(Vector3 v) {
    return new TaylorVector(Taylor.of(v.x()), Taylor.of(v.y()), Taylor.of(v.z()));
  }

  public static TaylorVector of(Vector3 value, Vector3 rate, Vector3 acceleration) {
    return new TaylorVector(
        new Taylor(value.x(), rate.x(), acceleration.x()),
        new Taylor(value.y(), rate.y(), acceleration.y()),
        new Taylor(value.z(), rate.z(), acceleration.z()));
  }

  public TaylorVector plus(TaylorVector b) {
    return new TaylorVector(x.plus(b.x), y.plus(b.y), z.plus(b.z));
  }

  public TaylorVector minus(TaylorVector b) {
    return new TaylorVector(x.minus(b.x), y.minus(b.y), z.minus(b.z));
  }

  public TaylorVector times(Taylor factor) {
    return new TaylorVector(x.times(factor), y.times(factor), z.times(factor));
  }

  public Taylor dot(TaylorVector b) {
    return x.times(b.x).plus(y.times(b.y)).plus(z.times(b.z));
  }

  public Taylor dot(Vector3 b) {
    return dot(of(b));
  }

  public TaylorVector cross(TaylorVector b) {
    return new TaylorVector(
        y.times(b.z).minus(z.times(b.y)),
        z.times(b.x).minus(x.times(b.z)),
        x.times(b.y).minus(y.times(b.x)));
  }

  public Vector3 value() {
    return new Vector3(x.x(), y.x(), z.x());
  }

  public Vector3 rate() {
    return new Vector3(x.d(), y.d(), z.d());
  }

  public Vector3 acceleration() {
    return new Vector3(x.dd(), y.dd(), z.dd());
  }
}
