package org.mechservice.view.sketch;

import java.awt.geom.Arc2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import org.mechservice.view.drawing.Canvas;
import org.mechservice.view.drawing.Ink;
import org.mechservice.view.drawing.Pen;

/** Textbook symbols of forces and constraints. */
final class ForceSymbols {
  private static final double LINE = 1.4;

  /** Length of a turn of a spring, px. */
  private static final double TURN = 11;

  private final Canvas canvas;
  private final double size;

  ForceSymbols(Canvas canvas, double size) {
    this.canvas = canvas;
    this.size = size;
  }

  private Pen pen(Ink ink) {
    return new Pen(ink, LINE * Math.max(0.7, size));
  }

  /** Draws a zigzag between two points, with straight ends. */
  void spring(Place from, Place to, Ink ink) {
    Place along = to.minus(from);
    double length = along.length();
    Place across = along.unit().turned().times(Math.min(6.5 * size, 0.2 * length));
    Path2D path = new Path2D.Double();
    path.moveTo(from.x(), from.y());
    double begin = 0.2;
    int turns = 2 * (int) Math.max(2, Math.min(9, 0.3 * length / TURN)) + 1;
    double part = 0.6 / turns;
    line(path, from.plus(along.times(begin)));
    for (int i = 0; i < turns; i++) {
      Place middle = from.plus(along.times(begin + part * (i + 0.5)));
      line(path, i % 2 == 0 ? middle.plus(across) : middle.minus(across));
    }
    line(path, from.plus(along.times(1 - begin)));
    line(path, to);
    canvas.draw(path, pen(ink));
  }

  private static void line(Path2D path, Place to) {
    path.lineTo(to.x(), to.y());
  }

  /** Draws a dashpot between two points. */
  void damper(Place from, Place to, Ink ink) {
    Place along = to.minus(from);
    double length = along.length();
    Place unit = along.unit();
    Place across = unit.turned().times(Math.min(5 * size, 0.2 * length));
    double half = Math.min(8 * size, 0.25 * length);
    Place middle = from.plus(along.times(0.5));
    Place bottom = middle.minus(unit.times(half));
    Place rim = middle.plus(unit.times(half));
    Path2D cup = new Path2D.Double();
    cup.moveTo(rim.plus(across).x(), rim.plus(across).y());
    line(cup, bottom.plus(across));
    line(cup, bottom.minus(across));
    line(cup, rim.minus(across));
    canvas.draw(cup, pen(ink));
    Place piston = across.times(0.7);
    canvas.draw(middle.minus(piston).to(middle.plus(piston)), pen(ink));
    canvas.draw(from.to(bottom), pen(ink));
    canvas.draw(middle.to(to), pen(ink));
  }

  /** Draws a spring and a damper side by side. */
  void springAndDamper(Place from, Place to, Ink ink) {
    Place along = to.minus(from);
    Place side = along.unit().turned().times(Math.min(7 * size, 0.3 * along.length()));
    Place first = from.plus(along.times(0.14));
    Place last = from.plus(along.times(0.86));
    canvas.draw(from.to(first), pen(ink));
    canvas.draw(last.to(to), pen(ink));
    canvas.draw(first.minus(side).to(first.plus(side)), pen(ink));
    canvas.draw(last.minus(side).to(last.plus(side)), pen(ink));
    spring(first.minus(side), last.minus(side), ink);
    damper(first.plus(side), last.plus(side), ink);
  }

  /** Draws a straight arrow. */
  void arrow(Place from, Place to, Ink ink, double width) {
    Place back = from.minus(to).unit().times(5 + 2 * width);
    Place wide = back.turned().times(0.42);
    canvas.draw(from.to(to.plus(back.times(0.7))), new Pen(ink, width));
    canvas.fill(JointSymbols.polygon(to, to.plus(back).plus(wide), to.plus(back).minus(wide)), ink);
  }

  /** Draws an arrow around a point. */
  void turningArrow(Place at, Ink ink) {
    double r = 14 * size;
    canvas.draw(
        new Arc2D.Double(at.x() - r, at.y() - r, 2 * r, 2 * r, 20, 230, Arc2D.OPEN), pen(ink));
    double angle = Math.toRadians(20);
    Place tip = at.plus(new Place(r * Math.cos(angle), -r * Math.sin(angle)));
    Place forwards = new Place(Math.sin(angle), Math.cos(angle));
    Place head = tip.plus(forwards.times(4));
    Place side = forwards.turned().times(3.4);
    Place base = tip.minus(forwards.times(4));
    canvas.fill(JointSymbols.polygon(head, base.plus(side), base.minus(side)), ink);
  }

  /** Draws the spiral of a spring that acts on an angle. */
  void spiral(Place at, Ink ink) {
    Path2D path = new Path2D.Double();
    for (int i = 0; i <= 60; i++) {
      double angle = i * Math.PI / 15;
      double r = (7 + 7.0 * i / 60) * size;
      double x = at.x() + r * Math.cos(angle);
      double y = at.y() + r * Math.sin(angle);
      if (i == 0) {
        path.moveTo(x, y);
      } else {
        path.lineTo(x, y);
      }
    }
    canvas.draw(path, pen(ink));
  }

  /** Draws the ring of an elastic joint. */
  void bushing(Place from, Place to, Ink ink) {
    Place middle = from.plus(to).times(0.5);
    canvas.draw(from.to(to), pen(ink));
    ring(middle, 8.5, ink);
    ring(middle, 4, ink);
  }

  private void ring(Place at, double radius, Ink ink) {
    double r = radius * size;
    canvas.draw(new Ellipse2D.Double(at.x() - r, at.y() - r, 2 * r, 2 * r), pen(ink));
  }

  /** Draws a circle that is not filled. */
  void sphere(Place at, double radius, Ink ink) {
    canvas.draw(
        new Ellipse2D.Double(at.x() - radius, at.y() - radius, 2 * radius, 2 * radius), pen(ink));
  }

  /** Draws a line that is only thought of. */
  void dashed(Place from, Place to, Ink ink) {
    canvas.draw(from.to(to), pen(ink).dashed(1));
  }

  /** Draws a rod between two points, with its eyes. */
  void rod(Place from, Place to, boolean massive, Ink ink) {
    canvas.draw(from.to(to), new Pen(ink, (massive ? 3.2 : 1.6) * Math.max(0.6, size)));
    dot(from, ink);
    dot(to, ink);
  }

  /** Draws a point. */
  void dot(Place at, Ink ink) {
    double r = 2.6 * Math.max(0.7, size);
    canvas.fill(new Ellipse2D.Double(at.x() - r, at.y() - r, 2 * r, 2 * r), ink);
  }

  /** Fills a circle that shines through. */
  void disc(Place at, double radius, Ink ink, double opacity) {
    canvas.fill(
        new Ellipse2D.Double(at.x() - radius, at.y() - radius, 2 * radius, 2 * radius),
        ink,
        opacity);
  }

  /** Draws the mark of a centre of mass: a circle with two dark quarters. */
  void centreOfMass(Place at, Ink ink) {
    double r = 4.5 * Math.max(0.6, size);
    Ellipse2D circle = new Ellipse2D.Double(at.x() - r, at.y() - r, 2 * r, 2 * r);
    canvas.fill(circle, Ink.PAGE);
    for (int quarter = 0; quarter < 360; quarter += 180) {
      canvas.fill(
          new Arc2D.Double(at.x() - r, at.y() - r, 2 * r, 2 * r, quarter, 90, Arc2D.PIE), ink);
    }
    canvas.draw(circle, new Pen(ink, 1));
  }
}
