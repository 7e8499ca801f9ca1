package org.mechservice.library.proof;

import java.util.function.DoubleUnaryOperator;

/**
 * A quarter of a car on a road: y = [x, z, s, u, v, w], the place along the road, the height of the
 * wheel above its place on the flat road, the length of the suspension less its free one, and their
 * rates. The wheel is a point; the road pushes it up with k d + c d', d = h(x) - z, where that is
 * positive, and back with that times h'(x).
 *
 * @param wheel mass of the wheel
 * @param body mass above the suspension
 * @param carried mass that moves along the road; infinite: x is driven
 * @param stiffness of the suspension
 * @param damping of the suspension
 * @param law of the contact
 * @param height h
 * @param slope h'
 * @param corners places between which the road is smooth, ascending
 * @param on whether there is a bump
 * @param fine a short step, s
 */
record RoadCar(
    double wheel,
    double body,
    double carried,
    double stiffness,
    double damping,
    Law law,
    DoubleUnaryOperator height,
    DoubleUnaryOperator slope,
    double[] corners,
    boolean on,
    double fine)
    implements PlainSystem {
  static final double G = 9.81;

  @Override
  public int states() {
    return 6;
  }

  private double h(double x) {
    return on ? height.applyAsDouble(x) : 0;
  }

  private double dh(double x) {
    return on ? slope.applyAsDouble(x) : 0;
  }

  private double depth(double[] y) {
    return h(y[0]) - y[1];
  }

  private double rate(double[] y) {
    return dh(y[0]) * y[3] - y[4];
  }

  @Override
  public void rates(double t, double[] y, boolean[] above, double[] rates) {
    double push = law.force(depth(y), rate(y), above);
    double strut = -stiffness * y[2] - damping * y[5];
    double up = (push - strut) / wheel - G;
    rates[0] = y[3];
    rates[1] = y[4];
    rates[2] = y[5];
    rates[3] = Double.isInfinite(carried) ? 0 : -push * dh(y[0]) / carried;
    rates[4] = up;
    rates[5] = strut / body - G - up;
  }

  @Override
  public int margins() {
    return law.margins() + (on ? corners.length : 0);
  }

  @Override
  public double margin(int i, double t, double[] y) {
    return i < law.margins() ? law.margin(i, depth(y), rate(y)) : y[0] - corners[i - law.margins()];
  }

  @Override
  public double clear(double t, double[] y) {
    double depth = Math.abs(depth(y));
    double pull = (law.k() * depth + stiffness * Math.abs(y[2]) + damping * Math.abs(y[5])) / wheel;
    double clear = depth / (4 * (Math.abs(y[4]) + Math.sqrt((pull + G) * depth) + 1e-12));
    if (on && y[0] < corners[corners.length - 1]) {
      double way = corners[0] - y[0];
      clear = Math.min(clear, way <= 0 ? 0 : way / (2 * Math.abs(y[3])));
    }
    return clear;
  }
}
