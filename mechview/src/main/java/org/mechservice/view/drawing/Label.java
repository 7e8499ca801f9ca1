package org.mechservice.view.drawing;

import java.awt.geom.Rectangle2D;

/**
 * One line of text in a picture.
 *
 * @param x where it begins, is centred or ends, px
 * @param y its base line, px
 * @param text plain text
 * @param size of the font, px
 * @param anchor which part of it is at x
 * @param ink its colour
 * @param bold whether it is bold
 * @param upwards whether it runs from bottom to top
 */
public record Label(
    double x,
    double y,
    String text,
    double size,
    Anchoring anchor,
    Ink ink,
    boolean bold,
    boolean upwards) {
  private static final String NARROW = "iljtfrI.,:;|'![]()/ -·";
  private static final String WIDE = "mwMWQOGD@%—…−+=";

  /** Which part of a text is at its place. */
  public enum Anchoring {
    START,
    MIDDLE,
    END
  }

  /** Makes a horizontal text in normal weight. */
  public Label(double x, double y, String text, double size, Anchoring anchor, Ink ink) {
    this(x, y, text, size, anchor, ink, false, false);
  }

  /** Returns the text in bold. */
  public Label inBold() {
    return new Label(x, y, text, size, anchor, ink, true, upwards);
  }

  /** Returns the text running from bottom to top. */
  public Label runningUp() {
    return new Label(x, y, text, size, anchor, ink, bold, true);
  }

  /** Returns the rectangle that the text covers, px; the font may be a little narrower. */
  public Rectangle2D box() {
    double width = width(text, size) * (bold ? 1.08 : 1);
    double before =
        switch (anchor) {
          case START -> 0;
          case MIDDLE -> width / 2;
          case END -> width;
        };
    double ascent = 0.8 * size;
    double height = 1.04 * size;
    return upwards
        ? new Rectangle2D.Double(x - ascent, y - width + before, height, width)
        : new Rectangle2D.Double(x - before, y - ascent, width, height);
  }

  /** Returns the width of a text in a sans-serif font, px. */
  public static double width(String text, double size) {
    double em = 0;
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      if (NARROW.indexOf(c) >= 0) {
        em += 0.36;
      } else if (WIDE.indexOf(c) >= 0) {
        em += 0.88;
      } else {
        em += Character.isUpperCase(c) ? 0.69 : Character.isDigit(c) ? 0.64 : c > 0x2E80 ? 1 : 0.6;
      }
    }
    return em * size;
  }

  /** Returns the text, with its middle left out if it is wider than allowed. */
  public static String shortened(String text, double size, double widest) {
    if (width(text, size) <= widest) {
      return text;
    }
    int keep = text.length() - 1;
    String shorter = text;
    while (keep > 2 && width(shorter, size) > widest) {
      keep--;
      int head = (keep + 1) / 2;
      shorter = text.substring(0, head) + "…" + text.substring(text.length() - (keep - head));
    }
    return shorter;
  }
}
