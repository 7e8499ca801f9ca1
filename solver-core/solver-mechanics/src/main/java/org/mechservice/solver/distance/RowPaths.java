package org.mechservice.solver.distance;

import java.util.List;

/** How well the rows of a run tell what lies between them. */
public final class RowPaths {
  private RowPaths() {}

  /**
   * Returns by how much the curves through every second row miss the places of a body B in the axes
   * of a body A at the rows between. Curves through all rows miss the motion by less: by a
   * sixteenth where it is smooth. What a place is missed by is linear in it, so the corners of a
   * box about B are missed most.
   *
   * @param times of the rows, s, ascending
   * @param ofA poses of A at the rows, each the numbers of {@code BodyPoses}
   * @param ofB of B
   * @param partsB the parts of B, in its axes
   */
  public static double missed(
      double[] times, double[][] ofA, double[][] ofB, List<SolidPart> partsB) {
    RelativePath path = new RelativePath();
    double[] corners = box(partsB);
    double[] told = new double[corners.length];
    double[] there = new double[corners.length];
    double most = 0;
    for (int row = 1; row + 1 < times.length; row += 2) {
      double span = times[row + 1] - times[row - 1];
      if (!(span > 0)) {
        continue; // rows before and after an event
      }
      path.between(
          new double[][] {ofA[row - 1], ofA[row + 1]},
          new double[][] {ofB[row - 1], ofB[row + 1]},
          span);
      path.places((times[row] - times[row - 1]) / span, corners, told);
      path.between(new double[][] {ofA[row], ofA[row]}, new double[][] {ofB[row], ofB[row]}, 0);
      path.places(0, corners, there);
      for (int p = 0; p < corners.length; p += 3) {
        double square = 0;
        for (int i = p; i < p + 3; i++) {
          square += (told[i] - there[i]) * (told[i] - there[i]);
        }
        most = Math.max(most, Math.sqrt(square));
      }
    }
    return most;
  }

  /** Returns the corners of a box about parts. */
  private static double[] box(List<SolidPart> parts) {
    double[] least = new double[3];
    double[] greatest = new double[3];
    for (int i = 0; i < 3; i++) {
      int axis = i;
      least[i] = parts.stream().mapToDouble(p -> p.centre()[axis] - p.radius()).min().orElse(0);
      greatest[i] = parts.stream().mapToDouble(p -> p.centre()[axis] + p.radius()).max().orElse(0);
    }
    double[] corners = new double[24];
    for (int i = 0; i < corners.length; i++) {
      int axis = i % 3;
      int side = ((i / 3) >> axis) & 1;
      corners[i] = side == 0 ? least[axis] : greatest[axis];
    }
    return corners;
  }
}
