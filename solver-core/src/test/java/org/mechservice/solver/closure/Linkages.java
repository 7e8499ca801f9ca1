package org.mechservice.solver.closure;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.mechanism.Attachment;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Joint;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Origin;
import org.mechservice.solver.mechanism.Prismatic;
import org.mechservice.solver.mechanism.Revolute;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.StartRole;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/** Small mechanisms with loops. */
final class Linkages {
  static final Vector3 X = new Vector3(1, 0, 0);
  static final Vector3 Y = new Vector3(0, 1, 0);
  static final Vector3 Z = new Vector3(0, 0, 1);
  static final Root GROUND = new Root("ground", Vector3.ZERO, Rotation.IDENTITY);

  private Linkages() {}

  /** Joins bodies, joints that may all move at the start, and closures, in gravity along −z. */
  static Mechanism mechanism(
      String name, List<Body> bodies, List<Joint> joints, List<LoopClosure> closures) {
    return new Mechanism(
        name,
        GROUND,
        Z.times(-9.81),
        bodies,
        joints,
        List.of(),
        Collections.nCopies(joints.size(), StartRole.PREFERRED),
        closures,
        List.of(),
        List.of());
  }

  /** A point mass on two crossed slides, held at a distance of 1 m from the origin. */
  static Mechanism slidingPendulum(double rodMass) {
    List<Body> bodies =
        List.of(
            new Body("slide", 0, Vector3.ZERO, InertiaTensor.ZERO, Origin.NONE),
            new Body("mass", 1, Vector3.ZERO, InertiaTensor.ZERO, Origin.NONE));
    List<Joint> joints = new ArrayList<>();
    joints.add(new Prismatic("x", between(BodyPoint.ROOT, 0), X, 1, 0, Origin.NONE));
    joints.add(new Prismatic("z", between(0, 1), Z, 0, 0, Origin.NONE));
    LoopClosure rod =
        new DistanceClosure(
            "rod",
            new BodyPoint(BodyPoint.ROOT, Vector3.ZERO),
            new BodyPoint(1, Vector3.ZERO),
            1,
            rodMass,
            Origin.NONE);
    return mechanism("sliding pendulum", bodies, joints, List.of(rod));
  }

  private static Attachment between(int parent, int child) {
    return new Attachment(parent, Vector3.ZERO, child, Vector3.ZERO, Rotation.IDENTITY);
  }

  static Revolute revolute(
      String name, int parent, Vector3 parentPoint, int child, Vector3 childPoint) {
    return new Revolute(
        name,
        new Attachment(parent, parentPoint, child, childPoint, Rotation.IDENTITY),
        Y.negated(),
        0,
        0,
        Origin.NONE);
  }
}
