package org.mechservice.view.mesh;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.view.scene.BodyPose;
import org.mechservice.view.scene.Point3;

/** Simple solids as surfaces; round ones have a fixed number of faces. */
public final class Solids {
  private static final int AROUND = 48;
  private static final int ALONG = 18;

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

  /** Returns a box about the origin with these edges, which are broken a little, m. */
  public static Mesh block(Point3 edges) {
    double[] half = {edges.x() / 2, edges.y() / 2, edges.z() / 2};
    double bevel = 0.08 * Math.min(half[0], Math.min(half[1], half[2]));
    // three corners for each of the box: corner 3 i + a lies on the face across axis a
    float[] corners = new float[72];
    for (int i = 0; i < 8; i++) {
      for (int face = 0; face < 3; face++) {
        for (int axis = 0; axis < 3; axis++) {
          double size = axis == face ? half[axis] : half[axis] - bevel;
          corners[3 * (3 * i + face) + axis] = (float) ((i >> axis & 1) == 0 ? -size : size);
        }
      }
    }
    List<Integer> triangles = new ArrayList<>();
    for (int axis = 0; axis < 3; axis++) {
      int u = (axis + 1) % 3;
      int v = (axis + 2) % 3;
      for (int side = 0; side < 2; side++) {
        int i = side << axis;
        quad(
            triangles,
            3 * i + axis,
            3 * (i | 1 << u) + axis,
            3 * (i | 1 << u | 1 << v) + axis,
            3 * (i | 1 << v) + axis);
      }
      for (int edge = 0; edge < 4; edge++) {
        int i = (edge & 1) << u | (edge >> 1) << v;
        int j = i | 1 << axis;
        quad(triangles, 3 * i + u, 3 * j + u, 3 * j + v, 3 * i + v);
      }
    }
    for (int i = 0; i < 8; i++) {
      triangles.addAll(List.of(3 * i, 3 * i + 1, 3 * i + 2));
    }
    return Mesh.of(corners, triangles.stream().mapToInt(Integer::intValue).toArray());
  }

  private static void quad(List<Integer> triangles, int a, int b, int c, int d) {
    triangles.addAll(List.of(a, b, c, a, c, d));
  }

  /** Returns the rubber of a tyre about the z axis, with round shoulders, m. */
  public static Mesh tyre(double radius, double width) {
    double h = width / 2;
    double inner = 0.64 * radius;
    double wall = radius - inner;
    List<double[]> outline = new ArrayList<>(List.of(new double[] {inner, -0.8 * h}));
    for (int i = 0; i <= 8; i++) {
      double angle = Math.PI * (i / 8.0 - 0.5);
      double across = Math.signum(Math.sin(angle)) * Math.pow(Math.abs(Math.sin(angle)), 0.7);
      double up = Math.pow(Math.abs(Math.cos(angle)), 0.5);
      outline.add(new double[] {radius - 0.45 * wall * (1 - up), h * across});
    }
    outline.add(new double[] {inner, 0.8 * h});
    outline.add(new double[] {inner, -0.8 * h});
    return turned(outline.toArray(new double[0][]));
  }

  /**
   * Returns a wheel with a groove along its rim about the z axis, m; the rope runs at the radius.
   */
  public static Mesh pulley(double radius, double width) {
    double h = width / 2;
    return turned(
        new double[][] {
          {0, -0.45 * h},
          {0.22 * radius, -0.45 * h},
          {0.22 * radius, -h},
          {0.3 * radius, -h},
          {0.3 * radius, -0.35 * h},
          {0.8 * radius, -0.35 * h},
          {0.84 * radius, -h},
          {1.08 * radius, -h},
          {radius, -0.35 * h},
          {radius, 0.35 * h},
          {1.08 * radius, h},
          {0.84 * radius, h},
          {0.8 * radius, 0.35 * h},
          {0.3 * radius, 0.35 * h},
          {0.3 * radius, h},
          {0.22 * radius, h},
          {0.22 * radius, 0.45 * h},
          {0, 0.45 * h}
        });
  }

  /**
   * Returns a spur gear about the z axis with the middle of a tooth on the x axis, m.
   *
   * @param radius of the pitch circle
   * @param teeth at least 6
   */
  public static Mesh gear(double radius, double width, int teeth) {
    double module = 2 * radius / teeth;
    return toothed(radius - 1.1 * module, radius + 0.9 * module, 0.25 * radius, width, teeth);
  }

  /** Returns a ring with teeth inside, the middle of one on the x axis, m. */
  public static Mesh ring(double radius, double width, int teeth) {
    double module = 2 * radius / teeth;
    return toothed(
        radius + 1.1 * module, radius - 0.9 * module, radius + 3.4 * module, width, teeth);
  }

  /**
   * @param root radius between the teeth
   * @param tip radius on them
   * @param plain radius of the other edge, which has no teeth
   */
  private static Mesh toothed(double root, double tip, double plain, double width, int teeth) {
    double[][] profile = {{root, -0.5}, {root, -0.27}, {tip, -0.13}, {tip, 0.13}, {root, 0.27}};
    int around = teeth * profile.length;
    float[] corners = new float[12 * around];
    List<Integer> faces = new ArrayList<>();
    for (int j = 0; j < around; j++) {
      double[] at = profile[j % profile.length];
      int tooth = j / profile.length;
      double angle = 2 * Math.PI * (tooth + at[1]) / teeth;
      double[] radii = {at[0], at[0], plain, plain};
      for (int k = 0; k < 4; k++) {
        int i = 3 * (4 * j + k);
        corners[i] = (float) (radii[k] * Math.cos(angle));
        corners[i + 1] = (float) (radii[k] * Math.sin(angle));
        corners[i + 2] = (float) (k % 2 == 0 ? -width / 2 : width / 2);
      }
      int a = 4 * j;
      int b = 4 * ((j + 1) % around);
      quad(faces, a, b, b + 1, a + 1);
      quad(faces, a + 2, a + 3, b + 3, b + 2);
      quad(faces, a, a + 2, b + 2, b);
      quad(faces, a + 1, b + 1, b + 3, a + 3);
    }
    return Mesh.of(corners, faces.stream().mapToInt(Integer::intValue).toArray());
  }

  /**
   * Returns a belt around two pulleys whose axes are along z, the first at the origin, the second
   * on the x axis, m.
   *
   * @param first radius of the first pulley
   * @param second radius of the second
   * @param distance of the axes, larger than the difference of the radii
   */
  public static Mesh belt(
      double first, double second, double distance, double width, double thickness) {
    double lean = Math.acos((first - second) / distance);
    List<double[]> middle = new ArrayList<>();
    for (int i = 0; i <= AROUND; i++) {
      double angle = lean + 2 * (Math.PI - lean) * i / AROUND;
      middle.add(new double[] {0, first, angle});
    }
    for (int i = 0; i <= AROUND; i++) {
      middle.add(new double[] {distance, second, -lean + 2 * lean * i / AROUND});
    }
    return band(
        middle.stream()
            .map(
                at -> {
                  double x = Math.cos(at[2]);
                  double y = Math.sin(at[2]);
                  return new double[] {
                    at[0] + at[1] * x,
                    at[1] * y,
                    at[0] + (at[1] + thickness) * x,
                    (at[1] + thickness) * y
                  };
                })
            .toList(),
        width,
        true);
  }

  /**
   * Returns a band between two outlines, as wide along z as it is said, m.
   *
   * @param sections of the outlines in order: x, y of the one, x, y of the other
   * @param closed whether the last section is before the first
   */
  private static Mesh band(List<double[]> sections, double width, boolean closed) {
    int count = sections.size();
    float[] corners = new float[12 * count];
    List<Integer> faces = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      double[] section = sections.get(i);
      for (int k = 0; k < 4; k++) {
        corners[12 * i + 3 * k] = (float) section[k < 2 ? 0 : 2];
        corners[12 * i + 3 * k + 1] = (float) section[k < 2 ? 1 : 3];
        corners[12 * i + 3 * k + 2] = (float) (k % 3 == 0 ? -width / 2 : width / 2);
      }
      if (i + 1 < count || closed) {
        int next = (i + 1) % count;
        for (int k = 0; k < 4; k++) {
          int l = (k + 1) % 4;
          quad(faces, 4 * i + k, 4 * next + k, 4 * next + l, 4 * i + l);
        }
      }
    }
    if (!closed) {
      int last = 4 * (count - 1);
      quad(faces, 0, 1, 2, 3);
      quad(faces, last + 3, last + 2, last + 1, last);
    }
    return Mesh.of(corners, faces.stream().mapToInt(Integer::intValue).toArray());
  }

  /**
   * Returns a road in the x-z plane: a sheet of a thickness below a line, as wide along y as it is
   * said, m.
   *
   * @param line x and z of its points, by growing x
   */
  public static Mesh road(List<double[]> line, double width, double thickness) {
    Mesh lying =
        band(
            line.stream().map(at -> new double[] {at[0], at[1], at[0], at[1] - thickness}).toList(),
            width,
            false);
    // from x, y across z to x, z across y
    double half = Math.sqrt(0.5);
    return lying.moved(new BodyPose(Point3.ZERO, half, half, 0, 0));
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
