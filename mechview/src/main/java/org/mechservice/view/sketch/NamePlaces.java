package org.mechservice.view.sketch;

import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.view.drawing.Canvas;
import org.mechservice.view.drawing.FreePlaces;
import org.mechservice.view.drawing.Ink;
import org.mechservice.view.drawing.Label;
import org.mechservice.view.drawing.Label.Anchoring;

/**
 * Places for the names of a drawing. They are written last, each near its thing where it covers
 * nothing; a name for which there is no place is left out and counted.
 */
final class NamePlaces {
  private static final double FONT = 11.5;
  private static final double WIDEST = 150;

  /** Names beyond this number are not tried: the drawing is full long before. */
  private static final int MOST = 400;

  /** A name and the places it may be written at. */
  private record Wish(
      List<String> names, Ink ink, boolean bold, List<Place> points, double distance) {}

  private final FreePlaces free;
  private final Map<String, Wish> wishes = new LinkedHashMap<>();
  private int unwritten;

  /**
   * Starts without names.
   *
   * @param bounds where names may be
   */
  NamePlaces(Rectangle2D bounds) {
    free = new FreePlaces(bounds);
  }

  /** Keeps names away from a symbol. */
  void keepFree(Place at, double radius) {
    free.keepFree(new Rectangle2D.Double(at.x() - radius, at.y() - radius, 2 * radius, 2 * radius));
  }

  /** Keeps names away from a rectangle. */
  void keepFree(Rectangle2D box) {
    free.keepFree(box);
  }

  /** Avoids that names cross a line. */
  void avoid(Line2D line) {
    free.avoid(line);
  }

  /**
   * Wants a name. Names of one kind at the same place are written together.
   *
   * @param points near which it may be, the best liked first
   * @param distance from them to the text, px
   */
  void name(String text, Ink ink, boolean bold, List<Place> points, double distance) {
    Place first = points.get(0);
    String key =
        ink + " " + bold + " " + Math.round(first.x() / 4) + " " + Math.round(first.y() / 4);
    Wish before = wishes.get(key);
    List<String> all = new ArrayList<>(before == null ? List.of() : before.names());
    all.add(text);
    wishes.put(key, new Wish(all, ink, bold, points, distance));
  }

  /** Writes the names. */
  void write(Canvas canvas) {
    int tried = 0;
    for (Wish wish : wishes.values()) {
      tried++;
      if (tried > MOST
          || free.take(candidates(wish)).map(label -> written(canvas, label)).isEmpty()) {
        unwritten += wish.names().size();
      }
    }
  }

  private static boolean written(Canvas canvas, Label label) {
    canvas.write(label);
    return true;
  }

  /** Returns how many names found no place. */
  int unwritten() {
    return unwritten;
  }

  /** Returns all names, or the first and the last if all are too long. */
  private static String text(List<String> names) {
    String all = String.join(", ", names);
    if (names.size() > 2 && Label.width(all, FONT) > WIDEST) {
      all = names.get(0) + " … " + names.get(names.size() - 1);
    }
    return Label.shortened(all, FONT, WIDEST);
  }

  private static List<Label> candidates(Wish wish) {
    String text = text(wish.names());
    List<Label> labels = new ArrayList<>();
    for (double distance = wish.distance(); distance < wish.distance() + 40; distance += 9) {
      for (Place point : wish.points()) {
        double d = distance;
        double diagonal = 0.75 * d;
        add(labels, wish, text, point.plus(new Place(diagonal, -diagonal)), Anchoring.START);
        add(labels, wish, text, point.plus(new Place(d, 4)), Anchoring.START);
        add(labels, wish, text, point.plus(new Place(0, -d)), Anchoring.MIDDLE);
        add(labels, wish, text, point.plus(new Place(diagonal, diagonal + 7)), Anchoring.START);
        add(labels, wish, text, point.plus(new Place(0, d + 9)), Anchoring.MIDDLE);
        add(labels, wish, text, point.plus(new Place(-diagonal, -diagonal)), Anchoring.END);
        add(labels, wish, text, point.plus(new Place(-d, 4)), Anchoring.END);
        add(labels, wish, text, point.plus(new Place(-diagonal, diagonal + 7)), Anchoring.END);
      }
    }
    return labels;
  }

  private static void add(
      List<Label> labels, Wish wish, String text, Place at, Anchoring anchoring) {
    Label label = new Label(at.x(), at.y(), text, FONT, anchoring, wish.ink());
    labels.add(wish.bold() ? label.inBold() : label);
  }
}
