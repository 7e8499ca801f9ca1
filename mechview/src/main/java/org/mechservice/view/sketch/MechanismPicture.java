package org.mechservice.view.sketch;

import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.mechservice.solver.api.JointType;
import org.mechservice.view.drawing.Canvas;
import org.mechservice.view.drawing.Ink;
import org.mechservice.view.drawing.Label;
import org.mechservice.view.drawing.Label.Anchoring;
import org.mechservice.view.drawing.Pen;
import org.mechservice.view.scene.Anchor;
import org.mechservice.view.scene.Point3;
import org.mechservice.view.scene.SceneBody;
import org.mechservice.view.scene.SceneConstraint;
import org.mechservice.view.scene.SceneDescription;
import org.mechservice.view.scene.SceneForce;
import org.mechservice.view.scene.SceneJoint;
import org.mechservice.view.scene.SceneVerdict;

/** Draws a mechanism at the start of its run. */
public final class MechanismPicture {
  private static final double WIDTH = 880;
  private static final double SIDE = 70;
  private static final double TOP = 76;
  private static final double LEAST_HEIGHT = 150;
  private static final double MOST_HEIGHT = 560;
  private static final double BELOW = 66;
  private static final double MARGIN = 16;
  private static final double FONT = 12;
  private static final double LINE = 17;
  private static final double BAR = 8;

  /** Bodies up to which frames and centres of mass are drawn. */
  private static final int FEW_BODIES = 20;

  /**
   * Bodies above which only some names are written, and symbols that lie on each other left out.
   */
  private static final int MANY = 60;

  /** Names of bodies in a drawing of many. */
  private static final int SOME_NAMES = 24;

  /** Size of symbols if everything is at one point. */
  private static final double ALONE = 1.8;

  /** Distance of joints at which symbols have their usual size, px. */
  private static final double ROOMY = 42;

  private static final Ink TREE = Ink.TEXT;
  private static final Ink CUT = Ink.CURVE_4;
  private static final Ink DRIVEN = Ink.CURVE_3;
  private static final Ink FORCE = Ink.CURVE_2;
  private static final Ink CONSTRAINT = Ink.CURVE_1;

  private final SceneDescription scene;
  private final Projection projection;
  private final double scale;
  private final double fieldHeight;
  private final Place origin;
  private final double size;
  private final Canvas canvas;
  private final JointSymbols joints;
  private final ForceSymbols forces;
  private final NamePlaces names;
  private final List<List<Place>> pointsOf = new ArrayList<>();
  private Place lastJoint = new Place(-1e9, 0);

  private MechanismPicture(SceneDescription scene, ViewPlane plane) {
    this.scene = scene;
    projection = Projection.of(plane, scene);
    List<Point3> extent = scene.extent();
    double left = Double.POSITIVE_INFINITY;
    double right = Double.NEGATIVE_INFINITY;
    double low = Double.POSITIVE_INFINITY;
    double high = Double.NEGATIVE_INFINITY;
    for (Point3 point : extent) {
      left = Math.min(left, projection.x(point));
      right = Math.max(right, projection.x(point));
      low = Math.min(low, projection.y(point));
      high = Math.max(high, projection.y(point));
    }
    for (SceneForce force : scene.forces()) {
      if (force.radius() > 0) {
        Point3 centre = scene.world(force.anchors().get(0));
        left = Math.min(left, projection.x(centre) - force.radius());
        right = Math.max(right, projection.x(centre) + force.radius());
        low = Math.min(low, projection.y(centre) - force.radius());
        high = Math.max(high, projection.y(centre) + force.radius());
      }
    }
    for (SceneConstraint constraint : scene.constraints()) {
      if (constraint.wheel().isPresent()) {
        Point3 centre = scene.world(constraint.anchors().get(0));
        double radius = constraint.wheel().get().radius();
        left = Math.min(left, projection.x(centre) - radius);
        right = Math.max(right, projection.x(centre) + radius);
        low = Math.min(low, projection.y(centre) - radius);
        high = Math.max(high, projection.y(centre) + radius);
      }
    }
    double w = right - left;
    double h = high - low;
    double room = WIDTH - 2 * SIDE;
    double unlimited = Math.max(w, h) > 0 ? Math.min(room / w, MOST_HEIGHT / h) : room / 4;
    scale = Double.isFinite(unlimited) ? unlimited : room / Math.max(w, h);
    fieldHeight = Math.max(LEAST_HEIGHT, h * scale);
    origin =
        new Place(
            WIDTH / 2 - scale * (left + right) / 2,
            TOP + fieldHeight / 2 + scale * (low + high) / 2);
    double least = scene.joints().size() > MANY ? 0.3 : 0.6;
    size = w + h > 0 ? Math.max(least, Math.min(1, typicalDistance() / ROOMY)) : ALONE;
    double legend = (LINE + 4) * legendRows().size() + (colourWords().isEmpty() ? 0 : LINE);
    canvas =
        new Canvas(
            WIDTH,
            TOP
                + fieldHeight
                + BELOW
                + legend
                + captions(0).size() * LINE
                + (isCrowded() ? LINE : 0),
            scene.name(),
            description());
    joints = new JointSymbols(canvas, size);
    forces = new ForceSymbols(canvas, size);
    names =
        new NamePlaces(
            new Rectangle2D.Double(4, TOP - 40, WIDTH - 8, fieldHeight + 40 + BELOW - 26));
    for (int body = 0; body < scene.bodies().size(); body++) {
      pointsOf.add(new ArrayList<>());
    }
  }

  /** Draws a mechanism. */
  public static Canvas draw(SceneDescription scene, ViewPlane plane) {
    return new MechanismPicture(scene, plane).picture();
  }

  /** Returns whether names may find no place. */
  private boolean isCrowded() {
    return scene.bodies().size() + scene.joints().size() > 20;
  }

  private Place place(Point3 point) {
    return new Place(
        origin.x() + scale * projection.x(point), origin.y() - scale * projection.y(point));
  }

  private Place place(Anchor anchor) {
    return place(scene.world(anchor));
  }

  /** Returns a unit direction as the drawing shows it, in px of a length of at most 1. */
  private Place direction(Point3 unit) {
    return new Place(projection.x(unit), -projection.y(unit));
  }

  private double typicalDistance() {
    List<Place> places = new ArrayList<>();
    for (SceneJoint joint : scene.joints()) {
      Place at = place(joint.second());
      if (places.size() < 500 && places.stream().noneMatch(p -> p.minus(at).length() < 3)) {
        places.add(at);
      }
    }
    double[] nearest = new double[places.size()];
    for (int i = 0; i < nearest.length; i++) {
      nearest[i] = Double.POSITIVE_INFINITY;
      for (int j = 0; j < nearest.length; j++) {
        if (j != i) {
          nearest[i] = Math.min(nearest[i], places.get(i).minus(places.get(j)).length());
        }
      }
    }
    Arrays.sort(nearest);
    return nearest.length < 2 ? ROOMY : nearest[nearest.length / 2];
  }

  private Canvas picture() {
    collectPoints();
    canvas.write(
        new Label(
                MARGIN,
                MARGIN + 12,
                Label.shortened(scene.name(), FONT + 2, 500),
                FONT + 2,
                Anchoring.START,
                Ink.TEXT)
            .inBold());
    gravity();
    for (int body = 0; body < scene.bodies().size(); body++) {
      body(body);
    }
    if (scene.bodies().size() <= FEW_BODIES) {
      scene.bodies().forEach(this::frame);
    }
    scene.constraints().forEach(this::constraint);
    scene.forces().stream().filter(force -> force.joint().isEmpty()).forEach(this::force);
    scene.joints().forEach(this::ground);
    scene.joints().forEach(this::joint);
    scene.forces().stream().filter(force -> !force.joint().isEmpty()).forEach(this::inJoint);
    nameAll();
    double below = TOP + fieldHeight + BELOW;
    names.keepFree(new Rectangle2D.Double(0, below - 72, MARGIN + 72, 72));
    names.keepFree(new Rectangle2D.Double(WIDTH - 170, below - 44, 170, 44));
    names.keepFree(new Rectangle2D.Double(WIDTH - 190, 0, 190, MARGIN + 36));
    names.write(canvas);
    axes(new Place(MARGIN + 30, below - 34));
    scaleBar(below - 22);
    double y = legend(below + 8);
    int unwanted =
        scene.bodies().size() > MANY
            ? scene.bodies().size() + scene.joints().size() - SOME_NAMES
            : 0;
    for (String line : captions(unwanted + names.unwritten())) {
      canvas.write(new Label(MARGIN, y, line, FONT, Anchoring.START, Ink.TEXT));
      y += LINE;
    }
    return canvas;
  }

  /** Gathers the points of each body between which it is drawn. */
  private void collectPoints() {
    for (SceneJoint joint : scene.joints()) {
      addPoint(joint.first());
      addPoint(joint.second());
    }
    scene.constraints().stream()
        .filter(one -> one.kind() != SceneConstraint.Kind.POINT_ON_PLANE)
        .filter(one -> one.kind() != SceneConstraint.Kind.ROLLING)
        .forEach(one -> one.anchors().forEach(this::addPoint));
    scene.forces().stream()
        .filter(one -> one.kind() != SceneForce.Kind.CONTACT)
        .forEach(one -> one.anchors().forEach(this::addPoint));
    for (int i = 0; i < scene.bodies().size(); i++) {
      SceneBody body = scene.bodies().get(i);
      if (body.mass() > 0) {
        addPoint(new Anchor(i, body.centreOfMass()));
      }
    }
  }

  private void addPoint(Anchor anchor) {
    if (!Projection.isAtRest(anchor)) {
      List<Place> points = pointsOf.get(anchor.body());
      Place at = place(anchor);
      if (points.stream().noneMatch(point -> point.minus(at).length() < 0.2)) {
        points.add(at);
      }
    }
  }

  private void body(int index) {
    SceneBody body = scene.bodies().get(index);
    List<Place> hull = hull(pointsOf.get(index));
    if (hull.isEmpty()) {
      return;
    }
    Ink ink = Ink.curve(index);
    Path2D outline = JointSymbols.polygon(hull.toArray(new Place[0]));
    canvas.part(
        "body " + body.name(),
        () -> {
          if (hull.size() > 2) {
            canvas.fill(outline, ink, 0.14);
          }
          if (hull.size() == 1) {
            forces.disc(hull.get(0), 2 * BAR * size, ink, 0.3);
          } else {
            canvas.draw(outline, new Pen(ink, Math.max(2, BAR * size), List.of(), 0.38));
          }
          if (body.mass() > 0 && scene.bodies().size() <= FEW_BODIES) {
            forces.centreOfMass(place(body.pose().toWorld(body.centreOfMass())), ink);
          }
        });
    if (body.mass() > 0 && scene.bodies().size() <= FEW_BODIES) {
      names.keepFree(place(body.pose().toWorld(body.centreOfMass())), 5);
    }
    for (int i = 0; i < hull.size() && scene.bodies().size() < 200; i++) {
      names.avoid(hull.get(i).to(hull.get((i + 1) % hull.size())));
    }
  }

  /** Returns the corners of the smallest convex area around points (Andrew 1979). */
  private static List<Place> hull(List<Place> points) {
    List<Place> sorted = new ArrayList<>(points);
    sorted.sort(Comparator.comparingDouble(Place::x).thenComparingDouble(Place::y));
    if (sorted.size() < 3) {
      return sorted;
    }
    List<Place> hull = new ArrayList<>();
    for (int pass = 0; pass < 2; pass++) {
      int begin = hull.size();
      for (Place point : sorted) {
        while (hull.size() >= begin + 2
            && cross(hull.get(hull.size() - 2), hull.get(hull.size() - 1), point) <= 0) {
          hull.remove(hull.size() - 1);
        }
        hull.add(point);
      }
      hull.remove(hull.size() - 1);
      Collections.reverse(sorted);
    }
    return hull;
  }

  private static double cross(Place a, Place b, Place c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
  }

  private void joint(SceneJoint joint) {
    Place first = place(joint.first());
    Place at = place(joint.second());
    if (scene.joints().size() > MANY && at.minus(lastJoint).length() < 8) {
      return;
    }
    lastJoint = at;
    Point3 axis = Projection.axis(scene, joint);
    Place shown = direction(axis);
    Place shown2 = direction(scene.pose(joint.second().body()).turn(joint.axis2()));
    Ink ink = ink(joint);
    canvas.part(
        JointSymbols.word(joint.type())
            + " joint "
            + joint.name()
            + (joint.cut() ? ", cut" : "")
            + (joint.driven() ? ", driven" : ""),
        () -> {
          if (slides(joint.type()) && shown.length() > 0.05) {
            Place beyond = shown.unit().times(18 * size);
            forces.dashed(first, at, Ink.AXIS);
            canvas.draw(
                at.minus(beyond).to(at.plus(beyond)), new Pen(ink, Math.max(0.8, 1.2 * size)));
          } else if (first.minus(at).length() > 2) {
            forces.dashed(first, at, ink);
          }
          joints.draw(joint.type(), at, shown, shown2, ink);
        });
    names.keepFree(at, joints.reach() * 0.8);
  }

  private static Ink ink(SceneJoint joint) {
    return joint.cut() ? CUT : joint.driven() ? DRIVEN : TREE;
  }

  private static boolean slides(JointType type) {
    return type == JointType.P || type == JointType.C || type == JointType.H;
  }

  /** Draws the support of a joint on the body at rest, where no bar leaves the joint. */
  private void ground(SceneJoint joint) {
    boolean firstAtRest = Projection.isAtRest(joint.first());
    if (joint.type() == JointType.F || !(firstAtRest || Projection.isAtRest(joint.second()))) {
      return;
    }
    Place at = place(joint.second());
    int body = firstAtRest ? joint.second().body() : joint.first().body();
    List<Place> leaving = new ArrayList<>();
    for (Place point : pointsOf.get(body)) {
      if (point.minus(at).length() > 2) {
        leaving.add(point.minus(at).unit());
      }
    }
    Place axis = direction(Projection.axis(scene, joint));
    boolean along = slides(joint.type()) && axis.length() > 0.35;
    Place side = axis.unit().turned();
    Place[] candidates =
        along
            ? new Place[] {
              side.y() >= 0 ? side : side.times(-1), side.y() < 0 ? side : side.times(-1)
            }
            : new Place[] {new Place(0, 1), new Place(-1, 0), new Place(0, -1), new Place(1, 0)};
    Place best = candidates[0];
    double least = Double.POSITIVE_INFINITY;
    for (Place candidate : candidates) {
      double nearness = -1;
      for (Place bar : leaving) {
        nearness = Math.max(nearness, bar.x() * candidate.x() + bar.y() * candidate.y());
      }
      if (Math.max(0.6, nearness) < least) {
        least = Math.max(0.6, nearness);
        best = candidate;
      }
    }
    joints.ground(at, best);
    names.keepFree(at.plus(best.times(14 * size)), 9 * size);
  }

  private void constraint(SceneConstraint constraint) {
    String kind = constraint.kind().name().toLowerCase(Locale.ROOT).replace('_', ' ');
    canvas.part(kind + " " + constraint.name(), () -> constraintLines(constraint));
  }

  private void constraintLines(SceneConstraint constraint) {
    switch (constraint.kind()) {
      case DISTANCE, ROD -> {
        Place from = place(constraint.anchors().get(0));
        Place to = place(constraint.anchors().get(1));
        forces.rod(from, to, constraint.kind() == SceneConstraint.Kind.ROD, CONSTRAINT);
        names.avoid(from.to(to));
        nameBetween(constraint.name(), CONSTRAINT, from, to);
      }
      case COUPLING -> {
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
        Place point = place(constraint.anchors().get(0));
        Place along = direction(turned(constraint)).unit();
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
        Place centre = place(constraint.anchors().get(0));
        canvas.draw(rim(constraint), new Pen(CONSTRAINT, 1.6));
        forces.dot(centre, CONSTRAINT);
        names.name(constraint.name(), CONSTRAINT, false, List.of(centre), 14);
      }
      case KNIFE_EDGE -> {
        Place point = place(constraint.anchors().get(0));
        Point3 side = scene.pose(constraint.anchors().get(0).body()).turn(constraint.direction());
        Place across = direction(side).times(30);
        canvas.draw(
            JointSymbols.polygon(point.minus(across), point.plus(across)),
            new Pen(CONSTRAINT, 1.6).dashed(1));
        forces.dot(point, CONSTRAINT);
        names.name(constraint.name(), CONSTRAINT, false, List.of(point), 14);
      }
      case POINT_ON_PLANE -> {
        Place point = place(constraint.anchors().get(0));
        Point3 normal = turned(constraint);
        Point3 across = Math.abs(normal.x()) < 0.8 ? new Point3(1, 0, 0) : new Point3(0, 1, 0);
        Point3 one = normal.cross(across);
        Point3 unit = one.times(1 / one.norm());
        Place u = direction(unit).times(42);
        Place v = direction(normal.cross(unit)).times(42);
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
  private Path2D rim(SceneConstraint constraint) {
    Anchor centre = constraint.anchors().get(0);
    SceneConstraint.Wheel wheel = constraint.wheel().orElseThrow();
    Point3 axle =
        wheel.isBall()
            ? projection.right().cross(projection.up())
            : scene.pose(centre.body()).turn(wheel.axle());
    Point3 across = Math.abs(axle.x()) < 0.8 ? new Point3(1, 0, 0) : new Point3(0, 1, 0);
    Point3 first = axle.cross(across);
    Point3 u = first.times(wheel.radius() / first.norm());
    Point3 v = axle.cross(u);
    Point3 at = scene.world(centre);
    Place[] corners = new Place[48];
    for (int i = 0; i < corners.length; i++) {
      double angle = 2 * Math.PI * i / corners.length;
      corners[i] = place(at.plus(u.times(Math.cos(angle))).plus(v.times(Math.sin(angle))));
    }
    return JointSymbols.polygon(corners);
  }

  private Point3 turned(SceneConstraint constraint) {
    return scene.pose(constraint.anchors().get(1).body()).turn(constraint.direction());
  }

  /** Returns the joints of a coupling, or what a rope passes. */
  private List<Place> coupled(SceneConstraint constraint) {
    if (!constraint.anchors().isEmpty()) {
      return constraint.anchors().stream().map(this::place).toList();
    }
    return scene.joints().stream()
        .filter(joint -> constraint.joints().contains(joint.name()))
        .map(joint -> place(joint.second()))
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

  private void force(SceneForce force) {
    String kind = force.kind().name().toLowerCase(Locale.ROOT).replace('_', ' ');
    canvas.part(kind + " " + force.name(), () -> forceLines(force));
  }

  private void forceLines(SceneForce force) {
    List<Place> at = force.anchors().stream().map(this::place).toList();
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
        Place along = direction(force.direction());
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
      case ROPE, COUPLING -> {
        for (int i = 1; i < at.size(); i++) {
          if (force.kind() == SceneForce.Kind.ROPE) {
            forces.rod(at.get(i - 1), at.get(i), false, FORCE);
          } else {
            forces.dashed(at.get(i - 1), at.get(i), FORCE);
          }
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

  /** Draws the sphere and the part of the surface beneath it. */
  private void contact(SceneForce force, Place centre) {
    double radius = force.radius() * scale;
    if (radius > 1) {
      forces.sphere(centre, radius, FORCE);
    } else {
      forces.dot(centre, FORCE);
    }
    Point3 middle = scene.world(force.anchors().get(0));
    Point3 surface = scene.world(force.anchors().get(1));
    double height = middle.minus(surface).dot(force.direction());
    Place foot = place(middle.minus(force.direction().times(height)));
    Place into = direction(force.direction()).times(-1);
    if (into.length() > 0.35) {
      Place unit = into.unit();
      joints.hatched(foot, unit.turned(), Math.max(40, Math.min(90, radius)), unit);
    }
    names.name(force.name(), FORCE, false, List.of(foot, centre), 14);
  }

  private void inJoint(SceneForce force) {
    SceneJoint joint =
        scene.joints().stream()
            .filter(one -> one.name().equals(force.joint()))
            .findFirst()
            .orElseThrow();
    Place first = place(joint.first());
    Place at = place(joint.second());
    boolean slides = slides(joint.type());
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
            Place along = direction(Projection.axis(scene, joint));
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

  /** Draws the axes of a body's frame. */
  private void frame(SceneBody body) {
    Place at = place(body.pose().position());
    Point3[] axes = {new Point3(1, 0, 0), new Point3(0, 1, 0), new Point3(0, 0, 1)};
    Ink[] inks = {Ink.CURVE_4, Ink.CURVE_2, Ink.CURVE_0};
    for (int i = 0; i < 3; i++) {
      Place shown = direction(body.pose().turn(axes[i]));
      if (shown.length() > 0.1) {
        Place tip = at.plus(shown.times(24 * Math.max(1, size)));
        forces.arrow(at, tip, inks[i], 1.1);
        names.avoid(at.to(tip));
      }
    }
  }

  /** Names are wanted in the order of their weight: bodies, then joints. */
  private void nameAll() {
    int bodies = scene.bodies().size();
    int step = bodies > MANY ? (bodies + SOME_NAMES - 1) / SOME_NAMES : 1;
    for (int i = 0; i < bodies; i += step) {
      List<Place> points = pointsOf.get(i);
      if (points.isEmpty()) {
        points = List.of(place(scene.bodies().get(i).pose().position()));
      }
      Place middle = new Place(0, 0);
      for (Place point : points) {
        middle = middle.plus(point.times(1.0 / points.size()));
      }
      List<Place> wished = new ArrayList<>(List.of(middle));
      for (Place point : points) {
        wished.add(middle.plus(point.minus(middle).times(0.45)));
      }
      names.name(
          scene.bodies().get(i).name(),
          Ink.curve(i),
          true,
          wished.subList(0, Math.min(4, wished.size())),
          7 + BAR * size / 2);
    }
    for (SceneJoint joint : bodies > MANY ? List.<SceneJoint>of() : scene.joints()) {
      names.name(
          joint.name(), ink(joint), false, List.of(place(joint.second())), joints.reach() + 3);
    }
  }

  private void gravity() {
    double g = scene.gravity().norm();
    String text = g == 0 ? "no gravity" : "g = " + String.format(Locale.ROOT, "%.4g", g) + " m/s²";
    double right = WIDTH - MARGIN - 14;
    canvas.write(new Label(right - 14, MARGIN + 14, text, FONT, Anchoring.END, Ink.MUTED));
    if (g > 0) {
      Place along = direction(scene.gravity().times(1 / g));
      Place middle = new Place(right, MARGIN + 16);
      canvas.part(
          "direction of gravity",
          () -> {
            if (along.length() < 0.2) {
              forces.sphere(middle, 6, Ink.MUTED);
              forces.dot(middle, Ink.MUTED);
            } else {
              forces.arrow(
                  middle.minus(along.times(16)), middle.plus(along.times(16)), Ink.MUTED, 2);
            }
          });
    }
  }

  /** Draws the directions of the world's axes with their letters. */
  private void axes(Place at) {
    Point3[] axes = {new Point3(1, 0, 0), new Point3(0, 1, 0), new Point3(0, 0, 1)};
    Ink[] inks = {Ink.CURVE_4, Ink.CURVE_2, Ink.CURVE_0};
    String[] letters = {"x", "y", "z"};
    canvas.part(
        "world axes",
        () -> {
          for (int i = 0; i < 3; i++) {
            Place shown = direction(axes[i]);
            if (shown.length() > 0.1) {
              Place tip = at.plus(shown.times(20));
              forces.arrow(at, tip, inks[i], 1.4);
              Place letter = tip.plus(shown.unit().times(8));
              canvas.write(
                  new Label(
                      letter.x(), letter.y() + 4, letters[i], FONT, Anchoring.MIDDLE, inks[i]));
            }
          }
        });
  }

  private void scaleBar(double y) {
    double longest = 130 / scale;
    double power = Math.pow(10, Math.floor(Math.log10(longest)));
    double length = power;
    for (double factor : new double[] {2, 5}) {
      length = factor * power <= longest ? factor * power : length;
    }
    double right = WIDTH - MARGIN - 14;
    double left = right - length * scale;
    Pen pen = new Pen(Ink.MUTED, 1.4);
    canvas.draw(new Line2D.Double(left, y, right, y), pen);
    canvas.draw(new Line2D.Double(left, y - 4, left, y + 4), pen);
    canvas.draw(new Line2D.Double(right, y - 4, right, y + 4), pen);
    canvas.write(
        new Label((left + right) / 2, y - 8, length(length), FONT, Anchoring.MIDDLE, Ink.MUTED));
  }

  private static String length(double metres) {
    String[] units = {"nm", "µm", "mm", "m", "km"};
    int unit =
        Math.max(0, Math.min(4, 3 + Math.floorDiv((int) Math.floor(Math.log10(metres) + 1e-9), 3)));
    if (unit == 3 || (metres >= 0.1 && metres < 1)) {
      return String.format(Locale.ROOT, "%.4g", metres).replaceFirst("\\.?0+$", "") + " m";
    }
    double shown = metres * Math.pow(1000, 3 - unit);
    return Math.round(shown) + " " + units[unit];
  }

  /** Returns the types of joints in words, in lines that fit the picture. */
  private List<List<JointType>> legendRows() {
    Set<JointType> types = EnumSet.noneOf(JointType.class);
    scene.joints().forEach(joint -> types.add(joint.type()));
    List<List<JointType>> rows = new ArrayList<>();
    double used = WIDTH;
    for (JointType type : types) {
      double needed = entryWidth(JointSymbols.word(type));
      if (used + needed > WIDTH - 2 * MARGIN) {
        rows.add(new ArrayList<>());
        used = 0;
      }
      rows.get(rows.size() - 1).add(type);
      used += needed;
    }
    return rows;
  }

  private static double entryWidth(String word) {
    return 34 + Label.width(word, FONT) + 18;
  }

  /** Draws the symbols used with their names; returns where the next line may be, px. */
  private double legend(double top) {
    JointSymbols samples = new JointSymbols(canvas, 0.8);
    double y = top;
    for (List<JointType> row : legendRows()) {
      double x = MARGIN;
      for (JointType type : row) {
        samples.draw(type, new Place(x + 12, y - 4), usualAxis(type), new Place(0, 1), TREE);
        String word = JointSymbols.word(type);
        canvas.write(new Label(x + 30, y, word, FONT, Anchoring.START, Ink.MUTED));
        x += entryWidth(word);
      }
      y += LINE + 4;
    }
    return colours(y);
  }

  /** Returns the direction for a sample of a symbol: along, unless joints point at the viewer. */
  private Place usualAxis(JointType type) {
    boolean seen =
        scene.joints().stream()
            .filter(joint -> joint.type() == type)
            .allMatch(joint -> direction(Projection.axis(scene, joint)).length() > 0.35);
    return seen ? new Place(1, 0) : new Place(0, 0);
  }

  /** Writes what the colours mean, each word in its colour. */
  private double colours(double y) {
    Map<String, Ink> words = colourWords();
    double x = MARGIN;
    for (Map.Entry<String, Ink> word : words.entrySet()) {
      Label label = new Label(x, y, word.getKey(), FONT, Anchoring.START, word.getValue());
      canvas.write(label);
      x += label.box().getWidth() + 18;
    }
    return words.isEmpty() ? y : y + LINE;
  }

  private Map<String, Ink> colourWords() {
    Map<String, Ink> words = new LinkedHashMap<>();
    if (scene.joints().stream().anyMatch(SceneJoint::cut)) {
      words.put("cut joint", CUT);
    }
    if (scene.joints().stream().anyMatch(joint -> joint.driven() && !joint.cut())) {
      words.put("driven joint", DRIVEN);
    }
    if (!scene.constraints().isEmpty()) {
      words.put("constraint", CONSTRAINT);
    }
    if (!scene.forces().isEmpty()) {
      words.put("force", FORCE);
    }
    return words;
  }

  /** Returns what check says, in lines that fit. */
  private List<String> captions(int unwritten) {
    SceneVerdict verdict = scene.verdict();
    List<String> lines = new ArrayList<>();
    long cut = scene.joints().stream().filter(SceneJoint::cut).count();
    lines.add(
        count(scene.bodies().size(), "body", "bodies")
            + ", "
            + count(scene.joints().size(), "joint", "joints")
            + (cut == 0 ? "" : " (" + cut + " cut)")
            + (scene.constraints().isEmpty()
                ? ""
                : ", " + count(scene.constraints().size(), "constraint", "constraints"))
            + (scene.forces().isEmpty()
                ? ""
                : ", " + count(scene.forces().size(), "force", "forces"))
            + ": "
            + count(verdict.degreesOfFreedom(), "degree", "degrees")
            + " of freedom");
    if (verdict.equations() > 0) {
      lines.add(
          count(verdict.equations(), "equation closes", "equations close")
              + " the loops; "
              + (!verdict.assembled()
                  ? "THE LOOPS CANNOT BE CLOSED, the drawing has them open"
                  : verdict.redundant() == 0
                      ? "none is redundant"
                      : count(verdict.redundant(), "is redundant", "are redundant")));
    }
    if (!verdict.warnings().isEmpty()) {
      lines.add(count(verdict.warnings().size(), "warning", "warnings") + " of mech check");
    }
    if (unwritten > 0) {
      lines.add(count(unwritten, "name has", "names have") + " no place here");
    }
    return lines;
  }

  private static String count(int number, String one, String many) {
    return number + " " + (number == 1 ? one : many);
  }

  private String description() {
    String bodies =
        String.join(", ", scene.bodies().stream().limit(50).map(SceneBody::name).toList());
    return "The mechanism at the start of its run. "
        + String.join(". ", captions(0))
        + ". Bodies: "
        + bodies
        + (scene.bodies().size() > 50 ? " and more." : ".");
  }
}
