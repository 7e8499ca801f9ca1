package org.mechservice.solver.kinematics.pair;

import java.util.Arrays;
import org.mechservice.solver.kinematics.TreeGeometry;

/**
 * Derivatives of the two wrenches of a moment and force between bodies by motions of the bodies.
 * Workspace of one thread.
 *
 * <p>With g = [m; f] on B at its point in A's axes, small twists t = [φ; x] of the links in their
 * own axes make δ = [δθ; δρ] = D_A t_A + D_B t_B, and the wrenches are D_Aᵀ g and D_Bᵀ g. Then
 *
 * <pre>
 * δw_B = D_Bᵀ (C + Q) δ,  Q = [m×, 0; f×, 0]      B's axes turn
 * δw_A = (D_Aᵀ C + E) δ,  E = [0, f×; 0, 0]       the force moves along A
 * D_A = −[1, 0; −r×, 1], r = from A's reference point to B's point
 * D_B = [R, 0; −R s×, R], s = from B's reference point to B's point
 * </pre>
 */
public final class PairLinearisation {
  private final double[] ofA = new double[36];
  private final double[] ofB = new double[36];
  private final double[] changeOnA = new double[36];
  private final double[] changeOnB = new double[36];
  private final double[] work = new double[36];
  private final double[] block = new double[36];
  private final double[] r = new double[3];

  /** Receives the derivative of the wrench on one link by the twist of a link, 6 × 6 row by row. */
  public interface Sink {
    /** Adds a block; the array is reused afterwards. */
    void add(int on, int by, double[] byTwist);
  }

  /**
   * Passes on all blocks that do not involve the root.
   *
   * @param gradient g; not modified
   * @param curvature C = ∂g/∂δ, 6 × 6; not modified
   */
  public void blocks(RelativeMotion pair, double[] gradient, double[] curvature, Sink sink) {
    formTwists(pair);
    System.arraycopy(curvature, 0, work, 0, 36);
    addCrossBlock(work, 0, gradient, 0);
    addCrossBlock(work, 18, gradient, 3);
    multiplyTransposed(ofB, work, changeOnB);
    multiplyTransposed(ofA, curvature, changeOnA);
    addCrossBlock(changeOnA, 3, gradient, 3);
    give(pair.linkA, pair.linkA, changeOnA, ofA, sink);
    give(pair.linkA, pair.linkB, changeOnA, ofB, sink);
    give(pair.linkB, pair.linkA, changeOnB, ofA, sink);
    give(pair.linkB, pair.linkB, changeOnB, ofB, sink);
  }

  private void give(int on, int by, double[] change, double[] twist, Sink sink) {
    if (on == TreeGeometry.ROOT || by == TreeGeometry.ROOT) {
      return;
    }
    for (int i = 0; i < 6; i++) {
      for (int j = 0; j < 6; j++) {
        double sum = 0;
        for (int k = 0; k < 6; k++) {
          sum += change[6 * i + k] * twist[6 * k + j];
        }
        block[6 * i + j] = sum;
      }
    }
    sink.add(on, by, block);
  }

  private void formTwists(RelativeMotion pair) {
    Arrays.fill(ofA, 0);
    Arrays.fill(ofB, 0);
    for (int i = 0; i < 3; i++) {
      r[i] = pair.pointA[i] + pair.position[i];
      ofA[7 * i] = -1;
      ofA[7 * (i + 3)] = -1;
      for (int j = 0; j < 3; j++) {
        ofB[6 * i + j] = pair.rotation[3 * i + j];
        ofB[6 * (i + 3) + j + 3] = pair.rotation[3 * i + j];
      }
    }
    addCrossBlock(ofA, 18, r, 0);
    // −R s×: row i is −(row i of R) × … = s × (row i of R), since rᵀ s× = (r × s)ᵀ
    double[] s = pair.pointB;
    for (int i = 0; i < 3; i++) {
      double x = pair.rotation[3 * i];
      double y = pair.rotation[3 * i + 1];
      double z = pair.rotation[3 * i + 2];
      ofB[6 * (i + 3)] = s[1] * z - s[2] * y;
      ofB[6 * (i + 3) + 1] = s[2] * x - s[0] * z;
      ofB[6 * (i + 3) + 2] = s[0] * y - s[1] * x;
    }
  }

  /** Adds v× to the 3 × 3 block of a 6 × 6 matrix that begins at an element. */
  private static void addCrossBlock(double[] matrix, int at, double[] v, int vAt) {
    matrix[at + 1] -= v[vAt + 2];
    matrix[at + 2] += v[vAt + 1];
    matrix[at + 6] += v[vAt + 2];
    matrix[at + 8] -= v[vAt];
    matrix[at + 12] -= v[vAt + 1];
    matrix[at + 13] += v[vAt];
  }

  private static void multiplyTransposed(double[] a, double[] b, double[] product) {
    for (int i = 0; i < 6; i++) {
      for (int j = 0; j < 6; j++) {
        double sum = 0;
        for (int k = 0; k < 6; k++) {
          sum += a[6 * k + i] * b[6 * k + j];
        }
        product[6 * i + j] = sum;
      }
    }
  }
}
