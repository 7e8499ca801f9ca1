package org.mechservice.solver.oracle;

import org.mechservice.solver.spatial.Vector3;

/** A frame that moves: its origin and its axes, seen from another. */
public record TaylorPose(TaylorVector position, TaylorRotation rotation) {
  /** Returns where a point given in this frame is. */
  public TaylorVector at(Vector3 point) {
    return position.plus(rotation.apply(point));
  }

  public TaylorPose times(TaylorPose inner) {
    return new TaylorPose(
        position.plus(rotation.apply(inner.position)), rotation.times(inner.rotation));
  }

  public TaylorPose inverse() {
    return new TaylorPose(
        TaylorVector.ZERO.minus(rotation.applyTransposed(position)), rotation.transposed());
  }
}
