package org.mechservice.view.sketch;

import java.awt.geom.Line2D;

/**
 * A point or a direction in the drawing, px, y downwards.
 *
 * @param x to the right
 * @param y downwards
 */
record Place(double x, double y) {
  Place plus(Place other) {
    return new Place(x + other.x, y + other.y);
  }

  Place minus(Place other) {
    return new Place(x - other.x, y - other.y);
  }

  Place times(double factor) {
    return new Place(factor * x, factor * y);
  }

  double length() {
    return Math.hypot(x, y);
  }

  /** Returns the direction of this vector; to the right if it has no length. */
  Place unit() {
    double length = length();
    return length < 1e-9 ? new Place(1, 0) : times(1 / length);
  }

  /** Returns the vector turned by a right angle. */
  Place turned() {
    return new Place(-y, x);
  }

  Line2D to(Place other) {
    return new Line2D.Double(x, y, other.x, other.y);
  }
}
