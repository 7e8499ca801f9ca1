package org.mechservice.library.proof;

/**
 * One or two bodies on parallel lines and a one-sided law between them: y = [x1, x2, v1, v2], or
 * with a fixed second one y = [x, v]. The distance is ρ = √(s² + e²), s = x1 - x2, and the depth R
 * - ρ of what pushes, ρ - R of what pulls.
 *
 * @param m1 mass of the first
 * @param m2 mass of the second; infinite: it is fixed at 0
 * @param acceleration of both bodies
 * @param offset e, of the lines
 * @param radius R
 * @param pulls whether the law acts beyond R
 * @param law the law
 * @param on whether it acts at all
 * @param fine a short step, s
 */
record LineHit(
    double m1,
    double m2,
    double acceleration,
    double offset,
    double radius,
    boolean pulls,
    Law law,
    boolean on,
    double fine)
    implements PlainSystem {
  private boolean alone() {
    return Double.isInfinite(m2);
  }

  @Override
  public int states() {
    return alone() ? 2 : 4;
  }

  private double apart(double[] y) {
    return alone() ? y[0] : y[0] - y[1];
  }

  private double speed(double[] y) {
    return alone() ? y[1] : y[2] - y[3];
  }

  private double sign() {
    return pulls ? -1 : 1;
  }

  private double distance(double s) {
    return Math.hypot(s, offset);
  }

  private double depth(double[] y) {
    return sign() * (radius - distance(apart(y)));
  }

  private double rate(double[] y) {
    double s = apart(y);
    return -sign() * s / distance(s) * speed(y);
  }

  @Override
  public void rates(double t, double[] y, boolean[] above, double[] rates) {
    double s = apart(y);
    double force =
        on ? sign() * law.force(depth(y), rate(y), above) * (s == 0 ? 0 : s / distance(s)) : 0;
    if (alone()) {
      rates[0] = y[1];
      rates[1] = acceleration + force / m1;
    } else {
      rates[0] = y[2];
      rates[1] = y[3];
      rates[2] = acceleration + force / m1;
      rates[3] = acceleration - force / m2;
    }
  }

  @Override
  public int margins() {
    return on ? law.margins() : 0;
  }

  @Override
  public double margin(int i, double t, double[] y) {
    return law.margin(i, depth(y), rate(y));
  }

  @Override
  public double clear(double t, double[] y) {
    double gap = -depth(y);
    double pull = alone() ? Math.abs(acceleration) : 0;
    return on
        ? gap <= 0 ? 0 : gap / (2 * (Math.abs(speed(y)) + Math.sqrt(pull * gap)) + 1e-300)
        : 1e6 * fine;
  }
}
