package org.mechservice.view.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import org.mechservice.solver.spatial.TouchingPoint;

/**
 * The way of a rope in a position of its mechanism, as lines through points: straight parts, and
 * arcs on pulleys, spheres and cylinders. The number of points does not depend on the position.
 *
 * <p>The geometry is that of the length in the mechanism, which {@code RopeSection} of the reader
 * and {@code Wrap} of the force laws explain with the same letters; the player's {@code rope.js}
 * has it too, for every picture of a motion.
 */
public final class RopeWay {
  /** Parts of an arc. */
  public static final int PARTS = 16;

  /** Length of which nothing is left when a direction is sought, m. */
  private static final double NOTHING = 1e-15;

  private final SceneRope rope;
  private final IntFunction<BodyPose> pose;

  private RopeWay(SceneRope rope, IntFunction<BodyPose> pose) {
    this.rope = rope;
    this.pose = pose;
  }

  /**
   * Returns the lines of a rope, one more than it has branches, in world axes, m.
   *
   * @param pose of each body and of the root
   */
  public static List<List<Point3>> of(SceneRope rope, IntFunction<BodyPose> pose) {
    return new RopeWay(rope, pose).lines();
  }

  private List<List<Point3>> lines() {
    List<List<Point3>> lines = new ArrayList<>();
    List<SceneRope.Stop> section = new ArrayList<>();
    for (SceneRope.Stop stop : rope.stops()) {
      if (stop instanceof SceneRope.Branch) {
        section.clear();
        continue;
      }
      section.add(stop);
      if (stop instanceof SceneRope.Eye eye) {
        if (section.size() == 1) {
          lines.add(new ArrayList<>(List.of(world(eye.at()))));
        } else {
          lines.get(lines.size() - 1).addAll(behindFirst(section));
          section = new ArrayList<>(List.of(stop));
        }
      }
    }
    return lines;
  }

  private Point3 world(Anchor anchor) {
    return pose.apply(anchor.body()).toWorld(anchor.point());
  }

  /** Returns the points of a section, which begins and ends at an eye, without the first. */
  private List<Point3> behindFirst(List<SceneRope.Stop> section) {
    Point3 from = world(((SceneRope.Eye) section.get(0)).at());
    Point3 to = world(((SceneRope.Eye) section.get(section.size() - 1)).at());
    List<Point3> points = new ArrayList<>();
    if (section.size() > 2 && section.get(1) instanceof SceneRope.Around around) {
      points.addAll(around(from, around, to));
    } else if (section.size() > 2) {
      points.addAll(new Pulleys(section).points());
    }
    points.add(to);
    return points;
  }

  private static List<Point3> straight(Point3 from, Point3 to) {
    return IntStream.rangeClosed(0, PARTS)
        .mapToObj(i -> from.plus(to.minus(from).times((i + 1.0) / (PARTS + 2))))
        .toList();
  }

  private List<Point3> around(Point3 from, SceneRope.Around shape, Point3 to) {
    BodyPose body = pose.apply(shape.centre().body());
    Point3 centre = body.toWorld(shape.centre().point());
    Point3 axis = body.turn(shape.axis());
    double h1 = from.minus(centre).dot(axis);
    double h2 = to.minus(centre).dot(axis);
    Point3 a = from.minus(centre).minus(axis.times(h1));
    Point3 b = to.minus(centre).minus(axis.times(h2));
    double r = shape.radius();
    Point3 normal = a.cross(b);
    double psi = Math.atan2(normal.norm(), a.dot(b));
    double ta = Math.sqrt(Math.max(0, a.dot(a) - r * r));
    double tb = Math.sqrt(Math.max(0, b.dot(b) - r * r));
    double betaA = Math.atan2(ta, r);
    double betaB = Math.atan2(tb, r);
    double shortArc = psi - betaA - betaB;
    boolean outside = a.norm() >= r && b.norm() >= r;
    Point3 first = a.times(1 / Math.max(a.norm(), NOTHING));
    Point3 across = across(normal, first);
    if (shape.inside()) {
      if (!outside || shortArc > 0) {
        return straight(from, to);
      }
      double u = TouchingPoint.angle(a.norm(), b.norm(), psi, r, 1e-9);
      Point3 touch = first.times(r * Math.cos(u)).plus(across.times(r * Math.sin(u)));
      double share = share(touch.minus(a).norm(), touch.minus(b).norm());
      Point3 at = centre.plus(touch).plus(axis.times(h1 + share * (h2 - h1)));
      return IntStream.rangeClosed(0, PARTS).mapToObj(i -> at).toList();
    }
    boolean longWay = shape.sides().stream().anyMatch(side -> isOpposite(side, centre, a, b));
    if (!outside || (!longWay && shortArc < 0)) {
      return straight(from, to);
    }
    double begin = longWay ? -betaA : betaA;
    double arc = longWay ? -(2 * Math.PI - psi - betaA - betaB) : shortArc;
    double whole = ta + tb + r * Math.abs(arc);
    return IntStream.rangeClosed(0, PARTS)
        .mapToObj(
            i -> {
              double done = arc * i / PARTS;
              double h = h1 + (h2 - h1) * (ta + r * Math.abs(done)) / whole;
              return centre
                  .plus(first.times(r * Math.cos(begin + done)))
                  .plus(across.times(r * Math.sin(begin + done)))
                  .plus(axis.times(h));
            })
        .toList();
  }

  /** Returns whether a side lies opposite the angle between a and b. */
  private boolean isOpposite(Anchor sideAnchor, Point3 centre, Point3 a, Point3 b) {
    Point3 side = world(sideAnchor).minus(centre);
    double size = 1e-12 * side.norm();
    double aa = a.dot(a);
    double bb = b.dot(b);
    double ab = a.dot(b);
    double alongA = side.dot(a) * bb - side.dot(b) * ab + size * a.norm() * bb;
    double alongB = side.dot(b) * aa - side.dot(a) * ab + size * b.norm() * aa;
    return Math.max(alongA, alongB) <= 0;
  }

  /** Returns the unit vector across the first one in the plane with a normal, or in any. */
  private static Point3 across(Point3 normal, Point3 first) {
    Point3 second = normal.cross(first);
    if (second.norm() < NOTHING) {
      Point3 other = Math.abs(first.x()) < 0.8 ? new Point3(1, 0, 0) : new Point3(0, 1, 0);
      second = first.cross(other);
    }
    return second.times(1 / Math.max(second.norm(), NOTHING));
  }

  private static double share(double part, double rest) {
    return part + rest > 0 ? part / (part + rest) : 0;
  }

  /** A section over pulleys, in the axes of its plane. */
  private final class Pulleys {
    private final BodyPose plane;
    private final List<Point3> centres = new ArrayList<>();
    private final List<Double> signed = new ArrayList<>();
    private final List<Boolean> held = new ArrayList<>();

    Pulleys(List<SceneRope.Stop> section) {
      plane = pose.apply(rope.plane().body()).times(rope.plane().axes());
      for (SceneRope.Stop stop : section) {
        if (stop instanceof SceneRope.Pulley one) {
          add(one.centre(), one.left() ? one.radius() : -one.radius(), one.held());
        } else if (stop instanceof SceneRope.Eye one) {
          add(one.at(), 0, true);
        }
      }
    }

    private void add(Anchor centre, double signedRadius, boolean isHeld) {
      centres.add(plane.turnBack(world(centre).minus(plane.position())));
      signed.add(signedRadius);
      held.add(isHeld);
    }

    List<Point3> points() {
      List<Integer> passed = new ArrayList<>(IntStream.range(0, centres.size()).boxed().toList());
      for (int k = 1; k < passed.size() - 1; k++) {
        if (!held.get(passed.get(k)) && angle(passed, k) < 0) {
          // the rope has left it; what it touches is sought anew
          passed.remove(k);
          k = 0;
        }
      }
      List<Point3> points = new ArrayList<>();
      for (int pulley = 1; pulley < centres.size() - 1; pulley++) {
        int k = passed.indexOf(pulley);
        if (k > 0) {
          points.addAll(arc(passed, k));
        }
      }
      while (points.size() < (centres.size() - 2) * (PARTS + 1)) {
        // pulleys that are left have their points at the end
        points.add(plane.toWorld(centres.get(centres.size() - 1)));
      }
      return points;
    }

    /** Returns the direction of the straight part between two stops, in the plane. */
    private double[] along(int i, int j) {
      Point3 d = centres.get(j).minus(centres.get(i));
      double delta = signed.get(j) - signed.get(i);
      double square = d.x() * d.x() + d.y() * d.y() - delta * delta;
      double tangent = Math.sqrt(Math.max(1e-30, square));
      double ux = tangent * d.x() + delta * d.y();
      double uy = tangent * d.y() - delta * d.x();
      double size = Math.max(Math.hypot(ux, uy), NOTHING);
      return new double[] {ux / size, uy / size};
    }

    private double angle(List<Integer> passed, int k) {
      double[] u = along(passed.get(k - 1), passed.get(k));
      double[] w = along(passed.get(k), passed.get(k + 1));
      double cross = u[0] * w[1] - u[1] * w[0];
      double sign = Math.signum(signed.get(passed.get(k)));
      return Math.PI / 2 + Math.atan2(-(u[0] * w[0] + u[1] * w[1]), sign * cross);
    }

    private List<Point3> arc(List<Integer> passed, int k) {
      int pulley = passed.get(k);
      double s = signed.get(pulley);
      double[] u = along(passed.get(k - 1), pulley);
      // from the centre, which is to the left of the rope where s is positive
      double begin = Math.atan2(-s * u[0], s * u[1]);
      double turn = Math.signum(s) * angle(passed, k);
      Point3 centre = centres.get(pulley);
      return IntStream.rangeClosed(0, PARTS)
          .mapToObj(
              i -> {
                double at = begin + turn * i / PARTS;
                return plane.toWorld(
                    centre.plus(
                        new Point3(Math.abs(s) * Math.cos(at), Math.abs(s) * Math.sin(at), 0)));
              })
          .toList();
    }
  }
}
