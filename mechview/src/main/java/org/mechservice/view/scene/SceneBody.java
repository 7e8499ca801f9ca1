package org.mechservice.view.scene;

import java.util.List;

/**
 * A body of a picture.
 *
 * @param name name in the model file
 * @param pose where it is at the start
 * @param mass kg; 0 for a massless link
 * @param centreOfMass from the body's origin, in body axes, m
 * @param inertia about the centre of mass in body axes, kg·m²: xx, yy, zz, xy, xz, yz
 * @param geometry {@code graphSrc} of the model file: the name of a geometry file; empty if none is
 *     given
 * @param solids what it consists of; none if the model has its mass as numbers
 * @param looks what it is shown as in place of its solids
 */
public record SceneBody(
    String name,
    BodyPose pose,
    double mass,
    Point3 centreOfMass,
    List<Double> inertia,
    String geometry,
    List<SceneSolid> solids,
    List<SceneLook> looks) {
  public SceneBody {
    solids = List.copyOf(solids);
    looks = List.copyOf(looks);
    inertia = List.copyOf(inertia);
    if (inertia.size() != 6) {
      throw new IllegalArgumentException("inertia of body " + name + " needs 6 numbers");
    }
  }

  /** Describes a body that looks like what it consists of. */
  public SceneBody(
      String name,
      BodyPose pose,
      double mass,
      Point3 centreOfMass,
      List<Double> inertia,
      String geometry,
      List<SceneSolid> solids) {
    this(name, pose, mass, centreOfMass, inertia, geometry, solids, List.of());
  }

  /** Describes a body whose mass is given by numbers. */
  public SceneBody(
      String name,
      BodyPose pose,
      double mass,
      Point3 centreOfMass,
      List<Double> inertia,
      String geometry) {
    this(name, pose, mass, centreOfMass, inertia, geometry, List.of());
  }
}
