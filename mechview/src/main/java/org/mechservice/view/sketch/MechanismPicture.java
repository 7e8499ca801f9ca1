package org.mechservice.view.sketch;

import java.awt.geom.Path2D;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import org.mechservice.solver.api.JointType;
import org.mechservice.view.drawing.Canvas;
import org.mechservice.view.drawing.Ink;
import org.mechservice.view.drawing.Pen;
import org.mechservice.view.scene.Anchor;
import org.mechservice.view.scene.Point3;
import org.mechservice.view.scene.SceneBody;
import org.mechservice.view.scene.SceneConstraint;
import org.mechservice.view.scene.SceneDescription;
import org.mechservice.view.scene.SceneForce;
import org.mechservice.view.scene.SceneJoint;

/** Draws a mechanism at the start of its run. */
public final class MechanismPicture {
  private static final double BAR = 8;

  /** Bodies up to which frames and centres of mass are drawn. */
  private static final int FEW_BODIES = 20;

  /**
   * Bodies above which only some names are written, and symbols that lie on each other left out.
   */
  private static final int MANY = 60;

  /** Names of bodies in a drawing of many. */
  private static final int SOME_NAMES = 24;

  static final Ink CUT = Ink.CURVE_4;
  static final Ink DRIVEN = Ink.CURVE_3;
  static final Ink FORCE = Ink.CURVE_2;
  static final Ink CONSTRAINT = Ink.CURVE_1;
  private static final Ink TREE = Ink.TEXT;

  private final SceneDescription scene;
  private final SceneLayout layout;
  private final double size;
  private final PictureSheet sheet;
  private final Canvas canvas;
  private final JointSymbols joints;
  private final ForceSymbols forces;
  private final NamePlaces names;
  private final List<List<Place>> pointsOf = new ArrayList<>();
  private Place lastJoint = new Place(-1e9, 0);

  private MechanismPicture(SceneDescription scene, ViewPlane plane) {
    this.scene = scene;
    layout = new SceneLayout(scene, plane);
    size = layout.symbolSize(scene.joints().size() > MANY ? 0.3 : 0.6);
    sheet = new PictureSheet(scene, layout, size);
    canvas = sheet.canvas();
    joints = new JointSymbols(canvas, size);
    forces = new ForceSymbols(canvas, size);
    names = sheet.names();
    for (int body = 0; body < scene.bodies().size(); body++) {
      pointsOf.add(new ArrayList<>());
    }
  }

  /** Draws a mechanism. */
  public static Canvas draw(SceneDescription scene, ViewPlane plane) {
    return new MechanismPicture(scene, plane).picture();
  }

  private Canvas picture() {
    collectPoints();
    sheet.writeAbove();
    for (int body = 0; body < scene.bodies().size(); body++) {
      body(body);
    }
    if (scene.bodies().size() <= FEW_BODIES) {
      scene.bodies().forEach(this::frame);
    }
    InteractionSketch interactions = new InteractionSketch(scene, layout, canvas, names, size);
    scene.constraints().forEach(interactions::constraint);
    scene.forces().stream().filter(force -> force.joint().isEmpty()).forEach(interactions::force);
    scene.joints().forEach(this::ground);
    scene.joints().forEach(this::joint);
    scene.forces().stream()
        .filter(force -> !force.joint().isEmpty())
        .forEach(interactions::inJoint);
    nameAll();
    sheet.keepFree(names);
    names.write(canvas);
    int unwanted =
        scene.bodies().size() > MANY
            ? scene.bodies().size() + scene.joints().size() - SOME_NAMES
            : 0;
    sheet.writeBelow(unwanted + names.unwritten());
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
      Place at = layout.place(anchor);
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
            forces.centreOfMass(layout.place(body.pose().toWorld(body.centreOfMass())), ink);
          }
        });
    if (body.mass() > 0 && scene.bodies().size() <= FEW_BODIES) {
      names.keepFree(layout.place(body.pose().toWorld(body.centreOfMass())), 5);
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
    Place first = layout.place(joint.first());
    Place at = layout.place(joint.second());
    if (scene.joints().size() > MANY && at.minus(lastJoint).length() < 8) {
      return;
    }
    lastJoint = at;
    Point3 axis = Projection.axis(scene, joint);
    Place shown = layout.direction(axis);
    Place shown2 = layout.direction(scene.pose(joint.second().body()).turn(joint.axis2()));
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

  /** Returns whether a joint lets its bodies slide along its axis. */
  static boolean slides(JointType type) {
    return type == JointType.P || type == JointType.C || type == JointType.H;
  }

  /** Draws the support of a joint on the body at rest, where no bar leaves the joint. */
  private void ground(SceneJoint joint) {
    boolean firstAtRest = Projection.isAtRest(joint.first());
    if (joint.type() == JointType.F || !(firstAtRest || Projection.isAtRest(joint.second()))) {
      return;
    }
    Place at = layout.place(joint.second());
    int body = firstAtRest ? joint.second().body() : joint.first().body();
    List<Place> leaving = new ArrayList<>();
    for (Place point : pointsOf.get(body)) {
      if (point.minus(at).length() > 2) {
        leaving.add(point.minus(at).unit());
      }
    }
    Place axis = layout.direction(Projection.axis(scene, joint));
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

  /** Draws the axes of a body's frame. */
  private void frame(SceneBody body) {
    Place at = layout.place(body.pose().position());
    Point3[] axes = {new Point3(1, 0, 0), new Point3(0, 1, 0), new Point3(0, 0, 1)};
    Ink[] inks = {Ink.CURVE_4, Ink.CURVE_2, Ink.CURVE_0};
    for (int i = 0; i < 3; i++) {
      Place shown = layout.direction(body.pose().turn(axes[i]));
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
        points = List.of(layout.place(scene.bodies().get(i).pose().position()));
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
          joint.name(),
          ink(joint),
          false,
          List.of(layout.place(joint.second())),
          joints.reach() + 3);
    }
  }
}
