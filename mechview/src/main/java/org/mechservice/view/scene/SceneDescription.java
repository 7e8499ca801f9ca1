package org.mechservice.view.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * A mechanism at the start of its run, with closed loops.
 *
 * @param name the model's name
 * @param rootName name of the body at rest
 * @param root where the body at rest is
 * @param rootGeometry {@code graphSrc} of the body at rest; empty if none is given
 * @param rootSolids what the body at rest consists of
 * @param rootLooks what the body at rest is shown as in place of these
 * @param gravity acceleration of free fall in world axes, m/s²
 * @param bodies the moving bodies in file order
 * @param joints joints of the tree in file order, then cut joints in file order
 * @param constraints what closes loops besides cut joints, in file order
 * @param forces what is applied besides gravity, in file order
 * @param gears wheels that couplings of joints stand for
 * @param belts over pulleys that couplings of joints stand for
 * @param ropes the ways of ropes, cables and muscles
 * @param roads surfaces whose height changes
 * @param verdict what {@code mech check} says of the model
 */
public record SceneDescription(
    String name,
    String rootName,
    BodyPose root,
    String rootGeometry,
    List<SceneSolid> rootSolids,
    List<SceneLook> rootLooks,
    Point3 gravity,
    List<SceneBody> bodies,
    List<SceneJoint> joints,
    List<SceneConstraint> constraints,
    List<SceneForce> forces,
    List<SceneGear> gears,
    List<SceneBelt> belts,
    List<SceneRope> ropes,
    List<SceneRoad> roads,
    SceneVerdict verdict) {
  public SceneDescription {
    gears = List.copyOf(gears);
    belts = List.copyOf(belts);
    ropes = List.copyOf(ropes);
    roads = List.copyOf(roads);
    rootSolids = List.copyOf(rootSolids);
    rootLooks = List.copyOf(rootLooks);
    bodies = List.copyOf(bodies);
    joints = List.copyOf(joints);
    constraints = List.copyOf(constraints);
    forces = List.copyOf(forces);
  }

  /**
   * Describes a mechanism without gears, ropes and roads whose body at rest looks like what it
   * consists of.
   */
  public SceneDescription(
      String name,
      String rootName,
      BodyPose root,
      String rootGeometry,
      List<SceneSolid> rootSolids,
      Point3 gravity,
      List<SceneBody> bodies,
      List<SceneJoint> joints,
      List<SceneConstraint> constraints,
      List<SceneForce> forces,
      SceneVerdict verdict) {
    this(
        name,
        rootName,
        root,
        rootGeometry,
        rootSolids,
        List.of(),
        gravity,
        bodies,
        joints,
        constraints,
        forces,
        List.of(),
        List.of(),
        List.of(),
        List.of(),
        verdict);
  }

  /** Returns where a body is at the start. */
  public BodyPose pose(int body) {
    return body == Anchor.ROOT ? root : bodies.get(body).pose();
  }

  /** Returns where an anchor is at the start, from the world's origin in world axes, m. */
  public Point3 world(Anchor anchor) {
    return pose(anchor.body()).toWorld(anchor.point());
  }

  /** Returns the rope with a name, if there is one. */
  public Optional<SceneRope> rope(String name) {
    return ropes.stream().filter(rope -> rope.name().equals(name)).findFirst();
  }

  /** Returns the name of a body or of the root. */
  public String bodyName(int body) {
    return body == Anchor.ROOT ? rootName : bodies.get(body).name();
  }

  /**
   * Returns the points at the start between which the whole mechanism lies: the points of joints,
   * constraints and forces, corners of boxes in contact, and centres of mass; in world axes, m.
   * Never empty.
   */
  public List<Point3> extent() {
    List<Point3> points = new ArrayList<>();
    for (SceneJoint joint : joints) {
      points.add(world(joint.first()));
      points.add(world(joint.second()));
    }
    constraints.forEach(one -> one.anchors().forEach(anchor -> points.add(world(anchor))));
    forces.forEach(one -> one.anchors().forEach(anchor -> points.add(world(anchor))));
    for (SceneForce force : forces) {
      int body = force.anchors().isEmpty() ? Anchor.ROOT : force.anchors().get(0).body();
      force.box().stream()
          .flatMap(box -> box.corners().stream())
          .forEach(corner -> points.add(world(new Anchor(body, corner))));
    }
    for (SceneBody body : bodies) {
      if (body.mass() > 0) {
        points.add(body.pose().toWorld(body.centreOfMass()));
      }
    }
    if (points.isEmpty()) {
      points.add(root.position());
    }
    return points;
  }
}
