package org.mechservice.benchmarks.study;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.mechservice.report.reference.ExtrapolationCode;
import org.mechservice.report.reference.Problem;
import org.mechservice.report.reference.RadauCode;
import org.mechservice.report.reference.ReferenceCode;
import org.mechservice.report.solution.Reference;
import org.mechservice.report.solution.StateDistance;

/**
 * The four-bar of {@code line_with_1e-12_to_spare.xml} along its own way: F(a, b) = 0 is a smooth
 * curve as long as the coupler is longer than the gap, so with its length σ in the angles' plane
 *
 * <p>a' = w T_a, b' = w T_b, w' = −(V_a T_a + V_b T_b) / I
 *
 * <p>with the unit tangent T and w = σ'. No coordinate has to be chosen as independent and no
 * equations of loops are solved, so a passage close to the singular position costs small steps and
 * nothing else. The formulations are not used.
 */
final class FourBarInLine implements Problem {
  private static final double GRAVITY = 9.81;
  private static final double GAP = 3;

  /** Of a bar of 1 kg and 1 m about its hinge, kg·m². */
  private static final double INERTIA = 1.0 / 3;

  private static final double RADAU_TOLERANCE = 1e-12;
  private static final double EXTRAPOLATION_TOLERANCE = 1e-13;

  /** Newton's steps onto the curve from a start near it. */
  private static final int CORRECTIONS = 6;

  private final double square;
  private double value;
  private double slopeA;
  private double slopeB;

  private FourBarInLine(double distance) {
    square = (GAP + distance) * (GAP + distance);
  }

  /**
   * Solves it with two codes.
   *
   * @param distance by which the coupler is longer than the gap, m
   * @param start state of the scene, [a, b, a', b'], at rest; not modified
   * @param seconds each code may take
   * @return empty if one of them does not solve it in its time
   */
  static Optional<Reference> reference(
      double distance, double[] start, double[] times, StateDistance measure, double seconds) {
    ReferenceCode collocation = new RadauCode(7);
    ReferenceCode extrapolation = new ExtrapolationCode(8);
    Optional<double[][]> first =
        solve(collocation, RADAU_TOLERANCE, distance, start, times, seconds);
    Optional<double[][]> second =
        solve(extrapolation, EXTRAPOLATION_TOLERANCE, distance, start, times, seconds);
    if (first.isEmpty() || second.isEmpty()) {
      return Optional.empty();
    }
    double[] floor = new double[times.length];
    double apart = 0;
    for (int i = 0; i < times.length; i++) {
      double here = measure.of(first.get()[i], second.get()[i]);
      apart = Math.max(apart, here);
      floor[i] = apart;
    }
    String said =
        String.format(
            Locale.ROOT,
            "Reference: %s along the curve of positions, checked by %s; they differ by %.1e.",
            collocation.name(),
            extrapolation.name(),
            apart);
    return Optional.of(
        new Reference(times, first.get(), floor, floor, Optional.empty(), List.of(said)));
  }

  private static Optional<double[][]> solve(
      ReferenceCode code,
      double tolerance,
      double distance,
      double[] start,
      double[] times,
      double seconds) {
    FourBarInLine bars = new FourBarInLine(distance);
    double[] y0 = {start[0], start[1], 0};
    for (int i = 0; i < CORRECTIONS; i++) {
      if (!bars.stepEnded(times[0], y0)) {
        return Optional.empty();
      }
    }
    long deadline = System.nanoTime() + (long) (seconds * TimeUnit.SECONDS.toNanos(1));
    return code.solve(bars, times, y0, tolerance, deadline).map(bars::states);
  }

  private double[][] states(double[][] along) {
    double[][] states = new double[along.length][];
    for (int i = 0; i < along.length; i++) {
      double[] y = along[i];
      place(y[0], y[1]);
      double size = Math.hypot(slopeA, slopeB);
      states[i] = new double[] {y[0], y[1], y[2] * slopeB / size, -y[2] * slopeA / size};
    }
    return states;
  }

  /** F = (|P₂ − P₁|² − L²) / 2 and its gradient; hinges turn about y, angles from the x axis. */
  private void place(double a, double b) {
    double x = GAP + Math.cos(b) - Math.cos(a);
    double z = Math.sin(a) - Math.sin(b);
    value = 0.5 * (x * x + z * z - square);
    slopeA = x * Math.sin(a) + z * Math.cos(a);
    slopeB = -x * Math.sin(b) - z * Math.cos(b);
  }

  @Override
  public int dimension() {
    return 3;
  }

  @Override
  public boolean derivative(double t, double[] y, double[] yDot) {
    place(y[0], y[1]);
    double size = Math.hypot(slopeA, slopeB);
    if (!(size > 0)) {
      return false;
    }
    double tangentA = slopeB / size;
    double tangentB = -slopeA / size;
    // V = −g/2 (sin a + sin b)
    double slope = -0.5 * GRAVITY * (Math.cos(y[0]) * tangentA + Math.cos(y[1]) * tangentB);
    yDot[0] = y[2] * tangentA;
    yDot[1] = y[2] * tangentB;
    yDot[2] = -slope / INERTIA;
    return true;
  }

  /** Moves a state back onto the curve. */
  @Override
  public boolean stepEnded(double t, double[] y) {
    place(y[0], y[1]);
    double square2 = slopeA * slopeA + slopeB * slopeB;
    if (!(square2 > 0)) {
      return false;
    }
    y[0] -= value * slopeA / square2;
    y[1] -= value * slopeB / square2;
    return true;
  }
}
