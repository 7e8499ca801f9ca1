package org.mechservice.report.page;

import java.util.Locale;

/**
 * The style of the curve of a method: the colour stands for formulation and closure, the mark for
 * the integrator.
 *
 * @param colour index of a CSS colour
 * @param mark which of the outlines
 * @param offset of failures at the right edge, so that they do not cover each other
 */
record CurveStyle(int colour, int mark, double offset) {
  /** Returns the CSS classes. */
  String css() {
    return "c" + colour + " m" + mark;
  }

  /** Returns the path of the mark at a place. */
  String outline(double x, double y, double r) {
    return switch (mark) {
      case 0 ->
          format(
              "M%.1f %.1fa%.1f %.1f 0 1 0 %.1f 0a%.1f %.1f 0 1 0 %.1f 0z",
              x - r, y, r, r, 2 * r, r, r, -2 * r);
      case 1 ->
          format(
              "M%.1f %.1fh%.1fv%.1fh%.1fz", x - 0.9 * r, y - 0.9 * r, 1.8 * r, 1.8 * r, -1.8 * r);
      case 2 -> format("M%.1f %.1fl%.1f %.1fh%.1fz", x, y - 1.2 * r, 1.15 * r, 2 * r, -2.3 * r);
      default ->
          format(
              "M%.1f %.1fl%.1f %.1fl%.1f %.1fl%.1f %.1fz",
              x, y - 1.3 * r, 1.3 * r, 1.3 * r, -1.3 * r, 1.3 * r, -1.3 * r, -1.3 * r);
    };
  }

  private static String format(String pattern, Object... numbers) {
    return String.format(Locale.ROOT, pattern, numbers);
  }

  /** Returns the mark alone, for legends and tables. */
  String swatch() {
    return "<svg class=\"swatch curve "
        + css()
        + "\" viewBox=\"0 0 26 12\"><path class=\"path\" d=\"M1 6L25 6\"/><path class=\"mark\" d=\""
        + outline(13, 6, 4.2)
        + "\"/></svg>";
  }
}
