package org.mechservice.solver.distance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.lang.management.ManagementFactory;
import java.util.Random;
import org.junit.jupiter.api.Test;

class ShapeDistanceTest {
  /** Rounding of points of size one to ten. */
  private static final double ROUNDING = 1e-14;

  private final ShapeDistance distance = new ShapeDistance();

  private static double[] cloud(Random random, int count, double offset) {
    double[] points = new double[3 * count];
    for (int i = 0; i < points.length; i++) {
      points[i] = random.nextGaussian() + (i % 3 == 0 ? offset : 0);
    }
    return points;
  }

  /** The nearest point of a hull to the origin lies on a point, an edge or a triangle of points. */
  private static double bruteForce(double[] p, double[] q) {
    int m = q.length / 3;
    double[][] w = new double[p.length / 3 * m][3];
    for (int i = 0; i < w.length; i++) {
      for (int c = 0; c < 3; c++) {
        w[i][c] = p[3 * (i / m) + c] - q[3 * (i % m) + c];
      }
    }
    double best = Double.POSITIVE_INFINITY;
    for (int i = 0; i < w.length; i++) {
      best = Math.min(best, dot(w[i], w[i]));
      for (int j = i + 1; j < w.length; j++) {
        double[] e = minus(w[j], w[i]);
        double along = -dot(w[i], e) / dot(e, e);
        if (along > 0 && along < 1) {
          double[] foot = plus(w[i], e, along);
          best = Math.min(best, dot(foot, foot));
        }
        for (int k = j + 1; k < w.length; k++) {
          double[] f = minus(w[k], w[i]);
          double[] n = cross(e, f);
          double square = dot(n, n);
          double height = dot(w[i], n);
          if (square == 0 || height * height / square >= best) {
            continue;
          }
          double[] g = minus(plus(new double[3], n, height / square), w[i]);
          double u = dot(cross(g, f), n) / square;
          double v = dot(cross(e, g), n) / square;
          if (u >= 0 && v >= 0 && u + v <= 1) {
            best = height * height / square;
          }
        }
      }
    }
    return Math.sqrt(best);
  }

  private static double dot(double[] a, double[] b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  private static double[] minus(double[] a, double[] b) {
    return plus(a, b, -1);
  }

  private static double[] plus(double[] a, double[] b, double factor) {
    return new double[] {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
  }

  private static double[] cross(double[] a, double[] b) {
    return new double[] {
      a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
    };
  }

  private double between(ConvexShape a, ConvexShape b) {
    double found = distance.between(a, b);
    assertThat(distance.lowerBound()).isLessThanOrEqualTo(found + ROUNDING * 10);
    double[] onA = new double[3];
    double[] onB = new double[3];
    distance.nearestPoints(onA, onB);
    double[] apart = minus(onA, onB);
    if (found > 0) {
      assertThat(Math.sqrt(dot(apart, apart))).isCloseTo(found, within(10 * ROUNDING));
    }
    return found;
  }

  @Test
  void hullsOfPointsAreAsFarApartAsBruteForceSays() {
    int apart = 0;
    for (int seed = 0; seed < 600; seed++) {
      Random random = new Random(seed);
      double[] p = cloud(random, 6, 0);
      double[] q = cloud(random, 6, 5 * random.nextDouble());
      double found = between(new PointHull(p, 0), new PointHull(q, 0));
      if (found > 0) {
        apart++;
        assertThat(found).as("seed %d", seed).isCloseTo(bruteForce(p, q), within(ROUNDING));
        assertThat(between(new PointHull(q, 0), new PointHull(p, 0)))
            .isCloseTo(found, within(ROUNDING));
      }
    }
    assertThat(apart).isGreaterThan(300);
  }

  /** Faces that are parallel, in every direction, down to gaps of rounding. */
  @Test
  void boxesFaceToFaceHaveTheirGap() {
    for (int axis = 0; axis < 3; axis++) {
      for (double gap = 1; gap > 1e-12; gap /= 10) {
        double[] centre = {0.1, 0.2, 0.3};
        centre[axis] = 1 + gap;
        SolidPart one = SolidPart.box(new double[3], new double[] {1, 1, 1});
        SolidPart other = SolidPart.box(centre, new double[] {1, 1, 1});
        assertThat(between(one.shape(), other.shape())).isCloseTo(gap, within(ROUNDING));
      }
    }
  }

  @Test
  void roundShapesHaveClosedForms() {
    Frustum upright = new Frustum(new double[3], new double[] {0, 0, 1}, 0.5, 0.5);
    ConvexShape ball = new PointHull(new double[] {3, 0.3, 0.1}, 0.7);
    assertThat(between(upright, ball)).isCloseTo(Math.hypot(3, 0.3) - 1.2, within(ROUNDING));
    Frustum crossed = new Frustum(new double[] {2, -1, 0.2}, new double[] {2, 1, 0.2}, 0.25, 0.25);
    assertThat(between(upright, crossed)).isCloseTo(1.25, within(ROUNDING));
    Frustum above = new Frustum(new double[] {0.1, 0, 1.25}, new double[] {0.1, 0, 2}, 0.5, 0.2);
    assertThat(between(upright, above)).isCloseTo(0.25, within(ROUNDING));
    ConvexShape tip = new Frustum(new double[] {0, 0, 3}, new double[] {0, 0, 1.5}, 0.4, 0);
    assertThat(between(upright, tip)).isCloseTo(0.5, within(ROUNDING));
    // a capsule beside a cylinder, both along z
    ConvexShape capsule = new PointHull(new double[] {2, 0, 0, 2, 0, 1}, 0.3);
    assertThat(between(upright, capsule)).isCloseTo(1.2, within(ROUNDING));
  }

  /** The bounds of two discs whose rims face each other meet as far as the search converges. */
  @Test
  void boundsOfRoundShapesEncloseTheDistance() {
    Random random = new Random(3);
    for (int i = 0; i < 500; i++) {
      double[] from = cloud(random, 1, 4);
      double[] to = cloud(random, 1, 4);
      Frustum one = new Frustum(new double[3], new double[] {0, 0, 1}, 0.6, 0.2);
      Frustum other = new Frustum(from, to, 0.3, 0.5);
      double found = between(one, other);
      assertThat(found - distance.lowerBound()).as("case %d", i).isLessThan(1e-9);
    }
  }

  @Test
  void shapesThatOverlapHaveNoDistance() {
    Random random = new Random(4);
    for (int i = 0; i < 300; i++) {
      double[] p = cloud(random, 8, 0);
      double[] q = p.clone();
      for (int c = 0; c < q.length; c++) {
        q[c] *= 0.1;
      }
      // the small one is about the origin, which eight points of a normal cloud need not enclose
      double[] shift = new double[3];
      for (int c = 0; c < p.length; c++) {
        shift[c % 3] += 0.9 * p[c] / 8;
      }
      for (int c = 0; c < q.length; c++) {
        q[c] += shift[c % 3];
      }
      assertThat(distance.between(new PointHull(p, 0), new PointHull(q, 0))).isZero();
      assertThat(distance.lowerBound()).isZero();
    }
    ConvexShape ball = new PointHull(new double[3], 1);
    assertThat(distance.between(ball, new PointHull(new double[] {1.5, 0, 0}, 0.5))).isZero();
    assertThat(distance.between(ball, ball)).isZero();
  }

  @Test
  void hullsNeedFinitePoints() {
    assertThatThrownBy(() -> new PointHull(new double[] {0, Double.NaN, 0}, 0))
        .isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> new PointHull(new double[0], 0))
        .isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> new Frustum(new double[3], new double[3], 1, 1))
        .hasMessageContaining("length");
  }

  @Test
  void nothingAllocates() {
    Random random = new Random(5);
    ConvexShape p = new PointHull(cloud(random, 50, 0), 0);
    ConvexShape q = new Frustum(new double[] {6, 0, 0}, new double[] {7, 1, 0}, 1, 0.5);
    var threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
    double sum = 0;
    for (int i = 0; i < 20_000; i++) {
      sum += distance.between(p, q);
    }
    long before = threads.getCurrentThreadAllocatedBytes();
    for (int i = 0; i < 10_000; i++) {
      sum += distance.between(p, q);
    }
    // less than a byte a call: what the virtual machine itself does in this thread
    assertThat(threads.getCurrentThreadAllocatedBytes() - before).isLessThan(10_000);
    assertThat(sum).isPositive();
  }
}
