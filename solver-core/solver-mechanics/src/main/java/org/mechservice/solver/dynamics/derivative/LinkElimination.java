package org.mechservice.solver.dynamics.derivative;

import static org.mechservice.solver.dynamics.derivative.PlacedLinks.BLOCK;
import static org.mechservice.solver.dynamics.derivative.PlacedLinks.WIDTH;
import static org.mechservice.solver.dynamics.derivative.PlacedLinks.add;
import static org.mechservice.solver.dynamics.derivative.PlacedLinks.dot6;
import static org.mechservice.solver.dynamics.derivative.PlacedLinks.multiply;

import java.util.Arrays;
import org.mechservice.solver.kinematics.TreeGeometry;

/**
 * The equations of the joints of {@link ArticulatedIteration}, whose symbols these are, solved one
 * after the other from the leaves to the root, as articulated inertias are (Featherstone 2008, ch.
 * 7). Workspace of one thread.
 */
final class LinkElimination {
  /** As in factors along the tree: at most three digits are lost beyond the condition. */
  private static final double GROWTH_ALLOWED = 1e3;

  private final LinkJacobian jacobian;
  private final PlacedLinks links;

  /** Z as eliminated. */
  private final double[] z;

  /** Sᵀ Pᴬ by the parent's motion, 18 for each velocity. */
  private final double[] row;

  /** Rows of (Sᵀ Pᴬ Z + D)⁻¹, three for each velocity. */
  private final double[] inverse;

  /**
   * Wrench that a change of the velocity exerts on the parent, 6 for each, in the parent's axes.
   */
  private final double[] push;

  /** Pᴬ, 6 × 18 for each link. */
  private final double[] articulated;

  private final double[] pivots = new double[9];
  private final double[] inverted = new double[9];
  private final double[] solution = new double[3];
  private final double[] lever = new double[18];
  private final double[] largest = new double[3];

  /** Sweeps: 18 for each link, and 6. */
  private final double[] moved;

  private final double[] wrench;
  private final double[] work = new double[WIDTH];

  /** Makes a workspace for derivatives that are evaluated elsewhere, between neighbours alone. */
  LinkElimination(LinkJacobian jacobian) {
    this.jacobian = jacobian;
    links = jacobian.links;
    z = new double[WIDTH * links.tree.velocityCount];
    row = new double[WIDTH * links.tree.velocityCount];
    inverse = new double[3 * links.tree.velocityCount];
    push = new double[6 * links.tree.velocityCount];
    articulated = new double[BLOCK * links.tree.linkCount];
    moved = new double[WIDTH * links.tree.linkCount];
    wrench = new double[6 * links.tree.linkCount];
  }

  /** Eliminates; returns false if a pivot vanishes or digits are lost. */
  boolean eliminate(LinkColumns columns) {
    System.arraycopy(columns.motion, 0, z, 0, z.length);
    System.arraycopy(jacobian.own, 0, articulated, 0, articulated.length);
    for (int link = links.tree.linkCount - 1; link >= 0; link--) {
      if (!eliminate(link, columns)) {
        return false;
      }
    }
    return true;
  }

  private boolean eliminate(int link, LinkColumns columns) {
    int first = links.first(link);
    int count = links.end(link) - first;
    int parent = links.tree.parent[link];
    for (int k = first; k < first + count; k++) {
      multiply(articulated, link, z, WIDTH * k, push, 6 * k);
      for (int j = 0; j < count; j++) {
        pivots[count * j + k - first] =
            dot6(links.subspace, 6 * (first + j), push, 6 * k) + columns.force[3 * k + j];
      }
      add(columns.wrench, 6 * k, 1, push, 6 * k);
    }
    if (!invert(count)) {
      return false;
    }
    for (int k = 0; k < count; k++) {
      System.arraycopy(inverted, count * k, inverse, 3 * (first + k), count);
    }
    if (parent == TreeGeometry.ROOT) {
      return true;
    }
    rowsToParent(link);
    if (jacobian.coupled[link]) {
      for (int i = BLOCK * link; i < BLOCK * (link + 1); i++) {
        articulated[i] += jacobian.byParent[i];
      }
    }
    for (int j = first; j < first + count; j++) {
      formRow(link, j);
    }
    columnsToParent(link);
    for (int k = first; k < first + count; k++) {
      links.toParent(link, push, 6 * k);
      if (jacobian.coupled[link]) {
        multiply(jacobian.onParent, link, z, WIDTH * k, work, 0);
        add(work, 0, 1, push, 6 * k);
      }
    }
    if (!subtract(link, first, count)) {
      return false;
    }
    for (int i = 0; i < BLOCK; i++) {
      articulated[BLOCK * parent + i] += articulated[BLOCK * link + i];
    }
    return true;
  }

  /** Sᵀ Pᴬ. */
  private void formRow(int link, int j) {
    for (int c = 0; c < WIDTH; c++) {
      double sum = 0;
      for (int r = 0; r < 6; r++) {
        sum += links.subspace[6 * j + r] * articulated[BLOCK * link + WIDTH * r + c];
      }
      row[WIDTH * j + c] = sum;
    }
  }

  /** Rows that multiply z of the link become rows that multiply that of its parent. */
  private void rowsToParent(int link) {
    for (int i = BLOCK * link; i < BLOCK * (link + 1); i += 6) {
      links.toParent(link, articulated, i);
    }
  }

  /** Wrenches on the link become wrenches on its parent. */
  private void columnsToParent(int link) {
    for (int c = 0; c < WIDTH; c++) {
      for (int r = 0; r < 6; r++) {
        work[r] = articulated[BLOCK * link + WIDTH * r + c];
      }
      links.toParent(link, work, 0);
      for (int r = 0; r < 6; r++) {
        articulated[BLOCK * link + WIDTH * r + c] = work[r];
      }
    }
    if (jacobian.coupled[link]) {
      for (int r = 0; r < 6; r++) {
        System.arraycopy(jacobian.onParent, BLOCK * link + WIDTH * r, work, 0, WIDTH);
        for (int c = 0; c < WIDTH; c += 6) {
          links.toParent(link, work, c);
        }
        for (int c = 0; c < WIDTH; c++) {
          articulated[BLOCK * link + WIDTH * r + c] += work[c];
        }
      }
    }
  }

  /** Pᴬ −= push (Sᵀ Pᴬ Z + D)⁻¹ Sᵀ Pᴬ; returns false if that is too large beside Pᴬ. */
  private boolean subtract(int link, int first, int count) {
    for (int j = 0; j < count; j++) {
      double size = 0;
      for (int c = 0; c < WIDTH; c++) {
        size = Math.max(size, Math.abs(row[WIDTH * (first + j) + c]));
      }
      largest[j] = size;
    }
    for (int r = 0; r < 6; r++) {
      for (int j = 0; j < count; j++) {
        double sum = 0;
        for (int k = 0; k < count; k++) {
          sum += push[6 * (first + k) + r] * inverse[3 * (first + k) + j];
        }
        lever[3 * r + j] = sum;
      }
    }
    for (int block = 0; block < 6; block += 3) {
      double allowed = GROWTH_ALLOWED * largest(link, block);
      for (int r = block; r < block + 3; r++) {
        for (int j = 0; j < count; j++) {
          if (!(Math.abs(lever[3 * r + j]) * largest[j] <= allowed)) {
            return false;
          }
        }
      }
    }
    for (int r = 0; r < 6; r++) {
      int at = BLOCK * link + WIDTH * r;
      for (int j = 0; j < count; j++) {
        double factor = lever[3 * r + j];
        for (int c = 0; c < WIDTH; c++) {
          articulated[at + c] -= factor * row[WIDTH * (first + j) + c];
        }
      }
    }
    return true;
  }

  /** Returns the largest element of three rows of Pᴬ. */
  private double largest(int link, int block) {
    double size = 0;
    int from = BLOCK * link + WIDTH * block;
    for (int i = from; i < from + 3 * WIDTH; i++) {
      size = Math.max(size, Math.abs(articulated[i]));
    }
    return size;
  }

  /** Inverts up to three equations with interchanges of rows; returns whether they are regular. */
  private boolean invert(int count) {
    Arrays.fill(inverted, 0);
    for (int i = 0; i < count; i++) {
      inverted[count * i + i] = 1;
    }
    for (int k = 0; k < count; k++) {
      int pivot = k;
      for (int i = k + 1; i < count; i++) {
        if (Math.abs(pivots[count * i + k]) > Math.abs(pivots[count * pivot + k])) {
          pivot = i;
        }
      }
      double size = Math.abs(pivots[count * pivot + k]);
      if (!(size >= Double.MIN_NORMAL && size < Double.POSITIVE_INFINITY)) {
        return false;
      }
      swap(pivots, count, k, pivot);
      swap(inverted, count, k, pivot);
      for (int i = 0; i < count; i++) {
        double factor = i == k ? 0 : pivots[count * i + k] / pivots[count * k + k];
        for (int c = 0; c < count; c++) {
          pivots[count * i + c] -= factor * pivots[count * k + c];
          inverted[count * i + c] -= factor * inverted[count * k + c];
        }
      }
    }
    for (int i = 0; i < count; i++) {
      double pivot = pivots[count * i + i];
      for (int c = 0; c < count; c++) {
        inverted[count * i + c] /= pivot;
      }
    }
    return true;
  }

  private static void swap(double[] matrix, int count, int i, int j) {
    for (int c = 0; c < count; c++) {
      double kept = matrix[count * i + c];
      matrix[count * i + c] = matrix[count * j + c];
      matrix[count * j + c] = kept;
    }
  }

  /** Solves in place. */
  void solve(double[] b) {
    Arrays.fill(wrench, 0);
    for (int link = links.tree.linkCount - 1; link >= 0; link--) {
      int first = links.first(link);
      int count = links.end(link) - first;
      for (int j = 0; j < count; j++) {
        solution[j] = b[first + j] - dot6(links.subspace, 6 * (first + j), wrench, 6 * link);
      }
      for (int k = first; k < first + count; k++) {
        b[k] = ofSolution(k, count);
      }
      int parent = links.tree.parent[link];
      if (parent != TreeGeometry.ROOT) {
        links.toParent(link, wrench, 6 * link);
        add(wrench, 6 * link, 1, wrench, 6 * parent);
        for (int k = first; k < first + count; k++) {
          add(push, 6 * k, b[k], wrench, 6 * parent);
        }
      }
    }
    for (int link = 0; link < links.tree.linkCount; link++) {
      substitute(link, b);
    }
  }

  private void substitute(int link, double[] b) {
    int first = links.first(link);
    int count = links.end(link) - first;
    int parent = links.tree.parent[link];
    if (parent != TreeGeometry.ROOT) {
      for (int j = 0; j < count; j++) {
        double sum = 0;
        for (int c = 0; c < WIDTH; c++) {
          sum += row[WIDTH * (first + j) + c] * moved[WIDTH * parent + c];
        }
        solution[j] = sum;
      }
      for (int k = first; k < first + count; k++) {
        b[k] -= ofSolution(k, count);
      }
    }
    links.carry(link, moved);
    for (int k = first; k < first + count; k++) {
      for (int i = 0; i < WIDTH; i++) {
        moved[WIDTH * link + i] += z[WIDTH * k + i] * b[k];
      }
    }
  }

  private double ofSolution(int k, int count) {
    double sum = 0;
    for (int j = 0; j < count; j++) {
      sum += inverse[3 * k + j] * solution[j];
    }
    return sum;
  }
}
