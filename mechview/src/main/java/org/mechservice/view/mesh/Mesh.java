package org.mechservice.view.mesh;

import org.mechservice.view.scene.BodyPose;
import org.mechservice.view.scene.Point3;

/** Triangles of one colour. Never changes. */
public final class Mesh {
  /** Stands for a colour that the surface does not have of its own. */
  public static final int NO_COLOUR = -1;

  private final float[] corners;
  private final int[] triangles;
  private final int colour;
  private final double opacity;

  private Mesh(float[] corners, int[] triangles, int colour, double opacity) {
    this.corners = corners;
    this.triangles = triangles;
    this.colour = colour;
    this.opacity = opacity;
  }

  /**
   * Makes a surface without a colour of its own.
   *
   * @param corners x, y, z of each corner, m; kept, not copied
   * @param triangles three indices of corners each; kept, not copied
   * @throws IllegalArgumentException if a triangle names a corner that is not there
   */
  public static Mesh of(float[] corners, int[] triangles) {
    for (int corner : triangles) {
      if (corner < 0 || corner >= corners.length / 3) {
        throw new IllegalArgumentException(
            "a triangle names corner " + corner + " of " + corners.length / 3);
      }
    }
    return new Mesh(corners, triangles, NO_COLOUR, 1);
  }

  /** Returns the same surface in a colour, 0xRRGGBB. */
  public Mesh coloured(int rgb, double newOpacity) {
    return new Mesh(corners, triangles, rgb, newOpacity);
  }

  /** Returns the surface turned and displaced: from the axes it is in to those of the pose. */
  public Mesh moved(BodyPose pose) {
    float[] moved = new float[corners.length];
    for (int i = 0; i < corners.length; i += 3) {
      Point3 to = pose.toWorld(new Point3(corners[i], corners[i + 1], corners[i + 2]));
      moved[i] = (float) to.x();
      moved[i + 1] = (float) to.y();
      moved[i + 2] = (float) to.z();
    }
    return new Mesh(moved, triangles, colour, opacity);
  }

  /** Returns the surface with each coordinate larger or smaller by its own factor. */
  public Mesh scaled(Point3 factors) {
    double[] factor = {factors.x(), factors.y(), factors.z()};
    float[] scaled = new float[corners.length];
    for (int i = 0; i < corners.length; i++) {
      scaled[i] = (float) (factor[i % 3] * corners[i]);
    }
    return new Mesh(scaled, triangles, colour, opacity);
  }

  /** Returns the number of corners. */
  public int cornerCount() {
    return corners.length / 3;
  }

  /** Returns the number of triangles. */
  public int triangleCount() {
    return triangles.length / 3;
  }

  /** Returns x, y, z of each corner, m. */
  public float[] corners() {
    return corners.clone();
  }

  /** Returns three indices of corners per triangle. */
  public int[] triangles() {
    return triangles.clone();
  }

  /** Returns the colour 0xRRGGBB, or {@link #NO_COLOUR}. */
  public int colour() {
    return colour;
  }

  /** Returns 1 for an opaque surface, 0 for one that is not seen. */
  public double opacity() {
    return opacity;
  }
}
