package org.mechservice.solver.links;

import java.util.List;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.kinematics.LinkKind;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * An elementary link with all bodies welded to it, in computing frames.
 *
 * <p>The computing frame of a link has its origin at the joint's point on it and its z axis along
 * the joint. At q = 0 it is at {@code offset} in the parent's computing frame, rotated by {@code
 * axes}; the link rotates about z or slides along z. The frame of a link with Euler parameters has
 * the link's own axes, and {@code axes} leads from the parent link's own axes to the parent's
 * computing axes. The root's computing frame is its body frame.
 *
 * @param parent index of the parent; {@link Links#ROOT} for the root
 * @param kind its elementary motion
 * @param joint index of the joint in the mechanism
 * @param stateJoint index of the joint among those that have states; −1 for a driven joint
 * @param component its first velocity among those of the joint
 * @param position index of the link's first coordinate in the state [q; v]; −1 for a driven link
 * @param velocity index of its first velocity in the state [q; v]; −1 for a driven link
 * @param motion its coordinate, or four Euler parameters of unit length, as functions of time if it
 *     is driven; otherwise empty
 * @param way displacement along z per coordinate: 1 for a slide, the pitch of a screw in m/rad,
 *     otherwise 0
 * @param inverse whether Euler parameters turn the parent relative to the link
 * @param offset from the parent's computing origin to the joint's point, in parent computing axes,
 *     m
 * @param axes from this link's computing axes to the parent's at q = 0
 * @param frame from the link's own axes to its computing axes
 * @param zeroRotation from the link's own axes to those of the parent at q = 0
 * @param axis the joint's unit vector in the link's own axes
 * @param mass kg
 * @param centerOfMass from the computing origin, in computing axes, m
 * @param inertia about the centre of mass, in computing axes, kg·m²
 * @param armature inertia of its own of each of its velocities, kg·m² or kg
 * @param initialPosition the coordinate at the start, rad or m; 0 for Euler parameters
 * @param bodyLabel identifier of the link in programs
 * @param jointLabel identifier of its coordinate in programs
 * @param title body, joint and type as named in the file, for comments
 */
public record Link(
    int parent,
    LinkKind kind,
    int joint,
    int stateJoint,
    int component,
    int position,
    int velocity,
    List<Expression> motion,
    double way,
    boolean inverse,
    Vector3 offset,
    AxesChange axes,
    Rotation frame,
    Rotation zeroRotation,
    Vector3 axis,
    double mass,
    Vector3 centerOfMass,
    InertiaTensor inertia,
    double armature,
    double initialPosition,
    String bodyLabel,
    String jointLabel,
    String title) {

  public Link {
    motion = List.copyOf(motion);
  }

  /** Returns whether the link rotates about z, possibly also sliding along it. */
  public boolean turns() {
    return kind == LinkKind.TURN || kind == LinkKind.SCREW;
  }

  /** Returns whether the link slides along z, possibly also rotating about it. */
  public boolean slides() {
    return way != 0;
  }

  /** Returns whether Euler parameters give the link's rotation. */
  public boolean isBall() {
    return kind == LinkKind.BALL;
  }

  /** Returns whether the link's coordinate is a function of time. */
  public boolean isDriven() {
    return !motion.isEmpty();
  }

  /** Returns whether a constant rotation other than a permutation of axes precedes the joint. */
  public boolean hasConstantTurn() {
    return !axes.isPermutation();
  }

  /** Returns the link with additional mass fixed in it. */
  public Link carrying(RigidGroups.MassProperties more) {
    RigidGroups.MassProperties all =
        new RigidGroups.MassProperties(mass, centerOfMass, inertia).plus(more);
    return new Link(
        parent,
        kind,
        joint,
        stateJoint,
        component,
        position,
        velocity,
        motion,
        way,
        inverse,
        offset,
        axes,
        frame,
        zeroRotation,
        axis,
        all.mass(),
        all.center(),
        all.inertia(),
        armature,
        initialPosition,
        bodyLabel,
        jointLabel,
        title);
  }

  /** Returns the link's own tensor of inertia about its computing origin, kg·m². */
  public InertiaTensor inertiaAtOrigin() {
    return RigidGroups.about(mass, centerOfMass, inertia);
  }
}
