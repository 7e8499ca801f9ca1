package org.mechservice.solver.mechanism;

import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/**
 * A moving rigid body.
 *
 * @param name name in the model file
 * @param mass kg; 0 for a massless link
 * @param centerOfMass from the body's origin, in body axes, m
 * @param inertia about the centre of mass, in body axes, kg·m²
 * @param origin position in the model file
 */
public record Body(
    String name, double mass, Vector3 centerOfMass, InertiaTensor inertia, Origin origin) {

  /** Returns whether the body has neither mass nor inertia. */
  public boolean isMassless() {
    return mass == 0 && inertia.isZero();
  }
}
