package org.mechservice.solver.distance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.Test;

/** Distances of shapes in random poses beside those that another library found. */
class CoalDistancesTest {
  /** Coal stops at a tolerance of its own: its figures of 10 000 poses are up to 2e-10 off. */
  private static final double OF_COAL = 1e-9;

  /** Numbers of a shape: three sizes, nine of its rotation, three of its place. */
  private static final int NUMBERS = 15;

  @Test
  void distancesAreThoseOfCoal() throws IOException {
    ShapeDistance distance = new ShapeDistance();
    int apart = 0;
    for (String line : lines()) {
      String[] words = line.split(" ");
      double[] n = Arrays.stream(words).skip(2).mapToDouble(Double::parseDouble).toArray();
      ConvexShape a = shape(words[0], n, 0);
      ConvexShape b = shape(words[1], n, NUMBERS);
      double expected = Math.max(0, n[2 * NUMBERS]);
      double found = distance.between(a, b);
      assertThat(found).as(line).isCloseTo(expected, within(OF_COAL));
      assertThat(distance.lowerBound()).as(line).isCloseTo(found, within(1e-10));
      assertThat(distance.between(b, a)).as(line).isCloseTo(found, within(1e-11));
      apart += found > 0 ? 1 : 0;
    }
    assertThat(apart).isGreaterThan(80);
  }

  private static List<String> lines() throws IOException {
    try (InputStream file = CoalDistancesTest.class.getResourceAsStream("coal-distances.txt")) {
      String text = new String(Objects.requireNonNull(file).readAllBytes(), StandardCharsets.UTF_8);
      return text.lines().filter(line -> !line.startsWith("#")).toList();
    }
  }

  private static ConvexShape shape(String kind, double[] n, int at) {
    double[] low = point(n, at, 0, 0, -n[at + 1] / 2);
    double[] high = point(n, at, 0, 0, n[at + 1] / 2);
    return switch (kind) {
      case "box" -> box(n, at);
      case "cylinder" -> new Frustum(low, high, n[at], n[at]);
      case "cone" -> new Frustum(low, high, n[at], 0);
      case "ball" -> new PointHull(point(n, at, 0, 0, 0), n[at]);
      case "capsule" -> {
        double[] ends = Arrays.copyOf(low, 6);
        System.arraycopy(high, 0, ends, 3, 3);
        yield new PointHull(ends, n[at]);
      }
      default -> throw new IllegalArgumentException(kind);
    };
  }

  private static ConvexShape box(double[] n, int at) {
    double[] corners = new double[24];
    for (int i = 0; i < 8; i++) {
      double x = ((i & 1) - 0.5) * n[at];
      double y = (((i >> 1) & 1) - 0.5) * n[at + 1];
      double z = ((i >> 2) - 0.5) * n[at + 2];
      System.arraycopy(point(n, at, x, y, z), 0, corners, 3 * i, 3);
    }
    return new PointHull(corners, 0);
  }

  private static double[] point(double[] n, int at, double x, double y, double z) {
    double[] placed = new double[3];
    for (int i = 0; i < 3; i++) {
      int row = at + 3 + 3 * i;
      placed[i] = n[row] * x + n[row + 1] * y + n[row + 2] * z + n[at + 12 + i];
    }
    return placed;
  }
}
