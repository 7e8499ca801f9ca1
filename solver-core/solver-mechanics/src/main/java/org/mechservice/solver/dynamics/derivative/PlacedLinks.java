package org.mechservice.solver.dynamics.derivative;

import static org.mechservice.solver.spatial.Blocks.addCross;
import static org.mechservice.solver.spatial.Blocks.apply;
import static org.mechservice.solver.spatial.Blocks.applyTransposed;

import java.util.Arrays;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;

/**
 * The links of a tree where derivatives were taken, while {@link TreeMotion} moves on, and how
 * motions and wrenches go from link to link. Motions z = [a; b; ξ] have 18 numbers for a link: what
 * changes in its acceleration, velocity and place, in its axes. Wrenches w = [f; n] are about the
 * origin of the link.
 */
final class PlacedLinks {
  /** Numbers of a motion. */
  static final int WIDTH = 18;

  /** Elements of a matrix that gives a wrench for a motion. */
  static final int BLOCK = 6 * WIDTH;

  final TreeGeometry tree;

  /** Rotations, 9 for each link, and positions in the parent, 3 for each, as in the motion. */
  final double[] rotation;

  final double[] position;

  /** Columns S, 6 for each velocity. */
  final double[] subspace;

  private final double[] triple = new double[3];

  PlacedLinks(TreeGeometry tree) {
    this.tree = tree;
    rotation = new double[9 * tree.linkCount];
    position = new double[3 * tree.linkCount];
    subspace = new double[6 * tree.velocityCount];
  }

  /** Takes the places of the links from a motion that has been swept. */
  void placeAt(TreeMotion motion) {
    System.arraycopy(motion.rotation, 0, rotation, 0, rotation.length);
    System.arraycopy(motion.position, 0, position, 0, position.length);
    System.arraycopy(motion.subspace, 0, subspace, 0, subspace.length);
  }

  /** Returns the first velocity of a link. */
  int first(int link) {
    return tree.velocityAt[link];
  }

  /** Returns the velocity behind the last of a link; the first itself where its joint is driven. */
  int end(int link) {
    return tree.driven[link]
        ? tree.velocityAt[link]
        : tree.velocityAt[link] + tree.kind[link].velocityCount();
  }

  /** Writes z of the parent, seen at the link in its axes; zero at the root. */
  void carry(int link, double[] z) {
    int parent = tree.parent[link];
    int to = WIDTH * link;
    if (parent == TreeGeometry.ROOT) {
      Arrays.fill(z, to, to + WIDTH, 0);
      return;
    }
    for (int i = 0; i < WIDTH; i += 6) {
      int from = WIDTH * parent + i;
      applyTransposed(rotation, 9 * link, z, from, z, to + i);
      System.arraycopy(z, from + 3, triple, 0, 3);
      addCross(z, from, position, 3 * link, triple, 0);
      applyTransposed(rotation, 9 * link, triple, 0, z, to + i + 3);
    }
  }

  /** Refers a wrench to the parent of a link: f_p = R f, n_p = R n + p × f_p. */
  void toParent(int link, double[] w, int at) {
    apply(rotation, 9 * link, w, at + 3, triple, 0);
    System.arraycopy(triple, 0, w, at + 3, 3);
    apply(rotation, 9 * link, w, at, triple, 0);
    System.arraycopy(triple, 0, w, at, 3);
    addCross(position, 3 * link, w, at + 3, w, at);
  }

  /** Writes the product of a link's 6 × 18 matrix. */
  static void multiply(double[] matrix, int link, double[] z, int at, double[] out, int to) {
    int element = BLOCK * link;
    for (int r = 0; r < 6; r++) {
      double sum = 0;
      for (int c = 0; c < WIDTH; c++) {
        sum += matrix[element++] * z[at + c];
      }
      out[to + r] = sum;
    }
  }

  /** Writes the row [x y z] [ω]×. */
  static void turn(double x, double y, double z, double[] omega, int at, double[] out) {
    out[0] = y * omega[at + 2] - z * omega[at + 1];
    out[1] = z * omega[at] - x * omega[at + 2];
    out[2] = x * omega[at + 1] - y * omega[at];
  }

  static void add(double[] x, int at, double factor, double[] sum, int to) {
    for (int i = 0; i < 6; i++) {
      sum[to + i] += factor * x[at + i];
    }
  }

  static double sum(double[] numbers) {
    double sum = 0;
    for (double number : numbers) {
      sum += number;
    }
    return sum;
  }

  static double dot6(double[] a, int ia, double[] b, int ib) {
    double sum = 0;
    for (int i = 0; i < 6; i++) {
      sum += a[ia + i] * b[ib + i];
    }
    return sum;
  }
}
