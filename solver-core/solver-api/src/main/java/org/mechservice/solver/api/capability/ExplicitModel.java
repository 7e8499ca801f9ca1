package org.mechservice.solver.api.capability;

import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelDescription;

/** A model in explicit form, y' = f(t, y). */
public interface ExplicitModel extends Model {
  /** Result of {@link #derivative} if every articulated inertia is regular. */
  int REGULAR = -1;

  /**
   * Evaluates y' = [N(q) v; a(t, q, v)].
   *
   * @param t time, s
   * @param y state [q; v], rad, m, rad/s, m/s; not modified
   * @param yDot derivative of the state, same layout; overwritten
   * @return {@link #REGULAR}; or the index in {@link ModelDescription#joints()} of the joint beyond
   *     which there is no inertia (its block of the joint-space inertia is singular); or {@link
   *     Defects#DEFECT} if the model implements {@link Defects}; or a result of {@link
   *     DirectedForces} if the model implements that. Unless regular, {@code yDot} is undefined
   */
  int derivative(double t, double[] y, double[] yDot);
}
