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
    ROD(0xa7aeb6),
    SPRING(0x2f9e77),
    DAMPER(0x7b6fb0);

    private final int colour;

    Kind(int colour) {
      this.colour = colour;
    }

    /** Returns the colour, 0xRRGGBB. */
    int colour() {
      return colour;
    }
  }
}
