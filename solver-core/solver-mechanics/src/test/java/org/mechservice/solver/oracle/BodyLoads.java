package org.mechservice.solver.oracle;

import java.util.function.IntFunction;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.spatial.Vector3;

/** Sums forces about the centres of mass, six numbers per body: force, moment. */
final class BodyLoads implements OracleForce.Loads {
  final double[] sum;
  private final Mechanism mechanism;
  private final IntFunction<TaylorPose> pose;

  BodyLoads(Mechanism mechanism, IntFunction<TaylorPose> pose) {
    this.mechanism = mechanism;
    this.pose = pose;
    sum = new double[6 * mechanism.bodies().size()];
  }

  @Override
  public void force(BodyPoint point, Vector3 force) {
    if (point.body() == BodyPoint.ROOT) {
      return;
    }
    Vector3 center = mechanism.bodies().get(point.body()).centerOfMass();
    Vector3 lever =
        pose.apply(point.body()).rotation().value().apply(point.position().minus(center));
    add(6 * point.body(), force);
    add(6 * point.body() + 3, lever.cross(force));
  }

  @Override
  public void moment(int body, Vector3 moment) {
    if (body != BodyPoint.ROOT) {
      add(6 * body + 3, moment);
    }
  }

  private void add(int at, Vector3 v) {
    sum[at] += v.x();
    sum[at + 1] += v.y();
    sum[at + 2] += v.z();
  }
}
