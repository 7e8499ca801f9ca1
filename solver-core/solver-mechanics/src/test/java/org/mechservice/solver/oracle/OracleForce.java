package org.mechservice.solver.oracle;

import java.util.function.IntFunction;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.spatial.Vector3;

/** A force between bodies, written down a second time for the oracle. */
public interface OracleForce {
  /**
   * Adds its forces.
   *
   * @param pose pose and motion of each body, and of the root at −1, in the world
   */
  public void apply(double t, IntFunction<TaylorPose> pose, Loads loads);

  /** Takes forces and moments, in world axes. */
  interface Loads {
    /** Adds a force at a point of a body. */
    void force(BodyPoint point, Vector3 force);

    /** Adds a moment to a body. */
    void moment(int body, Vector3 moment);
  }
}
