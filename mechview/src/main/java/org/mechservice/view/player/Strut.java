package org.mechservice.view.player;

import org.mechservice.view.scene.Anchor;

/**
 * A straight link between points of two bodies: its ends move with them.
 *
 * @param kind how it is drawn
 * @param name name in the model file
 * @param from one end
 * @param to the other end
 */
record Strut(Kind kind, String name, Anchor from, Anchor to) {
  /** The way in which a link is drawn. */
  enum Kind {
    ROD(0xa7aeb6, 0.008),
    /** Along which a joint slides: it does not count when the mechanism is measured. */
    GUIDE(0x8b939c, 0.0035),
    ROPE(0x8d7450, 0.0035),
    MUSCLE(0xb4463c, 0.008),
    SPRING(0x2f9e77, 0.009),
    DAMPER(0x7b6fb0, 0.011);

    private final int colour;
    private final double width;

    Kind(int colour, double width) {
      this.colour = colour;
      this.width = width;
    }

    /** Returns the colour, 0xRRGGBB. */
    int colour() {
      return colour;
    }

    /** Returns the radius of what is drawn, in parts of the extent. */
    double width() {
      return width;
    }
  }
}
