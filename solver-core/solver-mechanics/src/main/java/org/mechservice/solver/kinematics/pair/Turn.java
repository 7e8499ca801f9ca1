package org.mechservice.solver.kinematics.pair;

/**
 * The angle whose sine and cosine are in the ratio of two products of axes, from −π to π; its
 * gradient and curvature do not depend on whole turns.
 */
final class Turn extends PairFunction {
  private final AxisProduct sine;
  private final AxisProduct cosine;
  private final double sense;
  private double s;
  private double c;

  /**
   * @param sense 1, or −1 for the opposite angle
   */
  Turn(String label, AxisProduct sine, AxisProduct cosine, double sense) {
    super(label);
    this.sine = sine;
    this.cosine = cosine;
    this.sense = sense;
  }

  @Override
  public <T> T as(PairForms<T> forms) {
    return forms.turn(sine.axes, cosine.axes, sense);
  }

  @Override
  public boolean isLength() {
    return false;
  }

  @Override
  public double evaluate(RelativeMotion r) {
    s = sine.evaluate(r);
    c = cosine.evaluate(r);
    double scale = sense / (s * s + c * c);
    for (int i = 0; i < 3; i++) {
      gradient[i] = scale * (c * sine.gradient[i] - s * cosine.gradient[i]);
    }
    return sense * StrictMath.atan2(s, c);
  }

  /**
   * {@inheritDoc} Where both products vanish, because the axes of the bodies are normal to each
   * other, there is no angle: the gradient, which is bounded, is zero there, and the other
   * functions of the joint bring the axes together first.
   */
  @Override
  public double evaluateFar(RelativeMotion r) {
    s = sine.evaluate(r);
    c = cosine.evaluate(r);
    double length = Math.hypot(s, c);
    for (int i = 0; i < 3; i++) {
      gradient[i] =
          length > 0 ? sense * (c * sine.gradient[i] - s * cosine.gradient[i]) / length : 0;
    }
    return sense * StrictMath.atan2(s, c);
  }

  @Override
  public double difference(double value, double wanted) {
    double difference = value - wanted;
    return difference - 2 * Math.PI * Math.rint(difference / (2 * Math.PI));
  }

  /** [c ∂²s − s ∂²c + ∂s ∂cᵀ − ∂c ∂sᵀ − ∇φ (2 s ∂s + 2 c ∂c)ᵀ] / (s² + c²). */
  @Override
  public void addCurvature(RelativeMotion r, double factor, double[] out) {
    double perSquare = 1 / (s * s + c * c);
    double scale = sense * factor * perSquare;
    sine.addCurvature(scale * c, out);
    cosine.addCurvature(-scale * s, out);
    for (int i = 0; i < 3; i++) {
      double ofSine = sine.gradient[i];
      double ofCosine = cosine.gradient[i];
      for (int j = 0; j < 3; j++) {
        double squared = 2 * (s * sine.gradient[j] + c * cosine.gradient[j]);
        out[6 * i + j] +=
            scale * (ofSine * cosine.gradient[j] - ofCosine * sine.gradient[j])
                - factor * perSquare * gradient[i] * squared;
      }
    }
  }
}
