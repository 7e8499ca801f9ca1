package org.mechservice.view.mesh;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.view.scene.BodyPose;
import org.mechservice.view.scene.Point3;

/** Simple solids as surfaces; round ones have a fixed number of faces. */
public final class Solids {
  private static final int AROUND = 24;
  private static final int ALONG = 12;

  private Solids() {}

  /** Returns a box about the origin, edges along the axes, with these lengths, m. */
  public static Mesh box(double x, double y, double z) {
    float[] corners = new float[24];
    for (int i = 0; i < 8; i++) {
      corners[3 * i] = (float) ((i & 1) == 0 ? -x / 2 : x / 2);
      corners[3 * i + 1] = (float) ((i & 2) == 0 ? -y / 2 : y / 2);
      corners[3 * i + 2] = (float) ((i & 4) == 0 ? -z / 2 : z / 2);
    }
    return Mesh.of(
        corners,
        new int[] {
          0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2,
          1, 3, 7, 1, 7, 5
        });
  }

  /** Returns a sphere about the origin, radius in m. */
  public static Mesh sphere(double radius) {
    double[][] outline = new double[ALONG + 1][];
    for (int i = 0; i <= ALONG; i++) {
      double angle = Math.PI * i / ALONG;
      outline[i] = new double[] {radius * Math.sin(angle), -radius * Math.cos(angle)};
    }
    return turned(outline);
  }

  /** Returns a closed cylinder about the z axis from −height/2 to height/2, m. */
  public static Mesh cylinder(double radius, double height) {
    double h = height / 2;
    return turned(new double[][] {{0, -h}, {radius, -h}, {radius, h}, {0, h}});
  }

  /**
   * Returns a closed frustum of a cone about the z axis, m.
   *
   * @param radius at −height/2
   * @param top radius at height/2; 0 for a tip
   */
  public static Mesh frustum(double radius, double top, double height) {
    double h = height / 2;
    return turned(new double[][] {{0, -h}, {radius, -h}, {top, h}, {0, h}});
  }

  /** Returns a closed cone about the z axis, base at −height/2, tip at height/2, m. */
  public static Mesh cone(double radius, double height) {
    double h = height / 2;
    return turned(new double[][] {{0, -h}, {radius, -h}, {0, h}});
  }

  /** Returns a closed tube about the z axis from −height/2 to height/2, m. */
  public static Mesh tube(double inner, double outer, double height) {
    double h = height / 2;
    return turned(new double[][] {{inner, -h}, {outer, -h}, {outer, h}, {inner, h}, {inner, -h}});
  }

  /** Returns a cylinder between two points; empty if they coincide. */
  public static List<Mesh> rod(Point3 from, Point3 to, double radius) {
    Point3 along = to.minus(from);
    double length = along.norm();
    if (!(length > 0)) {
      return List.of();
    }
    Point3 middle = from.plus(to).times(0.5);
    return List.of(cylinder(radius, length).moved(zAlong(along.times(1 / length), middle)));
  }

  /**
   * Returns a pose whose z axis has a direction.
   *
   * @param direction unit vector
   */
  public static BodyPose zAlong(Point3 direction, Point3 origin) {
    Point3 side =
        Math.abs(direction.x()) < 0.6
            ? new Point3(1, 0, 0).cross(direction)
            : new Point3(0, 1, 0).cross(direction);
    Point3 x = side.times(1 / side.norm());
    Point3 y = direction.cross(x);
    double[] columns = {
      x.x(), y.x(), direction.x(), x.y(), y.y(), direction.y(), x.z(), y.z(), direction.z()
    };
    return BodyPose.of(origin, columns, 0);
  }

  /** Turns an outline about the z axis; rows are radius and height, m. */
  private static Mesh turned(double[][] outline) {
    float[] corners = new float[3 * outline.length * AROUND];
    List<Integer> faces = new ArrayList<>();
    for (int i = 0; i < outline.length; i++) {
      for (int j = 0; j < AROUND; j++) {
        double angle = 2 * Math.PI * j / AROUND;
        int at = 3 * (i * AROUND + j);
        corners[at] = (float) (outline[i][0] * Math.cos(angle));
        corners[at + 1] = (float) (outline[i][0] * Math.sin(angle));
        corners[at + 2] = (float) outline[i][1];
        if (i > 0) {
          int next = (j + 1) % AROUND;
          int a = (i - 1) * AROUND + j;
          int b = (i - 1) * AROUND + next;
          int c = i * AROUND + next;
          int d = i * AROUND + j;
          if (outline[i - 1][0] > 0) {
            faces.addAll(List.of(a, b, c));
          }
          if (outline[i][0] > 0) {
            faces.addAll(List.of(a, c, d));
          }
        }
      }
    }
    return Mesh.of(corners, faces.stream().mapToInt(Integer::intValue).toArray());
  }
}
