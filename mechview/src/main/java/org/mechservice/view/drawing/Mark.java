package org.mechservice.view.drawing;

import java.awt.Shape;

/** An element of a picture; elements are drawn in their order. */
sealed interface Mark {
  /** A line. */
  record Stroked(Shape shape, Pen pen) implements Mark {}

  /** An area. */
  record Filled(Shape shape, Ink ink, double opacity) implements Mark {}

  /** A text. */
  record Written(Label label) implements Mark {}

  /** The start of a part, with the name that pointing at it shows and a screen reader reads. */
  record Opened(String title) implements Mark {}

  /** The end of a part. */
  record Closed() implements Mark {}

  /** The start of a part of which only what lies in a rectangle is seen. */
  record Clipped(double x, double y, double width, double height) implements Mark {}
}
