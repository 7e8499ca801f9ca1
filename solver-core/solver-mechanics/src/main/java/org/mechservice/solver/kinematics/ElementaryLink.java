package org.mechservice.solver.kinematics;

import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * One link of the chain of elementary links that replaces a joint.
 *
 * @param kind its elementary motion
 * @param position its first position among those of the joint
 * @param velocity its first velocity among those of the joint
 * @param axis unit vector in the axes of the side nearer the root; zero if there is none
 * @param pitch of a screw, m/rad
 * @param zeroRotation from the outer side's axes to the inner side's at zero
 * @param inverse whether Euler parameters turn the inner side relative to the outer
 */
record ElementaryLink(
    LinkKind kind,
    int position,
    int velocity,
    Vector3 axis,
    double pitch,
    Rotation zeroRotation,
    boolean inverse) {

  static ElementaryLink turn(int component, Vector3 axis, Rotation zeroRotation) {
    return new ElementaryLink(LinkKind.TURN, component, component, axis, 0, zeroRotation, false);
  }

  static ElementaryLink slide(int component, Vector3 axis, Rotation zeroRotation) {
    return slide(component, component, axis, zeroRotation);
  }

  static ElementaryLink slide(int position, int velocity, Vector3 axis, Rotation zeroRotation) {
    return new ElementaryLink(LinkKind.SLIDE, position, velocity, axis, 0, zeroRotation, false);
  }

  static ElementaryLink screw(Vector3 axis, double pitch, Rotation zeroRotation) {
    return new ElementaryLink(LinkKind.SCREW, 0, 0, axis, pitch, zeroRotation, false);
  }

  static ElementaryLink ball(boolean inverse) {
    return new ElementaryLink(LinkKind.BALL, 0, 0, Vector3.ZERO, 0, Rotation.IDENTITY, inverse);
  }

  static ElementaryLink fixed(Rotation zeroRotation) {
    return new ElementaryLink(LinkKind.FIXED, 0, 0, Vector3.ZERO, 0, zeroRotation, false);
  }
}
