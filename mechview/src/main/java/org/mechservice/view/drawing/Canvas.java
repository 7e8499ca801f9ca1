package org.mechservice.view.drawing;

import java.awt.Shape;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** A picture under construction: lengths in px from the upper left corner, y downwards. */
public final class Canvas {
  private final double width;
  private final double height;
  private final String title;
  private final String description;
  private final List<Mark> marks = new ArrayList<>();

  /**
   * Starts an empty picture.
   *
   * @param width px
   * @param height px
   * @param title what it shows, in a few words, for readers that cannot see it
   * @param description what can be seen in it, in a few sentences
   */
  public Canvas(double width, double height, String title, String description) {
    this.width = width;
    this.height = height;
    this.title = title;
    this.description = description;
  }

  /** Draws a line along a shape. */
  public void draw(Shape shape, Pen pen) {
    marks.add(new Mark.Stroked(shape, pen));
  }

  /** Fills a shape. */
  public void fill(Shape shape, Ink ink) {
    fill(shape, ink, 1);
  }

  /**
   * Fills a shape so that what is behind it shines through.
   *
   * @param opacity from 0 to 1
   */
  public void fill(Shape shape, Ink ink, double opacity) {
    marks.add(new Mark.Filled(shape, ink, opacity));
  }

  /** Writes a text. */
  public void write(Label label) {
    marks.add(new Mark.Written(label));
  }

  /**
   * Draws what belongs together.
   *
   * @param name shown when it is pointed at; a screen reader reads it
   */
  public void part(String name, Runnable drawing) {
    marks.add(new Mark.Opened(name));
    drawing.run();
    marks.add(new Mark.Closed());
  }

  /** Draws what is seen in a rectangle only. */
  public void clipped(double x, double y, double w, double h, Runnable drawing) {
    marks.add(new Mark.Clipped(x, y, w, h));
    drawing.run();
    marks.add(new Mark.Closed());
  }

  double width() {
    return width;
  }

  double height() {
    return height;
  }

  String title() {
    return title;
  }

  String description() {
    return description;
  }

  List<Mark> marks() {
    return Collections.unmodifiableList(marks);
  }
}
