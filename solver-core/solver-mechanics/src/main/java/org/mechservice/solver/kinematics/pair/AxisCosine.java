package org.mechservice.solver.kinematics.pair;

import org.mechservice.solver.spatial.Vector3;

/** The cosine of the angle between an axis of A and one of B, less a constant. */
final class AxisCosine extends PairFunction {
  private final AxisProduct product;
  private final double atZero;

  AxisCosine(String label, Vector3 inA, Vector3 inB, double atZero) {
    super(label);
    product = new AxisProduct(inA, inB);
    this.atZero = atZero;
  }

  @Override
  public <T> T as(PairForms<T> forms) {
    return forms.axisCosine(product.axes, atZero);
  }

  @Override
  public double evaluate(RelativeMotion r) {
    double value = product.evaluate(r) - atZero;
    System.arraycopy(product.gradient, 0, gradient, 0, 3);
    return value;
  }

  @Override
  public void addCurvature(RelativeMotion r, double factor, double[] c) {
    product.addCurvature(factor, c);
  }
}
