package org.mechservice.report.page;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.report.SceneFindings;
import org.mechservice.report.measure.Point;
import org.mechservice.report.method.Method;

/** What the reader must not trust: each doubt is a sentence with its numbers. */
public final class Doubts {
  /** Achieved over requested error within this is an honest tolerance. */
  static final double MOST_OPTIMISTIC = 100;

  static final double MOST_CAUTIOUS = 0.01;

  /** Errors nearer to the floor than this are not held against a method. */
  private static final double NEAR_FLOOR = 30;

  /** How much of what the tolerance falls by, in powers of ten, the error must follow. */
  private static final double LEAST_RESPONSE = 0.3;

  private static final double MANY_DECADES = 3;

  private Doubts() {}

  /** Returns all doubts about a scene's report, the gravest first. */
  public static List<String> of(SceneFindings found) {
    List<String> doubts = new ArrayList<>();
    if (found.judge().doubtful()) {
      doubts.add(found.judge().doubt());
    }
    List<Method> straying =
        found.methods().stream()
            .filter(method -> !converges(found.pointsOf(method.name()), found.floor()))
            .toList();
    if (straying.size() > 1 && straying.size() == found.methods().size()) {
      return allStray(doubts, found);
    }
    for (Method method : straying) {
      List<Point> points = found.pointsOf(method.name());
      Point first = firstCompleted(points);
      Point last = lastCompleted(points);
      doubts.add(
          method.name()
              + " does not converge: from tolerance "
              + Html.tolerance(first.tolerance())
              + " to "
              + Html.tolerance(last.tolerance())
              + " its error goes from "
              + Html.error(first.error())
              + " to "
              + Html.error(last.error())
              + ".");
    }
    return doubts;
  }

  /** Methods that all miss the reference speak against the reference. */
  private static List<String> allStray(List<String> doubts, SceneFindings found) {
    double least = Double.POSITIVE_INFINITY;
    double most = 0;
    for (Method method : found.methods()) {
      double error = lastCompleted(found.pointsOf(method.name())).error();
      least = Math.min(least, error);
      most = Math.max(most, error);
    }
    doubts.add(
        "No method converges to the reference: at their tightest tolerances all "
            + found.methods().size()
            + " stay "
            + Html.error(least)
            + " to "
            + Html.error(most)
            + " away. Reference and model do not belong together.");
    return doubts;
  }

  /** Returns whether the error follows the tolerance, or there is too little to tell. */
  static boolean converges(List<Point> points, double floor) {
    List<Point> completed = points.stream().filter(Point::completed).toList();
    if (completed.size() < 2) {
      return true;
    }
    Point first = completed.get(0);
    Point last = completed.get(completed.size() - 1);
    double decades = Math.log10(first.tolerance() / last.tolerance());
    if (decades < MANY_DECADES || last.error() <= NEAR_FLOOR * floor) {
      return true;
    }
    boolean accurate = last.error() <= MOST_OPTIMISTIC * last.tolerance();
    double response = Math.log10(first.error() / last.error()) / decades;
    return accurate || response >= LEAST_RESPONSE;
  }

  private static Point firstCompleted(List<Point> points) {
    return points.stream().filter(Point::completed).findFirst().orElseThrow();
  }

  private static Point lastCompleted(List<Point> points) {
    return points.stream().filter(Point::completed).reduce((a, b) -> b).orElseThrow();
  }

  /** Returns whether what was achieved is far from what was asked for. */
  static boolean dishonest(Point point, double floor) {
    double ratio = point.error() / point.tolerance();
    boolean tooLarge = ratio > MOST_OPTIMISTIC && point.error() > NEAR_FLOOR * floor;
    boolean tooSmall = ratio < MOST_CAUTIOUS && point.error() > floor;
    return point.completed() && (tooLarge || tooSmall);
  }
}
