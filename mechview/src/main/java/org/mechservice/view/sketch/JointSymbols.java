package org.mechservice.view.sketch;

import java.awt.Shape;
import java.awt.geom.Arc2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import org.mechservice.solver.api.JointType;
import org.mechservice.view.drawing.Canvas;
import org.mechservice.view.drawing.Ink;
import org.mechservice.view.drawing.Pen;

/** Textbook symbols of joints. */
final class JointSymbols {
  /** Length of a projected unit axis below which it counts as pointing at the viewer. */
  private static final double END_ON = 0.35;

  private static final double LINE = 1.6;

  private final Canvas canvas;
  private final double size;

  /**
   * Draws on a canvas.
   *
   * @param size factor of the usual size, for crowded drawings
   */
  JointSymbols(Canvas canvas, double size) {
    this.canvas = canvas;
    this.size = size;
  }

  /** Returns the name of a type in words. */
  static String word(JointType type) {
    return switch (type) {
      case R -> "revolute";
      case P -> "prismatic";
      case C -> "cylindrical";
      case U -> "universal";
      case S -> "spherical";
      case PL -> "planar";
      case H -> "screw";
      case F -> "free";
      case W -> "weld";
    };
  }

  /** Returns the radius that no symbol exceeds, px. */
  double reach() {
    return 11 * size;
  }

  /**
   * Draws a joint.
   *
   * @param at where
   * @param axis its unit axis in the drawing, shorter where it points at the viewer
   * @param axis2 the second axis of a universal joint
   * @param ink colour of the lines
   */
  void draw(JointType type, Place at, Place axis, Place axis2, Ink ink) {
    Pen pen = new Pen(ink, LINE * Math.max(0.6, size));
    boolean endOn = axis.length() < END_ON;
    Place along = axis.unit();
    switch (type) {
      case R -> {
        if (endOn) {
          outlined(circle(at, 4.6), pen);
        } else {
          sleeve(at, along, 8, 4.5, pen);
          canvas.draw(line(at, along, 11), pen);
        }
      }
      case P -> {
        if (endOn) {
          outlined(box(at, along, 6.5, 6.5), pen);
          canvas.draw(line(at, new Place(1, 1).unit(), 8), pen);
          canvas.draw(line(at, new Place(1, -1).unit(), 8), pen);
        } else {
          canvas.draw(line(at, along, 11), pen);
          outlined(box(at, along, 9, 5.5), pen);
        }
      }
      case C -> {
        outlined(endOn ? circle(at, 7.5) : box(at, along, 9, 5.5), pen);
        if (endOn) {
          canvas.draw(circle(at, 3), pen);
        } else {
          canvas.draw(line(at, along, 11), pen);
          outlined(circle(at, 3), pen);
        }
      }
      case H -> {
        outlined(endOn ? circle(at, 7.5) : box(at, along, 9, 5.5), pen);
        Place across = along.turned();
        for (int i = -1; i <= 1; i++) {
          Place middle = at.plus(along.times(5 * size * i));
          Place slant = across.times(5 * size).plus(along.times(2 * size));
          canvas.draw(middle.minus(slant).to(middle.plus(slant)), pen);
        }
      }
      case U -> {
        outlined(circle(at, 7.5), pen);
        boolean seen = axis2.length() > END_ON;
        Place other = seen ? axis2.unit() : along.turned();
        canvas.draw(line(at, endOn ? other.turned() : along, 7.5), pen);
        canvas.draw(line(at, other, 7.5), pen);
      }
      case S -> {
        canvas.draw(
            new Arc2D.Double(
                at.x() - 8.5 * size,
                at.y() - 8.5 * size,
                17 * size,
                17 * size,
                -50,
                280,
                Arc2D.OPEN),
            pen);
        outlined(circle(at, 5.2), pen);
      }
      case PL -> {
        if (endOn) {
          outlined(box(at, along, 8, 8), pen);
          canvas.draw(box(at, along, 4, 4), pen);
        } else {
          Place across = along.turned();
          outlined(box(at, across, 10, 3), pen);
          canvas.draw(line(at, across, 10), pen);
        }
      }
      case F -> canvas.draw(circle(at, 8), pen.dashed(2));
      case W -> canvas.fill(box(at, new Place(1, 0), 4, 4), ink);
    }
  }

  private void sleeve(Place at, Place along, double half, double thick, Pen pen) {
    outlined(box(at, along, half, thick), pen);
  }

  private void outlined(Shape shape, Pen pen) {
    canvas.fill(shape, Ink.PAGE);
    canvas.draw(shape, pen);
  }

  private Shape circle(Place at, double radius) {
    double r = radius * size;
    return new Ellipse2D.Double(at.x() - r, at.y() - r, 2 * r, 2 * r);
  }

  private Shape line(Place at, Place along, double half) {
    Place arm = along.times(half * size);
    return at.minus(arm).to(at.plus(arm));
  }

  private Shape box(Place at, Place along, double half, double thick) {
    Place arm = along.times(half * size);
    Place side = along.turned().times(thick * size);
    return polygon(
        at.plus(arm).plus(side),
        at.plus(arm).minus(side),
        at.minus(arm).minus(side),
        at.minus(arm).plus(side));
  }

  /** Returns a closed line through points. */
  static Path2D polygon(Place... corners) {
    Path2D path = new Path2D.Double();
    path.moveTo(corners[0].x(), corners[0].y());
    for (int i = 1; i < corners.length; i++) {
      path.lineTo(corners[i].x(), corners[i].y());
    }
    path.closePath();
    return path;
  }

  /**
   * Draws what a joint on the body at rest stands on: a line with hatching behind it.
   *
   * @param outwards unit direction from the joint into the ground
   */
  void ground(Place at, Place outwards) {
    Place along = outwards.turned();
    Place middle = at.plus(outwards.times(11 * size));
    hatched(middle, along, 13 * size, outwards);
    canvas.draw(at.to(middle), new Pen(Ink.MUTED, LINE * Math.max(0.6, size)));
  }

  /** Draws a line with hatching on one side. */
  void hatched(Place middle, Place along, double half, Place outwards) {
    Pen pen = new Pen(Ink.MUTED, LINE * Math.max(0.6, size));
    Pen thin = new Pen(Ink.MUTED, 1);
    canvas.draw(middle.minus(along.times(half)).to(middle.plus(along.times(half))), pen);
    double step = 5 * Math.max(0.6, size);
    for (double s = -half + step / 2; s <= half; s += step) {
      Place foot = middle.plus(along.times(s));
      canvas.draw(foot.to(foot.plus(outwards.minus(along).times(step))), thin);
    }
  }
}
