package org.mechservice.solver.distance;

import org.mechservice.solver.api.capability.BodyPoses;

/** How well the rows of a run tell what lies between them. */
public final class RowPaths {
  private RowPaths() {}

  /**
   * Returns by how much the curves through every second row miss the places of a body at the rows
   * between. Curves through all rows miss the motion by less: by a sixteenth where it is smooth.
   *
   * @param times of the rows, s, ascending
   * @param poses of the body at the rows, each the numbers of {@code BodyPoses}
   * @param reach distance of its farthest point from its origin, m
   */
  public static double missed(double[] times, double[][] poses, double reach) {
    RelativePath path = new RelativePath();
    double[] world = new double[BodyPoses.NUMBERS_PER_BODY];
    world[3] = 1;
    double[] points = {0, 0, 0, reach, 0, 0, 0, reach, 0, 0, 0, reach};
    double[] told = new double[points.length];
    double[] there = new double[points.length];
    double most = 0;
    for (int row = 1; row + 1 < times.length; row += 2) {
      double[][] still = {world, world};
      double span = times[row + 1] - times[row - 1];
      if (!(span > 0)) {
        continue; // rows before and after an event
      }
      path.between(still, new double[][] {poses[row - 1], poses[row + 1]}, span);
      path.places((times[row] - times[row - 1]) / span, points, told);
      path.between(still, new double[][] {poses[row], poses[row]}, 0);
      path.places(0, points, there);
      for (int p = 0; p < points.length; p += 3) {
        double square = 0;
        for (int i = p; i < p + 3; i++) {
          square += (told[i] - there[i]) * (told[i] - there[i]);
        }
        most = Math.max(most, Math.sqrt(square));
      }
    }
    return most;
  }
}
