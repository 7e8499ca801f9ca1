package org.mechservice.report.page;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.report.measure.EqualError;
import org.mechservice.report.measure.Point;
import org.mechservice.report.measure.Quantiles;
import org.mechservice.report.measure.SceneFindings;
import org.mechservice.report.method.SimulationMethod;

/** Warnings of results that are not reliable, one sentence with its numbers each. */
public final class ReliabilityWarnings {
  /** Achieved over requested error beyond which a tolerance is not kept. */
  static final double MOST_OPTIMISTIC = 100;

  static final double MOST_CAUTIOUS = 0.01;

  /** Errors nearer to the floor than this are not held against a method. */
  private static final double NEAR_FLOOR = 30;

  /** Smallest ratio of the error's decrease to the tolerance's, both in powers of ten. */
  private static final double LEAST_RESPONSE = 0.3;

  private static final double MANY_DECADES = 3;

  /** Fewest methods from which the other methods characterise the scene. */
  private static final int MANY_METHODS = 3;

  /**
   * How fast the error between steps may grow against that at the end, in powers of ten per power
   * of ten of the tolerance. Dense output whose order is half the method's has 0.5.
   */
  private static final double MOST_BETWEEN_STEPS = 0.35;

  private static final double WORSE_BETWEEN_STEPS = 30;

  private ReliabilityWarnings() {}

  /** Returns all warnings about a scene's report, the most serious first. */
  public static List<String> of(SceneFindings found) {
    List<String> doubts = new ArrayList<>();
    if (found.judge().doubtful()) {
      doubts.add(found.judge().doubt());
    }
    List<SimulationMethod> straying =
        found.methods().stream()
            .filter(method -> !converges(found.pointsOf(method.name()), found.floor()))
            .toList();
    if (straying.size() > 1 && straying.size() == found.methods().size()) {
      return allStray(doubts, found);
    }
    for (SimulationMethod method : found.methods()) {
      List<Point> points = found.pointsOf(method.name());
      if (worseBetweenSteps(points, found.floor())) {
        doubts.add(betweenSteps(method, lastCompleted(points)));
      } else if (!straying.contains(method) && careless(method, found)) {
        doubts.add(careless(method, points, found));
      }
    }
    for (SimulationMethod method : straying) {
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

  /** Returns a single warning about the reference if all methods miss it. */
  private static List<String> allStray(List<String> doubts, SceneFindings found) {
    double least = Double.POSITIVE_INFINITY;
    double most = 0;
    for (SimulationMethod method : found.methods()) {
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

  /** Returns whether the error follows the tolerance, or there are too few points to decide. */
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

  /** Errors at steps' ends that fall faster than those of the rows between: dense output. */
  private static boolean worseBetweenSteps(List<Point> points, double floor) {
    List<Point> told =
        points.stream()
            .filter(Point::completed)
            .filter(point -> point.first().errors().atEnd() > floor)
            .filter(point -> point.error() < 1)
            .toList();
    if (told.size() < MANY_METHODS) {
      return false;
    }
    double[] x = told.stream().mapToDouble(p -> -Math.log10(p.tolerance())).toArray();
    double[] y = told.stream().mapToDouble(p -> Math.log10(excess(p))).toArray();
    return x[x.length - 1] - x[0] >= MANY_DECADES
        && excess(told.get(told.size() - 1)) > WORSE_BETWEEN_STEPS
        && EqualError.slope(x, y) > MOST_BETWEEN_STEPS;
  }

  private static double excess(Point point) {
    return point.error() / point.first().errors().atEnd();
  }

  private static String betweenSteps(SimulationMethod method, Point last) {
    return method.name()
        + " is less exact between its steps than at their ends: at tolerance "
        + Html.tolerance(last.tolerance())
        + " its error over time is "
        + Html.factor(excess(last))
        + " that at the end, and the more the tighter the tolerance. Its dense output is wrong.";
  }

  /**
   * Returns whether a method's errors exceed its tolerances far more than those of the other
   * methods.
   */
  private static boolean careless(SimulationMethod method, SceneFindings found) {
    double own = middleRatio(found.pointsOf(method.name()), found.floor());
    return own > MOST_OPTIMISTIC * usualRatio(method, found);
  }

  private static String careless(SimulationMethod method, List<Point> points, SceneFindings found) {
    return method.name()
        + " does not keep its tolerance: its errors are "
        + Html.factor(middleRatio(points, found.floor()))
        + " the tolerance asked for, where "
        + Html.factor(usualRatio(method, found))
        + " is usual in this scene.";
  }

  /**
   * Returns the usual ratio of error to tolerance: that of the other methods, or the growth of
   * errors in the scene if that is larger.
   */
  private static double usualRatio(SimulationMethod method, SceneFindings found) {
    double usual = Math.max(1, found.growth());
    if (found.methods().size() < MANY_METHODS) {
      return usual;
    }
    double[] others =
        found.methods().stream()
            .filter(other -> !other.equals(method))
            .mapToDouble(other -> middleRatio(found.pointsOf(other.name()), found.floor()))
            .filter(ratio -> ratio > 0)
            .toArray();
    return others.length == 0 ? usual : Math.max(usual, Quantiles.median(others));
  }

  /** Returns the median of error over tolerance, of errors above the floor; 0 if there is none. */
  private static double middleRatio(List<Point> points, double floor) {
    double[] ratios =
        points.stream()
            .filter(point -> point.completed() && point.error() > NEAR_FLOOR * floor)
            .mapToDouble(point -> point.error() / point.tolerance())
            .toArray();
    return ratios.length == 0 ? 0 : Quantiles.median(ratios);
  }

  private static Point firstCompleted(List<Point> points) {
    return points.stream().filter(Point::completed).findFirst().orElseThrow();
  }

  private static Point lastCompleted(List<Point> points) {
    return points.stream().filter(Point::completed).reduce((a, b) -> b).orElseThrow();
  }

  /** Returns whether a run's error is far larger than the requested tolerance. */
  static boolean isNotKept(Point point, double floor) {
    return point.completed()
        && point.error() > MOST_OPTIMISTIC * point.tolerance()
        && point.error() > NEAR_FLOOR * floor;
  }

  /** Returns whether a run is far more exact than requested, as far as the reference can tell. */
  static boolean isCautious(Point point, double floor) {
    return point.completed()
        && point.error() < MOST_CAUTIOUS * point.tolerance()
        && point.error() > floor;
  }
}
