package org.mechservice.solver.kinematics.pair;

import java.util.Arrays;
import java.util.List;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * 2 N / D with N a sum of products of axes and D = 1 + such a sum: 2 tan(φ/2) times a direction. It
 * is zero only if the axes agree, and grows without bound towards half a turn; near zero it equals
 * the small angle.
 */
final class Tilt extends PairFunction {
  private final AxisProduct[] above;
  private final double[] sign;
  private final AxisProduct[] below;
  private final double[] ofAbove = new double[3];
  private final double[] ofBelow = new double[3];
  private final LargeTilt large;
  private double value;
  private double denominator;

  private Tilt(
      String label, AxisProduct[] above, double[] sign, AxisProduct[] below, LargeTilt large) {
    super(label);
    this.above = above;
    this.sign = sign;
    this.below = below;
    this.large = large;
  }

  /**
   * Returns the tilt of an axis of B from one of A, in the direction of a normal of the latter.
   *
   * @param axisA unit vector in A's axes
   * @param normal unit vector normal to it, in A's axes
   * @param axisB unit vector in B's axes
   */
  static Tilt ofAxis(String label, Vector3 axisA, Vector3 normal, Vector3 axisB) {
    return new Tilt(
        label,
        new AxisProduct[] {new AxisProduct(normal, axisB)},
        new double[] {1},
        new AxisProduct[] {new AxisProduct(axisA, axisB)},
        new LargeTilt.OfAxis(axisA, normal, axisB));
  }

  /**
   * Returns the rotation of B about an axis of a frame common to both at zero: 2 tan(φ/2) u · k for
   * a rotation by φ about u.
   *
   * @param frame right-handed axes in A's axes
   * @param k the axis among them
   * @param toB rotation from A's axes to B's at zero
   */
  static Tilt ofFrame(String label, Vector3[] frame, int k, Rotation toB) {
    Vector3[] a = {frame[k], frame[(k + 1) % 3], frame[(k + 2) % 3]};
    Vector3[] b = {toB.apply(a[0]), toB.apply(a[1]), toB.apply(a[2])};
    // with D_ij = a_i · R b_j: 2 (D_32 − D_23) / (1 + D_11 + D_22 + D_33)
    return new Tilt(
        label,
        new AxisProduct[] {new AxisProduct(a[2], b[1]), new AxisProduct(a[1], b[2])},
        new double[] {1, -1},
        new AxisProduct[] {
          new AxisProduct(a[0], b[0]), new AxisProduct(a[1], b[1]), new AxisProduct(a[2], b[2])
        },
        new LargeTilt.OfFrame(a[0], toB));
  }

  @Override
  public <T> T as(PairForms<T> forms) {
    return forms.tilt(axes(above), Arrays.stream(sign).boxed().toList(), axes(below));
  }

  private static List<AxisPair> axes(AxisProduct[] products) {
    return Arrays.stream(products).map(product -> product.axes).toList();
  }

  @Override
  public boolean isLength() {
    return false;
  }

  @Override
  public double evaluate(RelativeMotion r) {
    double numerator = 0;
    denominator = 1;
    for (int k = 0; k < above.length; k++) {
      numerator += sign[k] * above[k].evaluate(r);
    }
    for (AxisProduct product : below) {
      denominator += product.evaluate(r);
    }
    value = 2 * numerator / denominator;
    for (int i = 0; i < 3; i++) {
      ofAbove[i] = 0;
      ofBelow[i] = 0;
      for (int k = 0; k < above.length; k++) {
        ofAbove[i] += sign[k] * above[k].gradient[i];
      }
      for (AxisProduct product : below) {
        ofBelow[i] += product.gradient[i];
      }
      gradient[i] = (2 * ofAbove[i] - value * ofBelow[i]) / denominator;
    }
    return value;
  }

  /** {@inheritDoc} It is φ in place of 2 tan(φ/2). */
  @Override
  public double evaluateFar(RelativeMotion r) {
    return large.evaluate(r, gradient);
  }

  /** [2 ∂²N − f ∂²D − ∂D ∇fᵀ − ∇f ∂Dᵀ] / D. */
  @Override
  public void addCurvature(RelativeMotion r, double factor, double[] c) {
    double scale = factor / denominator;
    for (int k = 0; k < above.length; k++) {
      above[k].addCurvature(2 * scale * sign[k], c);
    }
    for (AxisProduct product : below) {
      product.addCurvature(-value * scale, c);
    }
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        c[6 * i + j] -= scale * (ofBelow[i] * gradient[j] + gradient[i] * ofBelow[j]);
      }
    }
  }
}
