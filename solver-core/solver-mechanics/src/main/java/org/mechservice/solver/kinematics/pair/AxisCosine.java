package org.mechservice.solver.kinematics.pair;

import org.mechservice.solver.spatial.Blocks;
import org.mechservice.solver.spatial.Vector3;

/** The cosine of the angle between an axis of A and one of B, less a constant. */
final class AxisCosine extends PairFunction {
  private final AxisProduct product;
  private final double atZero;

  /** The axis about which axes that are parallel are turned apart. */
  private final double[] anyNormal;

  AxisCosine(String label, Vector3 inA, Vector3 inB, double atZero) {
    super(label);
    product = new AxisProduct(inA, inB);
    this.atZero = atZero;
    Vector3 normal = JointFunctions.normalTo(inA);
    anyNormal = new double[] {normal.x(), normal.y(), normal.z()};
  }

  @Override
  public <T> T as(PairForms<T> forms) {
    return forms.axisCosine(product.axes, atZero);
  }

  @Override
  public boolean isLength() {
    return false;
  }

  @Override
  public double evaluate(RelativeMotion r) {
    double value = product.evaluate(r) - atZero;
    System.arraycopy(product.gradient, 0, gradient, 0, 3);
    return value;
  }

  /** {@inheritDoc} It is the sine of the constant angle times the angle that is missing. */
  @Override
  public double evaluateFar(RelativeMotion r) {
    double cosine = product.evaluate(r);
    double[] g = product.gradient;
    double sine = Math.sqrt(Blocks.dot(g, 0, g, 0));
    double sineAtZero = Math.sqrt((1 - atZero) * (1 + atZero));
    for (int i = 0; i < 3; i++) {
      gradient[i] = sineAtZero * (sine > 0 ? g[i] / sine : anyNormal[i]);
    }
    return sineAtZero * (StrictMath.acos(atZero) - StrictMath.atan2(sine, cosine));
  }

  @Override
  public void addCurvature(RelativeMotion r, double factor, double[] c) {
    product.addCurvature(factor, c);
  }
}
