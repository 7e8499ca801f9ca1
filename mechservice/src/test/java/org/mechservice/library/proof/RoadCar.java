package org.mechservice.library.proof;

import java.util.List;
import java.util.function.DoubleUnaryOperator;

/**
 * A quarter of a car on a road: y = [x, z, l, u, v, w], the place along the road, the height of the
 * wheel's centre, the length of the suspension less its free one, and their rates. The wheel is a
 * sphere that touches the road at the station s whose point is closest to its centre, (s - x) +
 * (h(s) - z) h'(s) = 0. There the road pushes along its normal with k d + c d', d the radius less
 * the distance.
 *
 * @param wheel mass of the wheel
 * @param body mass above the suspension
 * @param carried mass that moves along the road; infinite: x is driven
 * @param stiffness of the suspension
 * @param damping of the suspension
 * @param radius of the wheel
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
    double radius,
    Law law,
    DoubleUnaryOperator height,
    DoubleUnaryOperator slope,
    List<Double> corners,
    boolean on,
    double fine)
    implements PlainSystem {
  static final double G = 9.81;

  @Override
  public int states() {
    return 6;
  }

  private double last() {
    return corners.get(corners.size() - 1);
  }

  private double h(double x) {
    return on ? height.applyAsDouble(x) : 0;
  }

  private double dh(double x) {
    return on ? slope.applyAsDouble(x) : 0;
  }

  /** Returns the station of the closest point, by Newton's method from below the centre. */
  private double station(double[] y) {
    double s = y[0];
    if (!on) {
      return s;
    }
    for (int k = 0; k < 60; k++) {
      double above = h(s) - y[1];
      double slope = dh(s);
      double near = 1e-6 * (last() - corners.get(0));
      double bend = (dh(s + near) - dh(s - near)) / (2 * near);
      double change = (s - y[0] + above * slope) / (1 + slope * slope + above * bend);
      s -= change;
      // the next change would be far smaller, since each gains four digits at least
      if (Math.abs(change) < 1e-12 * (1 + Math.abs(s))) {
        break;
      }
    }
    return s;
  }

  private double depth(double[] y, double s) {
    double slope = dh(s);
    double distance = ((y[1] - h(s)) - slope * (y[0] - s)) / Math.hypot(1, slope);
    return radius - distance;
  }

  private double rate(double[] y, double s) {
    double slope = dh(s);
    return (slope * y[3] - y[4]) / Math.hypot(1, slope);
  }

  @Override
  public void rates(double t, double[] y, boolean[] above, double[] rates) {
    double s = station(y);
    double slope = dh(s);
    double push = law.force(depth(y, s), rate(y, s), above) / Math.hypot(1, slope);
    double strut = -stiffness * y[2] - damping * y[5];
    double up = (push - strut) / wheel - G;
    rates[0] = y[3];
    rates[1] = y[4];
    rates[2] = y[5];
    rates[3] = Double.isInfinite(carried) ? 0 : -push * slope / carried;
    rates[4] = up;
    rates[5] = strut / body - G - up;
  }

  @Override
  public int margins() {
    return law.margins() + (on ? corners.size() : 0);
  }

  @Override
  public double margin(int i, double t, double[] y) {
    double s = station(y);
    return i < law.margins()
        ? law.margin(i, depth(y, s), rate(y, s))
        : s - corners.get(i - law.margins());
  }

  @Override
  public double clear(double t, double[] y) {
    double depth = Math.abs(depth(y, station(y)));
    double pull = (law.k() * depth + stiffness * Math.abs(y[2]) + damping * Math.abs(y[5])) / wheel;
    double clear = depth / (4 * (Math.abs(y[4]) + Math.sqrt((pull + G) * depth) + 1e-12));
    if (on && y[0] < last() + radius) {
      double way = corners.get(0) - radius - y[0];
      clear = Math.min(clear, way <= 0 ? 0 : way / (2 * Math.abs(y[3])));
    }
    return clear;
  }
}
