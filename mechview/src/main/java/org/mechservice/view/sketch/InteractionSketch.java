package org.mechservice.view.sketch;

import java.awt.geom.Path2D;
import java.util.List;
import java.util.Locale;
import org.mechservice.solver.api.JointType;
import org.mechservice.view.drawing.Canvas;
import org.mechservice.view.drawing.Ink;
import org.mechservice.view.drawing.Pen;
import org.mechservice.view.scene.Anchor;
import org.mechservice.view.scene.Point3;
import org.mechservice.view.scene.RopeWay;
import org.mechservice.view.scene.SceneConstraint;
import org.mechservice.view.scene.SceneDescription;
import org.mechservice.view.scene.SceneForce;
import org.mechservice.view.scene.SceneJoint;
import org.mechservice.view.scene.SceneRope;

/**
 * Draws what acts between bodies beside their joints: constraints and forces, each by its symbol
 * and with its name.
 */
final class InteractionSketch {
  private static final Ink FORCE = MechanismPicture.FORCE;
  private static final Ink CONSTRAINT = MechanismPicture.CONSTRAINT;

  private final SceneDescription scene;
  private final SceneLayout layout;
  private final Canvas canvas;
  private final JointSymbols joints;
  private final ForceSymbols forces;
  private final NamePlaces names;
  private final double size;

  /**
   * @param size of symbols, 1 being the usual one
   */
  InteractionSketch(
      SceneDescription scene, SceneLayout layout, Canvas canvas, NamePlaces names, double size) {
    this.scene = scene;
    this.layout = layout;
    this.canvas = canvas;
    this.names = names;
    this.size = size;
    joints = new JointSymbols(canvas, size);
    forces = new ForceSymbols(canvas, size);
  }

  /** Draws a constraint with its name. */
  void constraint(SceneConstraint constraint) {
    String kind = constraint.kind().name().toLowerCase(Locale.ROOT).replace('_', ' ');
    canvas.part(kind + " " + constraint.name(), () -> constraintLines(constraint));
  }

  private void constraintLines(SceneConstraint constraint) {
    switch (constraint.kind()) {
      case DISTANCE, ROD -> {
        Place from = layout.place(constraint.anchors().get(0));
        Place to = layout.place(constraint.anchors().get(1));
        forces.rod(from, to, constraint.kind() == SceneConstraint.Kind.ROD, CONSTRAINT);
        names.avoid(from.to(to));
        nameBetween(constraint.name(), CONSTRAINT, from, to);
      }
      case COUPLING -> {
        if (scene.rope(constraint.name()).isPresent()) {
          rope(constraint.name(), constraint.anchors(), CONSTRAINT);
          return;
        }
        List<Place> coupled = coupled(constraint);
        for (int i = 1; i < coupled.size(); i++) {
          forces.dashed(coupled.get(i - 1), coupled.get(i), CONSTRAINT);
        }
        if (coupled.size() > 1) {
          nameBetween(constraint.name(), CONSTRAINT, coupled.get(0), coupled.get(1));
        } else if (!coupled.isEmpty()) {
          names.name(constraint.name(), CONSTRAINT, false, coupled, 16);
        }
      }
      case POINT_ON_LINE -> {
        Place point = layout.place(constraint.anchors().get(0));
        Place along = layout.direction(turned(constraint)).unit();
        Place from = point.minus(along.times(50));
        Place to = point.plus(along.times(50));
        forces.dashed(from, to, CONSTRAINT);
        names.avoid(from.to(to));
        joints.draw(JointType.P, point, along, along, CONSTRAINT);
        forces.dot(point, CONSTRAINT);
        names.keepFree(point, joints.reach());
        names.name(constraint.name(), CONSTRAINT, false, List.of(point), 14);
      }
      case ROLLING -> {
        Place centre = layout.place(constraint.anchors().get(0));
        canvas.draw(
            rim(constraint.anchors().get(0), constraint.wheel().orElseThrow()),
            new Pen(CONSTRAINT, 1.6));
        forces.dot(centre, CONSTRAINT);
        names.name(constraint.name(), CONSTRAINT, false, List.of(centre), 14);
      }
      case KNIFE_EDGE -> {
        Place point = layout.place(constraint.anchors().get(0));
        Point3 side = scene.pose(constraint.anchors().get(0).body()).turn(constraint.direction());
        Place across = layout.direction(side).times(30);
        canvas.draw(
            JointSymbols.polygon(point.minus(across), point.plus(across)),
            new Pen(CONSTRAINT, 1.6).dashed(1));
        forces.dot(point, CONSTRAINT);
        names.name(constraint.name(), CONSTRAINT, false, List.of(point), 14);
      }
      case POINT_ON_PLANE -> {
        Place point = layout.place(constraint.anchors().get(0));
        Point3 normal = turned(constraint);
        Point3 across = Math.abs(normal.x()) < 0.8 ? new Point3(1, 0, 0) : new Point3(0, 1, 0);
        Point3 one = normal.cross(across);
        Point3 unit = one.times(1 / one.norm());
        Place u = layout.direction(unit).times(42);
        Place v = layout.direction(normal.cross(unit)).times(42);
        canvas.draw(
            JointSymbols.polygon(
                point.plus(u).plus(v),
                point.plus(u).minus(v),
                point.minus(u).minus(v),
                point.minus(u).plus(v)),
            new Pen(CONSTRAINT, 1.2).dashed(1));
        forces.dot(point, CONSTRAINT);
        names.name(constraint.name(), CONSTRAINT, false, List.of(point), 14);
      }
    }
  }

  /** Returns the rim of a wheel, or the circle of a ball that faces the viewer. */
  private Path2D rim(Anchor centre, SceneConstraint.Wheel wheel) {
    Point3 axle =
        wheel.isBall()
            ? layout.projection().right().cross(layout.projection().up())
            : scene.pose(centre.body()).turn(wheel.axle());
    Point3 across = Math.abs(axle.x()) < 0.8 ? new Point3(1, 0, 0) : new Point3(0, 1, 0);
    Point3 first = axle.cross(across);
    Point3 u = first.times(wheel.radius() / first.norm());
    Point3 v = axle.cross(u);
    Point3 at = scene.world(centre);
    Place[] corners = new Place[48];
    for (int i = 0; i < corners.length; i++) {
      double angle = 2 * Math.PI * i / corners.length;
      corners[i] = layout.place(at.plus(u.times(Math.cos(angle))).plus(v.times(Math.sin(angle))));
    }
    return JointSymbols.polygon(corners);
  }

  private Point3 turned(SceneConstraint constraint) {
    return scene.pose(constraint.anchors().get(1).body()).turn(constraint.direction());
  }

  /** Returns the joints of a coupling, or what a rope passes. */
  private List<Place> coupled(SceneConstraint constraint) {
    if (!constraint.anchors().isEmpty()) {
      return constraint.anchors().stream().map(layout::place).toList();
    }
    return scene.joints().stream()
        .filter(joint -> constraint.joints().contains(joint.name()))
        .map(joint -> layout.place(joint.second()))
        .toList();
  }

  private void nameBetween(String name, Ink ink, Place from, Place to) {
    nameBetween(name, ink, from, to, 8);
  }

  private void nameBetween(String name, Ink ink, Place from, Place to, double distance) {
    Place along = to.minus(from);
    names.name(
        name,
        ink,
        false,
        List.of(
            from.plus(along.times(0.5)), from.plus(along.times(0.3)), from.plus(along.times(0.7))),
        distance);
  }

  /** Draws a force between bodies with its name. */
  void force(SceneForce force) {
    String kind = force.kind().name().toLowerCase(Locale.ROOT).replace('_', ' ');
    canvas.part(kind + " " + force.name(), () -> forceLines(force));
  }

  private void forceLines(SceneForce force) {
    List<Place> at = force.anchors().stream().map(layout::place).toList();
    switch (force.kind()) {
      case SPRING, DAMPER, SPRING_DAMPER -> {
        if (force.kind() == SceneForce.Kind.SPRING) {
          forces.spring(at.get(0), at.get(1), FORCE);
        } else if (force.kind() == SceneForce.Kind.DAMPER) {
          forces.damper(at.get(0), at.get(1), FORCE);
        } else {
          forces.springAndDamper(at.get(0), at.get(1), FORCE);
        }
        for (int end = 0; end < 2; end++) {
          if (Projection.isAtRest(force.anchors().get(end))) {
            Place outwards = at.get(end).minus(at.get(1 - end)).unit();
            joints.hatched(at.get(end), outwards.turned(), 10 * size, outwards);
          } else {
            forces.dot(at.get(end), FORCE);
          }
        }
        names.avoid(at.get(0).to(at.get(1)));
        nameBetween(
            force.name(),
            FORCE,
            at.get(0),
            at.get(1),
            force.kind() == SceneForce.Kind.SPRING_DAMPER ? 17 : 9);
      }
      case BUSHING -> {
        forces.bushing(at.get(0), at.get(1), FORCE);
        nameBetween(force.name(), FORCE, at.get(0), at.get(1));
      }
      case FORCE -> {
        Place along = layout.direction(force.direction());
        Place tip = at.get(0).plus(along.times(44));
        if (along.length() < 0.2) {
          forces.sphere(at.get(0), 6, FORCE);
          forces.dot(at.get(0), FORCE);
        } else {
          forces.arrow(at.get(0), tip, FORCE, 2);
        }
        names.avoid(at.get(0).to(tip));
        names.name(force.name(), FORCE, false, List.of(tip, at.get(0)), 7);
      }
      case MOMENT -> {
        forces.turningArrow(at.get(0), FORCE);
        names.name(force.name(), FORCE, false, List.of(at.get(0)), 17);
      }
      case CONTACT -> contact(force, at.get(0));
      case ROPE -> rope(force.name(), force.anchors(), FORCE);
      case COUPLING -> {
        for (int i = 1; i < at.size(); i++) {
          forces.dashed(at.get(i - 1), at.get(i), FORCE);
          names.avoid(at.get(i - 1).to(at.get(i)));
        }
        if (at.size() > 1) {
          nameBetween(force.name(), FORCE, at.get(0), at.get(1));
        }
      }
      default -> {
        at.forEach(point -> forces.dot(point, FORCE));
        if (at.size() == 2) {
          forces.dashed(at.get(0), at.get(1), FORCE);
          nameBetween(force.name(), FORCE, at.get(0), at.get(1));
        } else if (!at.isEmpty()) {
          names.name(force.name(), FORCE, false, List.of(at.get(at.size() - 1)), 8);
        }
      }
    }
  }

  /** Draws a rope as it lies on what it passes, with its name. */
  private void rope(String name, List<Anchor> anchors, Ink ink) {
    SceneRope rope = scene.rope(name).orElseGet(() -> SceneRope.straight(name, anchors));
    List<Place> longest = List.of();
    for (List<Point3> line : RopeWay.of(rope, scene::pose)) {
      List<Place> places = line.stream().map(layout::place).toList();
      for (int i = 1; i < places.size(); i++) {
        canvas.draw(JointSymbols.polygon(places.get(i - 1), places.get(i)), new Pen(ink, 1.6));
        names.avoid(places.get(i - 1).to(places.get(i)));
        if (longest.isEmpty()
            || places.get(i).minus(places.get(i - 1)).length()
                > longest.get(1).minus(longest.get(0)).length()) {
          longest = List.of(places.get(i - 1), places.get(i));
        }
      }
    }
    for (SceneRope.Stop stop : rope.stops()) {
      if (stop instanceof SceneRope.Pulley pulley) {
        Point3 normal =
            scene.pose(rope.plane().body()).turn(rope.plane().axes().turn(new Point3(0, 0, 1)));
        round(pulley.centre(), normal, pulley.radius(), ink);
      } else if (stop instanceof SceneRope.Around shape) {
        Point3 axis = scene.pose(shape.centre().body()).turn(shape.axis());
        round(shape.centre(), axis, shape.radius(), ink);
      } else if (stop instanceof SceneRope.Eye eye) {
        forces.dot(layout.place(eye.at()), ink);
      }
    }
    if (!longest.isEmpty()) {
      nameBetween(name, ink, longest.get(0), longest.get(1));
    }
  }

  /** Draws the circle of a pulley or a cylinder, or that of a sphere: its axis is zero. */
  private void round(Anchor centre, Point3 axis, double radius, Ink ink) {
    Point3 inBody = scene.pose(centre.body()).turnBack(axis);
    SceneConstraint.Wheel wheel = new SceneConstraint.Wheel(inBody, radius);
    canvas.draw(rim(centre, wheel), new Pen(ink, 1.2));
  }

  private void box(int body, List<Point3> corners) {
    List<Place> at =
        corners.stream().map(corner -> layout.place(new Anchor(body, corner))).toList();
    Path2D edges = new Path2D.Double();
    for (int corner = 0; corner < at.size(); corner++) {
      for (int axis = 1; axis < at.size(); axis *= 2) {
        if ((corner & axis) == 0) {
          edges.moveTo(at.get(corner).x(), at.get(corner).y());
          edges.lineTo(at.get(corner | axis).x(), at.get(corner | axis).y());
        }
      }
    }
    canvas.draw(edges, new Pen(FORCE, 1.2));
  }

  /** Draws the sphere, disc, wheel or box and the part of the surface beneath it. */
  private void contact(SceneForce force, Place centre) {
    double radius = force.radius() * layout.scale();
    if (force.isOfDisc() && radius > 1) {
      SceneConstraint.Wheel wheel = new SceneConstraint.Wheel(force.axle(), force.radius());
      canvas.draw(rim(force.anchors().get(0), wheel), new Pen(FORCE, 1.6));
      forces.dot(centre, FORCE);
    } else if (force.box().isPresent()) {
      box(force.anchors().get(0).body(), force.box().get().corners());
    } else if (radius > 1) {
      forces.sphere(centre, radius, FORCE);
    } else {
      forces.dot(centre, FORCE);
    }
    Point3 middle = scene.world(force.anchors().get(0));
    Point3 surface = scene.world(force.anchors().get(1));
    double height = middle.minus(surface).dot(force.direction());
    Place foot = layout.place(middle.minus(force.direction().times(height)));
    Place into = layout.direction(force.direction()).times(-1);
    if (into.length() > 0.35) {
      Place unit = into.unit();
      joints.hatched(foot, unit.turned(), Math.max(40, Math.min(90, radius)), unit);
    }
    names.name(force.name(), FORCE, false, List.of(foot, centre), 14);
  }

  /** Draws a force within a joint with its name. */
  void inJoint(SceneForce force) {
    SceneJoint joint =
        scene.joints().stream()
            .filter(one -> one.name().equals(force.joint()))
            .findFirst()
            .orElseThrow();
    Place first = layout.place(joint.first());
    Place at = layout.place(joint.second());
    boolean slides = MechanismPicture.slides(joint.type());
    String kind = force.kind().name().toLowerCase(Locale.ROOT).replace('_', ' ');
    canvas.part(
        kind + " " + force.name(),
        () -> {
          if (force.kind() == SceneForce.Kind.JOINT_SPRING) {
            if (slides && first.minus(at).length() > 20) {
              forces.spring(first, at, FORCE);
            } else {
              forces.spiral(at, FORCE);
            }
          } else if (force.kind() == SceneForce.Kind.JOINT_FORCE) {
            Place along = layout.direction(Projection.axis(scene, joint));
            if (slides && along.length() > 0.2) {
              Place from = at.plus(along.unit().turned().times(10 * size));
              forces.arrow(from, from.plus(along.times(34)), FORCE, 1.8);
            } else {
              forces.turningArrow(at, FORCE);
            }
          }
        });
    String friction = force.kind() == SceneForce.Kind.JOINT_FRICTION ? " (friction)" : "";
    names.name(force.name() + friction, FORCE, false, List.of(at), 18 * Math.max(1, size));
  }
}
