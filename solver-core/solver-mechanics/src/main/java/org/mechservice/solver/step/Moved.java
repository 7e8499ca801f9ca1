package org.mechservice.solver.step;

import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarMatrix;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * A quantity of a link that is seen from other frames: a wrench or an inertia.
 *
 * @param <T> its type
 */
public interface Moved<T> {
  /** Returns the same in other axes: components v = rotation · this. */
  T in(ScalarMatrix rotation);

  /** Returns the same in axes rotated back: components v = Rot(axis, angle) · this. */
  T turned(int axis, Scalar cosine, Scalar sine);

  /** Returns the same for a frame from which this one's origin is at {@code r}. */
  T shifted(ScalarVector r);
}
