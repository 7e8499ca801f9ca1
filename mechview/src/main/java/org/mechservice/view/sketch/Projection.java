package org.mechservice.view.sketch;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.api.JointType;
import org.mechservice.view.scene.Anchor;
import org.mechservice.view.scene.Point3;
import org.mechservice.view.scene.SceneDescription;
import org.mechservice.view.scene.SceneJoint;

/**
 * A direction of view without perspective.
 *
 * @param right world direction that points to the right in the drawing, unit vector
 * @param up world direction that points upwards, unit vector normal to it
 */
record Projection(Point3 right, Point3 up) {
  private static final Point3 X = new Point3(1, 0, 0);
  private static final Point3 Y = new Point3(0, 1, 0);
  private static final Point3 Z = new Point3(0, 0, 1);

  /** Sine of the angle between axes below which they count as parallel. */
  private static final double PARALLEL = 1e-6;

  /** Returns the projection on a plane. */
  static Projection of(ViewPlane plane, SceneDescription scene) {
    return switch (plane) {
      case XY -> new Projection(X, Y);
      case XZ -> new Projection(X, Z);
      case YZ -> new Projection(Y, Z);
      case ISO -> oblique(scene);
      case AUTO -> automatic(scene);
    };
  }

  private static Projection automatic(SceneDescription scene) {
    Point3 normal = normalOfMotion(scene);
    if (normal.norm() == 0) {
      return oblique(scene);
    }
    if (normal.cross(Z).norm() < PARALLEL) {
      return new Projection(X, Y);
    } else if (normal.cross(Y).norm() < PARALLEL) {
      return new Projection(X, Z);
    } else if (normal.cross(X).norm() < PARALLEL) {
      return new Projection(Y, Z);
    }
    Point3 upwards = upwards(scene);
    Point3 right = upwards.cross(normal);
    if (right.norm() < PARALLEL) {
      right = X.cross(normal);
    }
    Point3 unit = right.times(1 / right.norm());
    return new Projection(unit, normal.cross(unit));
  }

  /** Returns the common normal of the motions of all joints; zero if the motion is spatial. */
  private static Point3 normalOfMotion(SceneDescription scene) {
    List<Point3> turns = new ArrayList<>();
    List<Point3> slides = new ArrayList<>();
    for (SceneJoint joint : scene.joints()) {
      Point3 axis = axis(scene, joint);
      if (joint.type() == JointType.R || joint.type() == JointType.PL) {
        turns.add(axis);
      } else if (joint.type() == JointType.P) {
        slides.add(axis);
      } else if (joint.type() != JointType.W) {
        return Point3.ZERO;
      }
    }
    Point3 normal =
        !turns.isEmpty()
            ? turns.get(0)
            : slides.size() > 1 ? slides.get(0).cross(slides.get(1)) : Point3.ZERO;
    if (normal.norm() < PARALLEL) {
      return Point3.ZERO;
    }
    Point3 unit = normal.times(1 / normal.norm());
    boolean planar =
        turns.stream().allMatch(axis -> axis.cross(unit).norm() < PARALLEL)
            && slides.stream().allMatch(axis -> Math.abs(axis.dot(unit)) < PARALLEL);
    return planar ? unit : Point3.ZERO;
  }

  /** Returns the axis of a joint in world axes. */
  static Point3 axis(SceneDescription scene, SceneJoint joint) {
    return scene.pose(joint.first().body()).turn(joint.axis());
  }

  /** Returns the world axis that is nearest to the opposite of gravity; z without gravity. */
  private static Point3 upwards(SceneDescription scene) {
    Point3 g = scene.gravity();
    double size = Math.max(Math.abs(g.x()), Math.max(Math.abs(g.y()), Math.abs(g.z())));
    if (size == 0 || Math.abs(g.z()) == size) {
      return Z;
    }
    return Math.abs(g.y()) == size ? Y : X;
  }

  /** From the front, the right and above: the first horizontal axis points to the right. */
  private static Projection oblique(SceneDescription scene) {
    Point3 vertical = upwards(scene);
    Point3 first = vertical.equals(Z) ? X : vertical.equals(Y) ? Z : Y;
    Point3 second = vertical.cross(first);
    Point3 towards = first.times(0.45).plus(second.times(-0.75)).plus(vertical.times(0.48));
    Point3 view = towards.times(1 / towards.norm());
    Point3 right = vertical.cross(view);
    Point3 unit = right.times(1 / right.norm());
    return new Projection(unit, view.cross(unit));
  }

  /** Returns the coordinate to the right, m. */
  double x(Point3 point) {
    return point.dot(right);
  }

  /** Returns the coordinate upwards, m. */
  double y(Point3 point) {
    return point.dot(up);
  }

  /** Returns the coordinate towards the viewer, m. */
  double depth(Point3 point) {
    return point.dot(right.cross(up));
  }

  /** Returns whether an anchor belongs to the body at rest. */
  static boolean isAtRest(Anchor anchor) {
    return anchor.body() == Anchor.ROOT;
  }
}
