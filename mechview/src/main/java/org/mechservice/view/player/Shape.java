package org.mechservice.view.player;

import org.mechservice.view.mesh.Mesh;
import org.mechservice.view.scene.BodyPose;
import org.mechservice.view.scene.Point3;

/**
 * A surface in a place: many shapes may share one surface, and are then drawn at once.
 *
 * @param mesh the surface
 * @param at where its axes are in those of a body
 * @param scale by how much it is longer along each of its own axes
 */
record Shape(Mesh mesh, BodyPose at, Point3 scale) {
  private static final Point3 AS_IT_IS = new Point3(1, 1, 1);

  /** Returns a surface that is given in body axes. */
  static Shape of(Mesh mesh) {
    return new Shape(mesh, BodyPose.WORLD, AS_IT_IS);
  }

  /** Returns a surface in a place, as large as it is. */
  static Shape of(Mesh mesh, BodyPose at) {
    return new Shape(mesh, at, AS_IT_IS);
  }

  /** Returns the shape moved with the axes that it is in. */
  Shape moved(BodyPose pose) {
    return new Shape(mesh, pose.times(at), scale);
  }

  /** Returns the surface in body axes, m. */
  Mesh inBody() {
    return mesh.scaled(scale).moved(at);
  }
}
