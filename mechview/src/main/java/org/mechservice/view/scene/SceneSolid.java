package org.mechservice.view.scene;

/**
 * A solid that a body consists of, in body axes, m.
 *
 * <p>Pictures show a body by its solids where the model has them.
 */
public sealed interface SceneSolid {
  /**
   * A box with its edges along the body axes.
   *
   * @param center its centre
   * @param edges their lengths
   */
  record Block(Point3 center, Point3 edges) implements SceneSolid {}

  /**
   * A sphere.
   *
   * @param center its centre
   * @param radius its radius
   */
  record Ball(Point3 center, double radius) implements SceneSolid {}

  /**
   * A cylinder, a tube or a frustum of a cone.
   *
   * @param from the centre of one end
   * @param to the centre of the other end
   * @param radius outside at {@code from}
   * @param top radius outside at {@code to}; 0 at a tip
   * @param inner radius of the bore; 0 without one
   */
  record Round(Point3 from, Point3 to, double radius, double top, double inner)
      implements SceneSolid {}

  /**
   * A closed surface from a file.
   *
   * @param file its name, as the model has it
   * @param scale length of the surface's unit
   * @param origin where its origin is
   */
  record Surface(String file, double scale, Point3 origin) implements SceneSolid {}
}
