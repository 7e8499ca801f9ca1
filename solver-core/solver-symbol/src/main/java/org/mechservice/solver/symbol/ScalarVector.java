package org.mechservice.solver.symbol;

import java.util.List;
import java.util.function.UnaryOperator;
import org.mechservice.solver.spatial.Vector3;

/**
 * A vector of scalars; the code that uses it states its frame.
 *
 * @param x first component
 * @param y second component
 * @param z third component
 */
public record ScalarVector(Scalar x, Scalar y, Scalar z) {

  /** Returns a vector of constants. */
  public static ScalarVector of(Expressions expressions, Vector3 v) {
    return new ScalarVector(
        expressions.constant(v.x()), expressions.constant(v.y()), expressions.constant(v.z()));
  }

  /** Returns a vector of zeros. */
  public static ScalarVector zero(Expressions expressions) {
    return of(expressions, Vector3.ZERO);
  }

  /** Returns component {@code i}, 0 for x. */
  public Scalar at(int i) {
    return i == 0 ? x : i == 1 ? y : z;
  }

  /** Returns the components in order. */
  public List<Scalar> components() {
    return List.of(x, y, z);
  }

  /** Returns this + other. */
  public ScalarVector plus(ScalarVector other) {
    return new ScalarVector(x.plus(other.x), y.plus(other.y), z.plus(other.z));
  }

  /** Returns this − other. */
  public ScalarVector minus(ScalarVector other) {
    return new ScalarVector(x.minus(other.x), y.minus(other.y), z.minus(other.z));
  }

  /** Returns factor · this. */
  public ScalarVector times(Scalar factor) {
    return new ScalarVector(x.times(factor), y.times(factor), z.times(factor));
  }

  /** Returns factor · this. */
  public ScalarVector times(double factor) {
    return new ScalarVector(x.times(factor), y.times(factor), z.times(factor));
  }

  /** Returns the scalar product. */
  public Scalar dot(ScalarVector other) {
    return x.times(other.x).plus(y.times(other.y)).plus(z.times(other.z));
  }

  /** Returns this × other. */
  public ScalarVector cross(ScalarVector other) {
    return new ScalarVector(
        y.times(other.z).minus(z.times(other.y)),
        z.times(other.x).minus(x.times(other.z)),
        x.times(other.y).minus(y.times(other.x)));
  }

  /** Returns the vector with every component replaced. */
  public ScalarVector map(UnaryOperator<Scalar> change) {
    return new ScalarVector(change.apply(x), change.apply(y), change.apply(z));
  }

  /**
   * Returns the components in axes turned back about a coordinate axis: v = Rot(axis, angle) ·
   * this.
   *
   * @param axis 0, 1, 2 for x, y, z
   * @param cosine of the angle
   * @param sine of the angle
   */
  public ScalarVector turned(int axis, Scalar cosine, Scalar sine) {
    int i = (axis + 1) % 3;
    int j = (axis + 2) % 3;
    Scalar[] v = {x, y, z};
    Scalar vi = v[i];
    Scalar vj = v[j];
    v[i] = cosine.times(vi).minus(sine.times(vj));
    v[j] = sine.times(vi).plus(cosine.times(vj));
    return new ScalarVector(v[0], v[1], v[2]);
  }
}
