package org.mechservice.mechml;

import org.mechservice.solver.spatial.Vector3;

/**
 * A homogeneous solid of a body, as its file has it: what gives a part of the mass is also what the
 * body looks like. Places are from the body's origin in body axes, lengths in m.
 */
public sealed interface Solid {
  /**
   * A box with its edges along the body axes.
   *
   * @param center its centre, m
   * @param edges their lengths, positive, m
   */
  record Block(Vector3 center, Vector3 edges) implements Solid {}

  /**
   * A sphere.
   *
   * @param center its centre, m
   * @param radius positive, m
   */
  record Ball(Vector3 center, double radius) implements Solid {}

  /**
   * A cylinder, a tube or a frustum of a cone.
   *
   * @param from the centre of one end, m
   * @param to the centre of the other end, another place, m
   * @param radius outside at {@code from}, positive, m
   * @param top radius outside at {@code to}, m; 0 at the tip of a cone
   * @param inner radius of the bore; 0 without one, m
   */
  record Round(Vector3 from, Vector3 to, double radius, double top, double inner)
      implements Solid {}

  /**
   * A closed surface from a file.
   *
   * @param file its name, as the model has it
   * @param scale length of the surface's unit, m
   * @param origin where its origin is, m; its axes are the body's
   */
  record Surface(String file, double scale, Vector3 origin) implements Solid {}
}
