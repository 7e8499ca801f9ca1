package org.mechservice.solver.kinematics.pair;

import static org.mechservice.solver.spatial.Blocks.apply;
import static org.mechservice.solver.spatial.Blocks.cross;
import static org.mechservice.solver.spatial.Blocks.dot;

import org.mechservice.solver.spatial.Vector3;

/**
 * β = x · R y of a vector x fixed in A and a vector y fixed in B, from which all angles are formed.
 */
final class AxisProduct {
  /** x and y. */
  final AxisPair axes;

  private final double[] x;
  private final double[] y;

  /** R y. */
  private final double[] carried = new double[3];

  /** ∂β/∂θ = (R y) × x. */
  final double[] gradient = new double[3];

  private double value;

  AxisProduct(Vector3 inA, Vector3 inB) {
    axes = new AxisPair(inA, inB);
    x = new double[] {inA.x(), inA.y(), inA.z()};
    y = new double[] {inB.x(), inB.y(), inB.z()};
  }

  double evaluate(RelativeMotion r) {
    apply(r.rotation, 0, y, 0, carried, 0);
    value = dot(x, 0, carried, 0);
    cross(carried, 0, x, 0, gradient, 0);
    return value;
  }

  /** Adds factor (R y xᵀ − β 1) to the angular block of a 6 × 6 matrix. */
  void addCurvature(double factor, double[] c) {
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        c[6 * i + j] += factor * carried[i] * x[j];
      }
      c[7 * i] -= factor * value;
    }
  }
}
