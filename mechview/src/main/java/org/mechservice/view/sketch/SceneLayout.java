package org.mechservice.view.sketch;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.mechservice.view.scene.Anchor;
import org.mechservice.view.scene.Point3;
import org.mechservice.view.scene.SceneConstraint;
import org.mechservice.view.scene.SceneDescription;
import org.mechservice.view.scene.SceneForce;
import org.mechservice.view.scene.SceneJoint;

/**
 * The places of the points of a scene in its drawing: direction of view, scale and origin, chosen
 * so that everything is in the field and fills it. Lengths are in px, y points downwards.
 */
final class SceneLayout {
  static final double WIDTH = 880;
  static final double TOP = 76;
  private static final double SIDE = 70;
  private static final double LEAST_HEIGHT = 150;
  private static final double MOST_HEIGHT = 560;

  /** Size of symbols if everything is at one point. */
  private static final double ALONE = 1.8;

  /** Distance of joints at which symbols have their usual size, px. */
  private static final double ROOMY = 42;

  private final SceneDescription scene;
  private final Projection projection;
  private final double scale;
  private final double fieldHeight;
  private final Place origin;
  private final boolean extended;

  SceneLayout(SceneDescription scene, ViewPlane plane) {
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
    extended = w + h > 0;
  }

  /** Returns px per m. */
  double scale() {
    return scale;
  }

  /** Returns the height of the field, which begins at {@link #TOP}, px. */
  double fieldHeight() {
    return fieldHeight;
  }

  Projection projection() {
    return projection;
  }

  /**
   * Returns the size of symbols, 1 being the usual one: smaller where joints are close together.
   *
   * @param least the smallest that can be read
   */
  double symbolSize(double least) {
    return extended ? Math.max(least, Math.min(1, typicalDistance() / ROOMY)) : ALONE;
  }

  /** Returns where a point is drawn. */
  Place place(Point3 point) {
    return new Place(
        origin.x() + scale * projection.x(point), origin.y() - scale * projection.y(point));
  }

  /** Returns where a point is drawn. */
  Place place(Anchor anchor) {
    return place(scene.world(anchor));
  }

  /** Returns a unit direction as the drawing shows it, in px of a length of at most 1. */
  Place direction(Point3 unit) {
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
}
