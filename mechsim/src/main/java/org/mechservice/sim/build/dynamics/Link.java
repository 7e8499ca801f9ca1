package org.mechservice.sim.build.dynamics;

import org.mechservice.solver.api.JointType;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * A body with the joint that leads to it, in computing frames.
 *
 * <p>The computing frame of a body has its origin at the joint's point on the body and its z axis
 * along the joint. With q = 0 it stands at {@code offset} in the parent's computing frame, turned
 * by {@code axes}; the joint then turns it about z or shifts it along z. The root's computing frame
 * is its body frame.
 *
 * @param parent index of the parent link; {@link Links#ROOT} for the root
 * @param body index of the body in the mechanism
 * @param joint index of the joint in the mechanism
 * @param type kind of the joint
 * @param position index of the joint's coordinate in the state [q; v]
 * @param velocity index of the joint's velocity in the state [q; v]
 * @param offset from the parent's computing origin to the joint's point, in parent computing axes,
 *     m
 * @param axes from this link's computing axes to the parent's at q = 0
 * @param fromBody from the body's own axes to its computing axes
 * @param zeroRotation from the body's own axes to its parent body's own axes at q = 0
 * @param axis the joint's unit vector in the body's own axes
 * @param bodyOrigin from the computing origin to the body's own origin, in computing axes, m
 * @param mass kg
 * @param centerOfMass from the computing origin, in computing axes, m
 * @param inertia about the centre of mass, in computing axes, kg·m²
 * @param initialPosition the joint's coordinate at the start, rad or m
 * @param bodyLabel identifier of the body in programs
 * @param jointLabel identifier of the joint in programs
 * @param title body, joint and type as the file names them, for people
 */
public record Link(
    int parent,
    int body,
    int joint,
    JointType type,
    int position,
    int velocity,
    Vector3 offset,
    AxesChange axes,
    Rotation fromBody,
    Rotation zeroRotation,
    Vector3 axis,
    Vector3 bodyOrigin,
    double mass,
    Vector3 centerOfMass,
    InertiaTensor inertia,
    double initialPosition,
    String bodyLabel,
    String jointLabel,
    String title) {

  /** Returns whether the joint turns; otherwise it slides. */
  boolean turns() {
    return type == JointType.R;
  }

  /** Returns whether a constant rotation by more than a change of axes lies before the joint. */
  public boolean hasConstantTurn() {
    return !axes.turns().isEmpty();
  }

  /** Returns the body's own inertia along the joint: about its axis, kg·m², or its mass, kg. */
  double ownInertia() {
    if (!turns()) {
      return mass;
    }
    double x = centerOfMass.x();
    double y = centerOfMass.y();
    return inertia.zz() + mass * (x * x + y * y);
  }
}
