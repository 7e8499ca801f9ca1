package org.mechservice.view.drawing;

import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Finds places for texts of a picture where they neither cover each other nor leave the picture.
 */
public final class FreePlaces {
  private final Rectangle2D bounds;
  private final List<Rectangle2D> taken = new ArrayList<>();
  private final List<Line2D> lines = new ArrayList<>();

  /**
   * Starts with an empty picture.
   *
   * @param bounds the rectangle in which texts may be
   */
  public FreePlaces(Rectangle2D bounds) {
    this.bounds = bounds;
  }

  /** Keeps a rectangle free of texts. */
  public void keepFree(Rectangle2D box) {
    taken.add(box);
  }

  /** Avoids that texts cross a line; they may where there is no other place. */
  public void avoid(Line2D line) {
    lines.add(line);
  }

  /**
   * Takes the best of some places: one that covers nothing, and crosses the fewest lines.
   *
   * @param candidates the same text at several places, the best liked first
   * @return the text where it is to be written; empty if every place is taken
   */
  public Optional<Label> take(List<Label> candidates) {
    Label best = null;
    long fewest = Long.MAX_VALUE;
    for (Label label : candidates) {
      Rectangle2D box = label.box();
      if (bounds.contains(box) && taken.stream().noneMatch(box::intersects)) {
        long crossed = lines.stream().filter(line -> line.intersects(box)).count();
        if (crossed < fewest) {
          fewest = crossed;
          best = label;
        }
        if (crossed == 0) {
          break;
        }
      }
    }
    if (best != null) {
      taken.add(best.box());
    }
    return Optional.ofNullable(best);
  }
}
