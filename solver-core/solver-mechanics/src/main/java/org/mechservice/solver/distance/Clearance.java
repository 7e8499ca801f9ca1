package org.mechservice.solver.distance;

import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;

/**
 * The least distance of two bodies along a motion, with a proved bound for the motion between its
 * rows. Over a part of the time each corner of body B stays in the hull of four points in the axes
 * of body A ({@link RelativePath}); the distance of A to the hull of all of them is a lower bound
 * there, that at an instant an upper one. The part with the least lower bound is divided until the
 * two meet: a passage between two rows is not stepped over. A body that is inside a closed surface
 * of the other at the first row overlaps it.
 *
 * <p>Workspace of one thread.
 */
public final class Clearance {
  /** Parts that are examined; more belong to solids that slide along each other without a gap. */
  private static final int MOST_PARTS = 2_000_000;

  private final PartTree bodyA;
  private final PartTree bodyB;
  private final double band;
  private final Surface surfaceA;
  private final Surface surfaceB;
  private final List<double[]> insideA;
  private final List<double[]> insideB;
  private final ShapeDistance distance = new ShapeDistance();
  private final RelativePath path = new RelativePath();
  private final double[] alone = new double[12];
  private final PointHull single = PointHull.over(alone);
  private final Map<Integer, Corners> corners = new HashMap<>();
  private final double[] at = new double[3];
  private double[] times = {};
  private double[][] posesA = {};
  private double[][] posesB = {};
  private int placed = -1;
  private double accuracy;

  /** What has been found so far. */
  private double least;

  private double instant;
  private final double[] nearestA = new double[3];
  private final double[] nearestB = new double[3];
  private int examined;

  /** Least bound of the pieces that were left out. */
  private double leftOut;

  /**
   * The least distance of two bodies.
   *
   * @param proved lower bound of the distance at all times, m
   * @param least distance that they have at an instant, m; 0 if they touch or overlap then
   * @param time that instant, s
   * @param onA the nearest point of A then, in the axes of A, m
   * @param onB that of B, in the axes of A, m
   * @param band by how much polytopes may miss the round surfaces that they stand for, m; taken off
   *     {@code proved}
   * @param examined parts of the time and of the bodies that were examined
   */
  @SuppressWarnings("ArrayRecordComponent") // made for its reader
  public record Result(
      double proved,
      double least,
      double time,
      double[] onA,
      double[] onB,
      double band,
      int examined) {}

  /** The hull of the paths of a part's corners, or of its corners alone. */
  private static final class Corners {
    final double[] points;
    final PointHull hull;

    Corners(int numbers) {
      points = new double[numbers];
      hull = PointHull.over(points);
    }
  }

  /**
   * A part of the time between two rows, of a part of each body.
   *
   * @param lower bound of the distance there, of polytopes in place of round parts
   * @param exact whether it is that of the hulls, not of balls around them
   */
  private record Piece(
      double lower, int row, double from, double to, PartTree a, PartTree b, boolean exact) {}

  /**
   * Prepares two bodies.
   *
   * @param partsA of A, in its axes; at least one
   * @param partsB of B
   */
  public Clearance(List<SolidPart> partsA, List<SolidPart> partsB) {
    bodyA = PartTree.of(partsA);
    bodyB = PartTree.of(partsB);
    surfaceA = new Surface(partsA);
    surfaceB = new Surface(partsB);
    insideA = surfaceB.isEmpty() ? List.of() : Surface.places(partsA);
    insideB = surfaceA.isEmpty() ? List.of() : Surface.places(partsB);
    band =
        partsA.stream().mapToDouble(SolidPart::shapeBand).max().orElse(0)
            + partsB.stream().mapToDouble(SolidPart::band).max().orElse(0);
  }

  /**
   * Finds the least distance along a motion.
   *
   * @param rowTimes of the rows, s, ascending; one row for bodies at rest
   * @param ofA poses of A at the rows, each the numbers of {@code BodyPoses}
   * @param ofB of B
   * @param close difference of the bounds at which the search ends, m
   * @throws ArithmeticException if they do not come so close
   */
  public Result along(double[] rowTimes, double[][] ofA, double[][] ofB, double close) {
    times = rowTimes;
    posesA = ofA;
    posesB = ofB;
    accuracy = close;
    placed = -1;
    least = Double.POSITIVE_INFINITY;
    examined = 0;
    leftOut = Double.POSITIVE_INFINITY;
    PriorityQueue<Piece> pieces = new PriorityQueue<>(Comparator.comparingDouble(Piece::lower));
    if (isEnclosed()) {
      least = 0;
      instant = times[0];
      return result(0);
    }
    int last = Math.max(1, times.length - 1);
    for (int row = 0; row < last; row++) {
      double end = times.length == 1 ? 0 : 1;
      add(pieces, row, 0, end, bodyA, bodyB);
    }
    while (!pieces.isEmpty()) {
      Piece piece = pieces.poll();
      if (piece.lower() >= least - accuracy || least == 0) {
        return result(piece.lower());
      }
      if (++examined > MOST_PARTS) {
        throw new ArithmeticException("the bounds do not meet");
      }
      examine(piece, pieces);
    }
    return result(Double.POSITIVE_INFINITY);
  }

  /** Returns whether one body is inside a surface of the other at the first row. */
  private boolean isEnclosed() {
    place(0);
    double[] there = new double[3];
    for (double[] corner : insideB) {
      path.places(0, corner, there);
      if (surfaceA.encloses(there)) {
        System.arraycopy(there, 0, nearestA, 0, 3);
        System.arraycopy(there, 0, nearestB, 0, 3);
        return true;
      }
    }
    for (double[] corner : insideA) {
      path.back(corner, there);
      if (surfaceB.encloses(there)) {
        System.arraycopy(corner, 0, nearestA, 0, 3);
        System.arraycopy(corner, 0, nearestB, 0, 3);
        return true;
      }
    }
    return false;
  }

  private Result result(double ofRest) {
    double proved = Math.max(0, Math.min(least, Math.min(leftOut, ofRest)) - band);
    return new Result(proved, least, instant, nearestA.clone(), nearestB.clone(), band, examined);
  }

  /** Returns the distance of the bodies at each row, m. */
  public double[] atRows(double[] rowTimes, double[][] ofA, double[][] ofB) {
    double[] found = new double[rowTimes.length];
    for (int row = 0; row < found.length; row++) {
      double[] time = {rowTimes[row]};
      double[][] a = {ofA[row]};
      double[][] b = {ofB[row]};
      found[row] = along(time, a, b, 0).least();
    }
    return found;
  }

  private void examine(Piece piece, PriorityQueue<Piece> pieces) {
    PartTree a = piece.a();
    PartTree b = piece.b();
    if (a.part.isEmpty() || b.part.isEmpty()) {
      boolean divideA = b.part.isPresent() || (a.part.isEmpty() && a.radius > b.radius);
      for (PartTree half : divideA ? a.halves() : b.halves()) {
        add(pieces, piece.row(), piece.from(), piece.to(), divideA ? half : a, divideA ? b : half);
      }
    } else if (piece.exact()) {
      double middle = 0.5 * (piece.from() + piece.to());
      if (middle > piece.from() && middle < piece.to()) {
        tight(piece.row(), piece.from(), middle, a, b, pieces);
        tight(piece.row(), middle, piece.to(), a, b, pieces);
      } else {
        leftOut = Math.min(leftOut, piece.lower()); // too short to be divided
      }
    } else {
      tight(piece.row(), piece.from(), piece.to(), a, b, pieces);
    }
  }

  /** Adds a piece with the bound of balls. */
  private void add(
      PriorityQueue<Piece> pieces, int row, double from, double to, PartTree a, PartTree b) {
    place(row);
    path.controls(from, to, b.centre, alone);
    distance.between(new PointHull(a.centre, 0), single);
    double stretched = Math.max(1, path.stretch(from, to)) * b.radius;
    double bound = distance.lowerBound() - a.radius - stretched;
    keep(new Piece(bound, row, from, to, a, b, false), pieces);
  }

  /** Adds a piece with the bound of hulls, and tries the instant in its middle. */
  private void tight(
      int row, double from, double to, PartTree a, PartTree b, PriorityQueue<Piece> pieces) {
    place(row);
    SolidPart partA = a.part.orElseThrow();
    SolidPart partB = b.part.orElseThrow();
    double[] points = partB.corners();
    double middle = 0.5 * (from + to);
    Corners now = corners.computeIfAbsent(points.length, Corners::new);
    path.places(middle, points, now.points);
    double found = Math.max(0, distance.between(partA.shape(), now.hull) - partB.margin());
    if (found < least) {
      least = found;
      double next = row + 1 < times.length ? times[row + 1] : times[row];
      instant = times[row] + middle * (next - times[row]);
      distance.nearestPoints(nearestA, nearestB);
      towardsA(partB.margin());
    }
    if (from == to) {
      return;
    }
    Corners all = corners.computeIfAbsent(4 * points.length, Corners::new);
    path.controls(from, to, points, all.points);
    distance.between(partA.shape(), all.hull);
    double bound = distance.lowerBound() - partB.margin();
    keep(new Piece(bound, row, from, to, a, b, true), pieces);
  }

  /** Keeps a piece that may matter; of others the bound alone. */
  private void keep(Piece piece, PriorityQueue<Piece> pieces) {
    if (piece.lower() < least - accuracy) {
      pieces.add(piece);
    } else {
      leftOut = Math.min(leftOut, piece.lower());
    }
  }

  /** Moves the nearest point from B's core to its surface. */
  private void towardsA(double margin) {
    double square = 0;
    for (int i = 0; i < 3; i++) {
      at[i] = nearestA[i] - nearestB[i];
      square += at[i] * at[i];
    }
    for (int i = 0; i < 3 && square > 0; i++) {
      nearestB[i] += at[i] * Math.min(1, margin / Math.sqrt(square));
    }
  }

  private void place(int row) {
    if (placed != row) {
      placed = row;
      int next = Math.min(row + 1, times.length - 1);
      path.between(
          new double[][] {posesA[row], posesA[next]},
          new double[][] {posesB[row], posesB[next]},
          times[next] - times[row]);
    }
  }
}
