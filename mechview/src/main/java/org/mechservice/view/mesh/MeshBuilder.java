package org.mechservice.view.mesh;

import java.util.Arrays;

/** A surface while it grows; its size is bounded. */
final class MeshBuilder {
  /** Triangles that one geometry file may have. */
  static final int MOST_TRIANGLES = 1_000_000;

  private float[] corners = new float[96];
  private int[] triangles = new int[96];
  private int cornerNumbers;
  private int triangleNumbers;

  /** Adds a corner and returns its index. */
  int corner(double x, double y, double z) throws MeshException {
    if (!Double.isFinite(x) || !Double.isFinite(y) || !Double.isFinite(z)) {
      throw new MeshException("a corner is at (" + x + ", " + y + ", " + z + ")");
    }
    if (cornerNumbers + 3 > corners.length) {
      corners = Arrays.copyOf(corners, 2 * corners.length);
    }
    corners[cornerNumbers] = (float) x;
    corners[cornerNumbers + 1] = (float) y;
    corners[cornerNumbers + 2] = (float) z;
    cornerNumbers += 3;
    return cornerNumbers / 3 - 1;
  }

  /** Adds a triangle between corners. */
  void triangle(long a, long b, long c) throws MeshException {
    requireCorner(a);
    requireCorner(b);
    requireCorner(c);
    if (triangleNumbers == 3 * MOST_TRIANGLES) {
      throw new MeshException(
          "it has more than " + MOST_TRIANGLES + " triangles; simplify the surface");
    }
    if (triangleNumbers + 3 > triangles.length) {
      triangles = Arrays.copyOf(triangles, 2 * triangles.length);
    }
    triangles[triangleNumbers] = (int) a;
    triangles[triangleNumbers + 1] = (int) b;
    triangles[triangleNumbers + 2] = (int) c;
    triangleNumbers += 3;
  }

  private void requireCorner(long index) throws MeshException {
    if (index < 0 || index >= cornerNumbers / 3) {
      throw new MeshException(
          "a face names corner " + index + ", and there are " + cornerNumbers / 3);
    }
  }

  /** Adds a polygon as triangles that share its first corner. */
  void polygon(long[] around, int count) throws MeshException {
    for (int i = 2; i < count; i++) {
      triangle(around[0], around[i - 1], around[i]);
    }
  }

  Mesh mesh() {
    return Mesh.of(
        Arrays.copyOf(corners, cornerNumbers), Arrays.copyOf(triangles, triangleNumbers));
  }
}
