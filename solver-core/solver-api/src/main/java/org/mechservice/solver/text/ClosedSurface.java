package org.mechservice.solver.text;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.StringJoiner;
import java.util.StringTokenizer;

/**
 * A closed surface of triangles in STL, text or binary: the volume inside, its centre and its
 * moments of inertia at density 1, as sums over the tetrahedra between a point and each triangle.
 * They are exact for the polyhedron, whatever the point, because the surface is closed.
 *
 * <p>A surface is closed if every edge is passed as often in one direction as in the other. Corners
 * are the same if their coordinates are equal.
 */
final class ClosedSurface {
  private static final int HEADER = 84;
  private static final int FACET = 50;

  /** Corners of the triangles, three numbers each. */
  private final List<double[]> corners = new ArrayList<>();

  private final Path file;
  private final String hash;
  private double volume;
  private final double[] center = new double[3];

  /** Second moments ∫ x y dV about the centre: xx, yy, zz, xy, xz, yz. */
  private final double[] second = new double[6];

  private ClosedSurface(Path file, byte[] content) throws IOException {
    this.file = file;
    this.hash = Sha256.of(content);
    readCorners(content);
    requireClosed();
    integrate();
  }

  /**
   * Reads a file.
   *
   * @throws IOException if it cannot be read, is no STL, is open or encloses no volume
   */
  static ClosedSurface read(Path file) throws IOException {
    return new ClosedSurface(file, Files.readAllBytes(file));
  }

  /** Returns the attributes of {@code mesh} that say what it encloses, in the file's unit. */
  String attributes() {
    double xx = second[0];
    double yy = second[1];
    double zz = second[2];
    return " volume=\""
        + ShortestDecimal.format(volume)
        + "\" center=\""
        + list(center)
        + "\" moments=\""
        + list(yy + zz, xx + zz, xx + yy, -second[3], -second[4], -second[5])
        + "\" sha256=\""
        + hash
        + "\"";
  }

  private static String list(double... values) {
    StringJoiner list = new StringJoiner(";");
    for (double value : values) {
      list.add(ShortestDecimal.format(value));
    }
    return list.toString();
  }

  private void readCorners(byte[] content) throws IOException {
    // A binary file may begin with "solid" too; its length tells it.
    if (content.length >= HEADER) {
      ByteBuffer bytes = ByteBuffer.wrap(content).order(ByteOrder.LITTLE_ENDIAN);
      long facets = Integer.toUnsignedLong(bytes.getInt(HEADER - 4));
      if (HEADER + FACET * facets == content.length) {
        for (int at = HEADER + 12; at < content.length; at += FACET) {
          for (int i = at; i < at + 36; i += 12) {
            add(bytes.getFloat(i), bytes.getFloat(i + 4), bytes.getFloat(i + 8));
          }
        }
        return;
      }
    }
    StringTokenizer words = new StringTokenizer(new String(content, StandardCharsets.US_ASCII));
    if (!words.hasMoreTokens() || !words.nextToken().equalsIgnoreCase("solid")) {
      throw unusable(
          "it is no STL: neither begins it with \"solid\" nor does its length fit a binary one");
    }
    while (words.hasMoreTokens()) {
      if (words.nextToken().equalsIgnoreCase("vertex")) {
        add(number(words), number(words), number(words));
      }
    }
    if (corners.size() % 3 != 0) {
      throw unusable("its last triangle is cut off");
    }
  }

  private double number(StringTokenizer words) throws IOException {
    String word = words.hasMoreTokens() ? words.nextToken() : "";
    try {
      return Double.parseDouble(word);
    } catch (NumberFormatException e) {
      throw unusable("\"" + word + "\" stands in place of a coordinate");
    }
  }

  private void add(double x, double y, double z) throws IOException {
    if (!Double.isFinite(x) || !Double.isFinite(y) || !Double.isFinite(z)) {
      throw unusable("a coordinate is not finite");
    }
    // The sum turns -0 into 0, so that equal corners are equal.
    corners.add(new double[] {x + 0.0, y + 0.0, z + 0.0});
  }

  private void requireClosed() throws IOException {
    Map<List<Double>, Integer> numbers = new HashMap<>();
    int[] number = new int[corners.size()];
    for (int i = 0; i < number.length; i++) {
      double[] c = corners.get(i);
      Integer known = numbers.putIfAbsent(List.of(c[0], c[1], c[2]), numbers.size());
      number[i] = known == null ? numbers.size() - 1 : known;
    }
    Map<Long, Integer> passes = new HashMap<>();
    for (int i = 0; i < number.length; i++) {
      int next = i % 3 == 2 ? i - 2 : i + 1;
      long low = Math.min(number[i], number[next]);
      long high = Math.max(number[i], number[next]);
      passes.merge(low << 32 | high, Integer.compare(number[next], number[i]), Integer::sum);
    }
    long open = passes.values().stream().filter(balance -> balance != 0).count();
    for (int i = 0; open > 0 && i < number.length; i++) {
      int next = i % 3 == 2 ? i - 2 : i + 1;
      long low = Math.min(number[i], number[next]);
      long high = Math.max(number[i], number[next]);
      if (passes.getOrDefault(low << 32 | high, 0) != 0) {
        throw unusable(
            "its surface is not closed, or neighbouring triangles are not oriented alike: "
                + open
                + (open == 1 ? " edge is" : " edges are")
                + " concerned, the first from ("
                + list(corners.get(i))
                + ") to ("
                + list(corners.get(next))
                + "); repair it in the program that wrote it, or give mass, cog and inertiaTensor");
      }
    }
  }

  private void integrate() throws IOException {
    double[] from = new double[3];
    for (double[] corner : corners) {
      for (int i = 0; i < 3; i++) {
        from[i] += corner[i] / corners.size();
      }
    }
    double[] first = new double[3];
    for (int i = 0; i < corners.size(); i += 3) {
      double[] a = minus(corners.get(i), from);
      double[] b = minus(corners.get(i + 1), from);
      double[] c = minus(corners.get(i + 2), from);
      double v =
          (a[0] * (b[1] * c[2] - b[2] * c[1])
                  + a[1] * (b[2] * c[0] - b[0] * c[2])
                  + a[2] * (b[0] * c[1] - b[1] * c[0]))
              / 6;
      volume += v;
      double[] sum = {a[0] + b[0] + c[0], a[1] + b[1] + c[1], a[2] + b[2] + c[2]};
      for (int k = 0; k < 3; k++) {
        first[k] += v * sum[k] / 4;
      }
      // ∫ x y dV of a tetrahedron with a corner at the origin: V/20 (Σx Σy + Σ x y).
      for (int k = 0; k < 6; k++) {
        int p = k < 3 ? k : k == 5 ? 1 : 0;
        int q = k < 3 ? k : k == 3 ? 1 : 2;
        second[k] += v / 20 * (sum[p] * sum[q] + a[p] * a[q] + b[p] * b[q] + c[p] * c[q]);
      }
    }
    if (volume == 0 || !Double.isFinite(1 / volume)) {
      throw unusable("it encloses no volume");
    }
    double sign = Math.signum(volume);
    volume *= sign;
    for (int k = 0; k < 3; k++) {
      first[k] *= sign / volume;
      center[k] = from[k] + first[k];
    }
    for (int k = 0; k < 6; k++) {
      int p = k < 3 ? k : k == 5 ? 1 : 0;
      int q = k < 3 ? k : k == 3 ? 1 : 2;
      second[k] = sign * second[k] - volume * first[p] * first[q];
    }
  }

  private static double[] minus(double[] a, double[] b) {
    return new double[] {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }

  private FileSystemException unusable(String why) {
    return new FileSystemException(file.toString(), null, why);
  }
}
