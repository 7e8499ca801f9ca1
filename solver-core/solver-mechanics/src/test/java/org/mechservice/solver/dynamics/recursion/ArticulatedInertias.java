package org.mechservice.solver.dynamics.recursion;

import static org.mechservice.solver.spatial.Blocks.addCross;
import static org.mechservice.solver.spatial.Blocks.apply;
import static org.mechservice.solver.spatial.Blocks.applyTransposed;
import static org.mechservice.solver.spatial.Blocks.congruence;
import static org.mechservice.solver.spatial.Blocks.cross;
import static org.mechservice.solver.spatial.Blocks.crossColumns;

import java.util.Arrays;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;

/**
 * Articulated inertias [J, H; Hᵀ, M] and bias forces of the links, in link axes at their reference
 * points, and their transfer to the parent. Workspace of one thread.
 */
public final class ArticulatedInertias {
  private final TreeGeometry tree;
  private final LinkInertias rigid;
  private final TreeMotion motion;

  /** Blocks, 9 per link; kg·m², kg·m, kg. */
  private final double[] blockJ;

  private final double[] blockH;
  private final double[] blockM;

  /** Bias force, [moment; force], 6 per link. */
  final double[] bias;

  private final double[] work = new double[36];

  public ArticulatedInertias(TreeMotion motion, LinkInertias rigid) {
    tree = motion.tree();
    this.motion = motion;
    this.rigid = rigid;
    blockJ = new double[9 * tree.linkCount];
    blockH = new double[9 * tree.linkCount];
    blockM = new double[9 * tree.linkCount];
    bias = new double[6 * tree.linkCount];
  }

  /** Sets the link's own rigid-body inertia and no bias force. */
  public void startAtRest(int link) {
    int at = 9 * link;
    Arrays.fill(bias, 6 * link, 6 * link + 6, 0);
    if (rigid.massless[link]) {
      Arrays.fill(blockJ, at, at + 9, 0);
      Arrays.fill(blockH, at, at + 9, 0);
      Arrays.fill(blockM, at, at + 9, 0);
      return;
    }
    System.arraycopy(rigid.second, at, blockJ, at, 9);
    double x = rigid.moment[3 * link];
    double y = rigid.moment[3 * link + 1];
    double z = rigid.moment[3 * link + 2];
    double[] h = blockH;
    h[at] = 0;
    h[at + 1] = -z;
    h[at + 2] = y;
    h[at + 3] = z;
    h[at + 4] = 0;
    h[at + 5] = -x;
    h[at + 6] = -y;
    h[at + 7] = x;
    h[at + 8] = 0;
    Arrays.fill(blockM, at, at + 9, 0);
    blockM[at] = rigid.mass[link];
    blockM[at + 4] = rigid.mass[link];
    blockM[at + 8] = rigid.mass[link];
  }

  /** Writes Iᴬ x for x = [0; s]. */
  public void applyToSliding(int link, double[] s, int is, double[] out, int at) {
    apply(blockH, 9 * link, s, is, out, at);
    apply(blockM, 9 * link, s, is, out, at + 3);
  }

  /** Writes Iᴬ x for x = [s; 0]. */
  public void applyToTurning(int link, double[] s, int is, double[] out, int at) {
    apply(blockJ, 9 * link, s, is, out, at);
    applyTransposed(blockH, 9 * link, s, is, out, at + 3);
  }

  /** Writes Iᴬ x. */
  public void applyTo(int link, double[] x, int ix, double[] out, int at) {
    applyToTurning(link, x, ix, out, at);
    apply(blockH, 9 * link, x, ix + 3, work, 0);
    apply(blockM, 9 * link, x, ix + 3, work, 3);
    for (int i = 0; i < 6; i++) {
      out[at + i] += work[i];
    }
  }

  /** Iᴬ −= U D⁻¹ Uᵀ for one column U. */
  public void eliminate(int link, double[] u, int at, double perPivot) {
    for (int i = 0; i < 3; i++) {
      double angular = u[at + i] * perPivot;
      double linear = u[at + 3 + i] * perPivot;
      for (int j = 0; j < 3; j++) {
        blockJ[9 * link + 3 * i + j] -= angular * u[at + j];
        blockH[9 * link + 3 * i + j] -= angular * u[at + 3 + j];
        blockM[9 * link + 3 * i + j] -= linear * u[at + 3 + j];
      }
    }
  }

  /** Adds X* Iᴬ X and X* p to the parent; overwrites those of the link. */
  public void addToParent(int link) {
    rotateToParentAxes(link);
    shiftToParentPoint(link);
  }

  private void rotateToParentAxes(int link) {
    double[] r = motion.rotation;
    congruence(r, 9 * link, blockJ, 9 * link, blockJ, 9 * link, work, 0);
    congruence(r, 9 * link, blockH, 9 * link, blockH, 9 * link, work, 0);
    congruence(r, 9 * link, blockM, 9 * link, blockM, 9 * link, work, 0);
    rotateInPlace(r, 9 * link, bias, 6 * link);
    rotateInPlace(r, 9 * link, bias, 6 * link + 3);
  }

  private void rotateInPlace(double[] r, int ir, double[] v, int iv) {
    apply(r, ir, v, iv, work, 0);
    System.arraycopy(work, 0, v, iv, 3);
  }

  /**
   * Moves the inertia from the link's point to the parent's and adds it: with the point at p, H_p =
   * H + [p]× M, J_p = J + [p]× Hᵀ + ([p]× Hᵀ)ᵀ − [p]× M [p]×.
   */
  private void shiftToParentPoint(int link) {
    int parent = tree.parent[link];
    double[] p = motion.position;
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        work[3 * i + j] = blockH[9 * link + 3 * j + i];
      }
    }
    crossColumns(p, 3 * link, work, 0, work, 27);
    crossColumns(p, 3 * link, blockM, 9 * link, work, 0);
    for (int i = 0; i < 3; i++) {
      // −[p]× M [p]×, row i: p × (row i of [p]× M)
      cross(p, 3 * link, work, 3 * i, work, 9 + 3 * i);
    }
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        int ij = 3 * i + j;
        blockJ[9 * parent + ij] +=
            blockJ[9 * link + ij] + work[27 + ij] + work[27 + 3 * j + i] + work[9 + ij];
        blockH[9 * parent + ij] += blockH[9 * link + ij] + work[ij];
        blockM[9 * parent + ij] += blockM[9 * link + ij];
      }
      bias[6 * parent + i] += bias[6 * link + i];
      bias[6 * parent + 3 + i] += bias[6 * link + 3 + i];
    }
    addCross(p, 3 * link, bias, 6 * link + 3, bias, 6 * parent);
  }
}
