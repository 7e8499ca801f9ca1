package org.mechservice.solver.distance;

import java.util.ArrayList;
import java.util.List;

/** The triangles among the parts of a body: what they enclose, if they are closed. */
final class Surface {
  /** Directions of rays, along no edge that a drawing would have. */
  private static final double[][] RAYS = {
    {0.7548776662, 0.5698402910, 0.3247179572},
    {-0.6823278038, 0.6180339887, 0.3819660113},
    {0.2451223338, -0.4301597090, 0.8191725134}
  };

  /** Most places of a body that are looked at; parts of one surface lie on one side. */
  private static final int MOST_PLACES = 64;

  private final List<double[]> triangles = new ArrayList<>();

  Surface(List<SolidPart> parts) {
    for (SolidPart part : parts) {
      if (isTriangle(part)) {
        triangles.add(part.corners());
      }
    }
  }

  private static boolean isTriangle(SolidPart part) {
    return part.corners().length == 9;
  }

  boolean isEmpty() {
    return triangles.isEmpty();
  }

  /** Returns a place of each part of a body; of a surface some. */
  static List<double[]> places(List<SolidPart> parts) {
    List<double[]> places = new ArrayList<>();
    for (SolidPart part : parts) {
      if (!isTriangle(part) || places.size() < MOST_PLACES) {
        places.add(part.centre().clone());
      }
    }
    return places;
  }

  /** Returns whether a place is inside: rays from it cross the surface an odd number of times. */
  boolean encloses(double[] place) {
    for (double[] ray : RAYS) {
      int crossings = 0;
      for (double[] triangle : triangles) {
        crossings += crosses(place, ray, triangle) ? 1 : 0;
      }
      if (crossings % 2 == 0) {
        return false;
      }
    }
    return true;
  }

  /** Source: Moeller and Trumbore 1997. */
  private static boolean crosses(double[] from, double[] ray, double[] t) {
    double[] e = {t[3] - t[0], t[4] - t[1], t[5] - t[2]};
    double[] f = {t[6] - t[0], t[7] - t[1], t[8] - t[2]};
    double[] p = cross(ray, f);
    double determinant = dot(e, p);
    if (determinant == 0) {
      return false;
    }
    double[] s = {from[0] - t[0], from[1] - t[1], from[2] - t[2]};
    double u = dot(s, p) / determinant;
    double[] q = cross(s, e);
    double v = dot(ray, q) / determinant;
    return u >= 0 && v >= 0 && u + v <= 1 && dot(f, q) / determinant > 0;
  }

  private static double[] cross(double[] p, double[] q) {
    return new double[] {
      p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]
    };
  }

  private static double dot(double[] p, double[] q) {
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
  }
}
