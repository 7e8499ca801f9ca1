package org.mechservice.solver.kinematics;

import static org.mechservice.solver.kinematics.ElementaryLink.ball;
import static org.mechservice.solver.kinematics.ElementaryLink.fixed;
import static org.mechservice.solver.kinematics.ElementaryLink.screw;
import static org.mechservice.solver.kinematics.ElementaryLink.slide;
import static org.mechservice.solver.kinematics.ElementaryLink.turn;

import java.util.List;
import org.mechservice.solver.mechanism.joint.Cylindrical;
import org.mechservice.solver.mechanism.joint.Free;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.Planar;
import org.mechservice.solver.mechanism.joint.Prismatic;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.mechanism.joint.Screw;
import org.mechservice.solver.mechanism.joint.Spherical;
import org.mechservice.solver.mechanism.joint.Universal;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * Decomposes joints into elementary links, from the parent to the child. A joint whose parent is
 * the file's body 2 is the reversed chain with every motion inverted. The joints are defined in
 * docs/mechml.md#joints.
 */
final class JointChain {
  private static final Vector3 X = new Vector3(1, 0, 0);
  private static final Vector3 Y = new Vector3(0, 1, 0);
  private static final Vector3 Z = new Vector3(0, 0, 1);

  private JointChain() {}

  /** Returns the links of a joint, at least one. */
  static List<ElementaryLink> of(Joint joint) {
    Rotation zero = joint.attachment().zeroRotation();
    return switch (joint.type()) {
      case R -> List.of(turn(0, ((Revolute) joint).axis(), zero));
      case P -> List.of(slide(0, ((Prismatic) joint).axis(), zero));
      case C -> cylindrical((Cylindrical) joint, zero);
      case U -> universal((Universal) joint, zero);
      case S -> List.of(ball(((Spherical) joint).fileBody2IsParent()));
      case PL -> planar((Planar) joint, zero);
      case H -> List.of(screw(((Screw) joint).axis(), ((Screw) joint).pitch(), zero));
      case F -> free((Free) joint);
      case W -> List.of(fixed(zero));
    };
  }

  private static List<ElementaryLink> cylindrical(Cylindrical joint, Rotation zero) {
    return List.of(slide(0, joint.axis(), Rotation.IDENTITY), turn(1, joint.axis(), zero));
  }

  /** A = Rot(a1, q1) A0 Rot(a2, q2); backwards Aᵀ = Rot(−a2, q2) A0ᵀ Rot(−a1, q1). */
  private static List<ElementaryLink> universal(Universal joint, Rotation zero) {
    return joint.fileBody2IsParent()
        ? List.of(
            turn(1, joint.axis2().negated(), zero),
            turn(0, joint.axis1().negated(), Rotation.IDENTITY))
        : List.of(turn(0, joint.axis1(), zero), turn(1, joint.axis2(), Rotation.IDENTITY));
  }

  /** r = q1 x + q2 y, A = Rot(n, q3) A0; backwards Aᵀ = Rot(−A0ᵀ n, q3) A0ᵀ, then −y, −x. */
  private static List<ElementaryLink> planar(Planar joint, Rotation zero) {
    Vector3 x = joint.direction();
    Vector3 y = joint.normal().cross(x);
    return joint.fileBody2IsParent()
        ? List.of(
            turn(2, zero.apply(joint.normal()).negated(), zero),
            slide(1, y.negated(), Rotation.IDENTITY),
            slide(0, x.negated(), Rotation.IDENTITY))
        : List.of(
            slide(0, x, Rotation.IDENTITY),
            slide(1, y, Rotation.IDENTITY),
            turn(2, joint.normal(), zero));
  }

  private static List<ElementaryLink> free(Free joint) {
    return joint.fileBody2IsParent()
        ? List.of(
            ball(true),
            slide(4, 3, X.negated(), Rotation.IDENTITY),
            slide(5, 4, Y.negated(), Rotation.IDENTITY),
            slide(6, 5, Z.negated(), Rotation.IDENTITY))
        : List.of(
            slide(4, 3, X, Rotation.IDENTITY),
            slide(5, 4, Y, Rotation.IDENTITY),
            slide(6, 5, Z, Rotation.IDENTITY),
            ball(false));
  }
}
