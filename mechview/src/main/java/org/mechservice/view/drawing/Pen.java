package org.mechservice.view.drawing;

import java.util.List;

/**
 * The style of a line.
 *
 * @param ink its colour
 * @param width px
 * @param dash lengths of dashes and gaps in turn, px; empty for a solid line
 * @param opacity from 0 to 1
 */
public record Pen(Ink ink, double width, List<Double> dash, double opacity) {
  private static final List<List<Double>> DASHES =
      List.of(List.of(), List.of(7.0, 4.0), List.of(2.0, 3.0), List.of(9.0, 3.0, 2.0, 3.0));

  /** Number of dash patterns that are told apart. */
  public static final int DASH_COUNT = DASHES.size();

  public Pen {
    dash = List.copyOf(dash);
  }

  /** Makes a pen for solid lines. */
  public Pen(Ink ink, double width) {
    this(ink, width, List.of(), 1);
  }

  /** Returns the pen with one of the dash patterns; 0 is solid, and they repeat. */
  public Pen dashed(int pattern) {
    return new Pen(ink, width, DASHES.get(Math.floorMod(pattern, DASH_COUNT)), opacity);
  }

  /** Returns the pen with a broad line that shines through, for what other lines may cover. */
  public Pen broad() {
    return new Pen(ink, 3 * width, dash, 0.35);
  }
}
