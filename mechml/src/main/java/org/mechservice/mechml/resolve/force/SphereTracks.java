package org.mechservice.mechml.resolve.force;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.DoubleFunction;
import org.mechservice.solver.expression.Table;

/**
 * The curves on which the centre of a sphere moves while it touches a profile, for profiles that
 * bend more than the sphere.
 *
 * <p>A sphere of radius R that touches the place s of the curve z = h(s), with the angle of slope
 * θ, has its centre at x = s − R sin θ, z = h + R cos θ. Along the curve x grows where the sphere
 * can touch; it falls where a hollow bends more than the sphere, which bridges it. So the offset
 * curve has <em>branches</em>, the stretches on which x grows. On a convex corner the centre moves
 * on an arc; at a concave one a branch ends and the next begins. The sphere rests on the upper
 * envelope of the branches, and on two of them at once where these cross.
 *
 * <p>A <em>track</em> is one height over x that joins branches which lie apart. Neighbouring
 * branches lie on different tracks, so that both push where the sphere is in a corner; a corner
 * that the sphere bridges by less than 1e-4 of its radius is one branch with a bend. Beyond its end
 * a branch goes on straight, as the surface does to which it belongs, to where it is deepest below
 * the envelope, and falls off.
 */
final class SphereTracks {
  /** Least depth of the bridged hollow that parts two branches, by the radius. */
  private static final double HOLLOW = 1e-4;

  /** Largest distance of a cubic from the true offset curve, by the radius. */
  private static final double ACCURACY = 1e-7;

  /** Largest turn between two points, rad. */
  private static final double TURN = 0.1;

  /** Parts of a piece that are looked at in any case: an S has no turn from end to end. */
  private static final int PARTS = 8;

  private static final int HALVINGS = 12;

  /** Distance of sampled slopes from a break, by the length of the piece. */
  private static final double BESIDE = 1e-9;

  /** Places in which the end of a branch is sought, over twice the radius. */
  private static final int PLACES = 32;

  private final HeightPieces height;
  private final double radius;
  private final List<Node> nodes = new ArrayList<>();
  private final List<Branch> branches = new ArrayList<>();

  private SphereTracks(HeightPieces height, double radius) {
    this.height = height;
    this.radius = radius;
  }

  /**
   * Returns the tracks, from the left.
   *
   * @param radius R &gt; 0, m
   */
  static List<Track> of(HeightPieces height, double radius) {
    SphereTracks tracks = new SphereTracks(height, radius);
    tracks.sample();
    tracks.part();
    tracks.dropBuried();
    tracks.merge();
    return tracks.join();
  }

  /** A place of the centre. */
  private record Node(double x, double z, double slope) {}

  /** A curve of cubics through nodes, x ascending. */
  private static final class Branch {
    private final List<Node> nodes;

    Branch(List<Node> nodes) {
      this.nodes = nodes;
    }

    Node first() {
      return nodes.get(0);
    }

    Node last() {
      return nodes.get(nodes.size() - 1);
    }

    boolean covers(double x) {
      return x >= first().x() && x <= last().x();
    }

    /** Returns the node at x, between the first and the last. */
    Node at(double x) {
      int low = 0;
      int high = nodes.size() - 1;
      while (high - low > 1) {
        int middle = (low + high) / 2;
        if (nodes.get(middle).x() <= x) {
          low = middle;
        } else {
          high = middle;
        }
      }
      return cubic(nodes.get(low), nodes.get(high), x);
    }
  }

  /**
   * A track.
   *
   * @param x places, ascending
   * @param z heights of the centre
   * @param slope slopes
   * @param bounded whether it has no values beyond its ends
   */
  record Track(List<Double> x, List<Double> z, List<Double> slope, boolean bounded) {
    Table table(String name) {
      return Table.hermite(
          name, x, z, slope, bounded ? Table.Extrapolation.ERROR : Table.Extrapolation.LINEAR);
    }
  }

  private static Node cubic(Node a, Node b, double x) {
    double width = b.x() - a.x();
    double d = x - a.x();
    double chord = (b.z() - a.z()) / width;
    double c2 = (3 * chord - 2 * a.slope() - b.slope()) / width;
    double c3 = (a.slope() + b.slope() - 2 * chord) / (width * width);
    double z = a.z() + d * (a.slope() + d * (c2 + d * c3));
    return new Node(x, z, a.slope() + d * (2 * c2 + 3 * d * c3));
  }

  private Node node(double s, double angle) {
    return new Node(
        s - radius * StrictMath.sin(angle),
        height.value(s) + radius * StrictMath.cos(angle),
        StrictMath.tan(angle));
  }

  private double angle(double s) {
    return StrictMath.atan(height.slope(s));
  }

  /** Samples the offset curve along the surface. */
  private void sample() {
    double[] breaks = height.breaks();
    int last = breaks.length - 1;
    double outside = 4 * radius;
    double before = 0;
    for (int i = height.isBounded() ? 1 : 0; i <= (height.isBounded() ? last : last + 1); i++) {
      double from = i == 0 ? breaks[0] - outside : breaks[i - 1];
      double to = i > last ? breaks[last] + outside : breaks[i];
      double beside = BESIDE * (to - from);
      double start = angle(from + beside);
      if (!nodes.isEmpty() && start < before) {
        double place = from;
        double turned = before;
        double turn = start - before;
        add(u -> node(place, turned + u * turn));
      }
      add(u -> node(from + u * (to - from), angle(from + beside + u * (to - from - 2 * beside))));
      before = angle(to - beside);
    }
  }

  private void add(DoubleFunction<Node> curve) {
    Node start = curve.apply(0);
    nodes.add(start);
    for (int i = 1; i <= PARTS; i++) {
      double u = (double) i / PARTS;
      Node end = curve.apply(u);
      refine(curve, u - 1.0 / PARTS, start, u, end, HALVINGS);
      nodes.add(end);
      start = end;
    }
  }

  private void refine(
      DoubleFunction<Node> curve, double u1, Node first, double u2, Node second, int halvings) {
    double u = 0.5 * (u1 + u2);
    Node middle = curve.apply(u);
    if (halvings == 0 || isClose(first, middle, second)) {
      return;
    }
    refine(curve, u1, first, u, middle, halvings - 1);
    nodes.add(middle);
    refine(curve, u, middle, u2, second, halvings - 1);
  }

  private boolean isClose(Node first, Node middle, Node second) {
    if (turn(first, middle) > TURN || turn(middle, second) > TURN) {
      return false;
    }
    boolean ahead = middle.x() > first.x() && second.x() > middle.x();
    boolean back = middle.x() < first.x() && second.x() < middle.x();
    if (back) {
      return true;
    }
    if (!ahead) {
      return Math.abs(second.x() - first.x()) < ACCURACY * radius
          && Math.abs(middle.x() - first.x()) < ACCURACY * radius;
    }
    double off = cubic(first, second, middle.x()).z() - middle.z();
    double cosine = 1 / Math.sqrt(1 + middle.slope() * middle.slope());
    return Math.abs(off) * cosine < ACCURACY * radius;
  }

  private static double turn(Node first, Node second) {
    return Math.abs(StrictMath.atan(second.slope()) - StrictMath.atan(first.slope()));
  }

  /** Parts the offset curve into branches. */
  private void part() {
    List<Node> branch = new ArrayList<>();
    double least = 1e-12 * radius;
    for (Node node : nodes) {
      if (!branch.isEmpty()) {
        double ahead = node.x() - branch.get(branch.size() - 1).x();
        if (ahead < -least) {
          close(branch);
          branch = new ArrayList<>();
        } else if (ahead <= least + 1e-15 * Math.abs(node.x())) {
          continue;
        }
      }
      branch.add(node);
    }
    close(branch);
  }

  private void close(List<Node> branch) {
    if (branch.size() > 1) {
      branches.add(new Branch(branch));
    }
  }

  /** Drops branches that the sphere never reaches. */
  private void dropBuried() {
    List<Branch> reached = new ArrayList<>();
    for (Branch branch : branches) {
      boolean any = false;
      for (Node node : branch.nodes) {
        any |= node.z() >= envelope(node.x(), branch) - ACCURACY * radius;
      }
      if (any) {
        reached.add(branch);
      }
    }
    branches.clear();
    branches.addAll(reached);
  }

  /** Returns the height of the highest branch but one; −∞ where there is none. */
  private double envelope(double x, Branch without) {
    double highest = Double.NEGATIVE_INFINITY;
    for (Branch branch : branches) {
      if (branch != without && branch.covers(x)) {
        highest = Math.max(highest, branch.at(x).z());
      }
    }
    return highest;
  }

  /** Joins neighbours that cross in a shallow corner. */
  private void merge() {
    for (int i = 0; i + 1 < branches.size(); ) {
      Branch left = branches.get(i);
      Branch right = branches.get(i + 1);
      boolean cross = right.covers(left.last().x()) && left.covers(right.first().x());
      if (cross && isShallow(left, right)) {
        branches.set(i, joined(left, right));
        branches.remove(i + 1);
      } else {
        i++;
      }
    }
  }

  private boolean isShallow(Branch left, Branch right) {
    double endOfLeft = right.at(left.last().x()).z() - left.last().z();
    double startOfRight = left.at(right.first().x()).z() - right.first().z();
    return Math.max(endOfLeft, startOfRight) < HOLLOW * radius;
  }

  private Branch joined(Branch left, Branch right) {
    double low = right.first().x();
    double high = left.last().x();
    for (int i = 0; i < 60; i++) {
      double middle = 0.5 * (low + high);
      if (left.at(middle).z() > right.at(middle).z()) {
        low = middle;
      } else {
        high = middle;
      }
    }
    // the slope jumps between two points that lie ACCURACY apart
    double from = Math.max(left.first().x(), low - ACCURACY * radius);
    double to = Math.min(right.last().x(), high + ACCURACY * radius);
    List<Node> nodes = new ArrayList<>(left.nodes.stream().filter(n -> n.x() < from).toList());
    nodes.add(left.at(from));
    nodes.add(right.at(to));
    nodes.addAll(right.nodes.stream().filter(n -> n.x() > to).toList());
    return new Branch(nodes);
  }

  /** Places the branches on tracks. */
  private List<Track> join() {
    List<List<Branch>> tracks = new ArrayList<>();
    for (int i = 0; i < branches.size(); i++) {
      Branch whole = extended(i);
      int free = 0;
      while (free < tracks.size() && !isFree(tracks.get(free), whole)) {
        free++;
      }
      if (free == tracks.size()) {
        tracks.add(new ArrayList<>());
      }
      tracks.get(free).add(whole);
    }
    return tracks.stream().map(this::track).toList();
  }

  private static boolean isFree(List<Branch> track, Branch next) {
    return track.get(track.size() - 1).last().x() < next.first().x();
  }

  private Track track(List<Branch> parts) {
    List<Double> x = new ArrayList<>();
    List<Double> z = new ArrayList<>();
    List<Double> slope = new ArrayList<>();
    for (Branch branch : parts) {
      for (Node node : branch.nodes) {
        x.add(node.x());
        z.add(node.z());
        slope.add(node.slope());
      }
    }
    return new Track(x, z, slope, height.isBounded() && branches.size() == 1);
  }

  /** Returns a branch with its straight ends and what falls off behind them. */
  private Branch extended(int index) {
    Branch branch = branches.get(index);
    List<Node> all = new ArrayList<>();
    if (index > 0) {
      end(branch, branch.first(), -1, all);
      Collections.reverse(all);
    }
    all.addAll(branch.nodes);
    if (index + 1 < branches.size()) {
      end(branch, branch.last(), 1, all);
    }
    return new Branch(all);
  }

  private void end(Branch branch, Node from, int direction, List<Node> all) {
    double step = direction * 2 * radius / PLACES;
    Node deepest = from;
    double depth = 0;
    for (int i = 1; i <= PLACES; i++) {
      double x = from.x() + i * step;
      Node node = new Node(x, from.z() + (x - from.x()) * from.slope(), from.slope());
      double below = envelope(x, branch) - node.z();
      if (below < 0) {
        break;
      }
      if (below > depth) {
        depth = below;
        deepest = node;
      }
    }
    if (depth > 0) {
      all.add(deepest);
    }
    double lowest =
        branches.stream().flatMap(b -> b.nodes.stream()).mapToDouble(Node::z).min().orElse(0);
    double low = Math.min(lowest, deepest.z()) - 4 * radius;
    all.add(new Node(deepest.x() + step, low, 0));
  }
}
