package org.mechservice.solver.dynamics.derivative;

import static org.mechservice.solver.dynamics.derivative.LinkUnknowns.PLACE;
import static org.mechservice.solver.dynamics.derivative.LinkUnknowns.SPEED;
import static org.mechservice.solver.dynamics.derivative.LinkUnknowns.WRENCH;
import static org.mechservice.solver.dynamics.derivative.PlacedLinks.BLOCK;
import static org.mechservice.solver.dynamics.derivative.PlacedLinks.WIDTH;
import static org.mechservice.solver.dynamics.derivative.PlacedLinks.dot6;
import static org.mechservice.solver.spatial.Blocks.cross;

import java.util.Arrays;
import org.mechservice.solver.kinematics.LinkKind;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.linear.LinearSolver;
import org.mechservice.solver.linear.SparsePivotedLu;

/**
 * The equations of {@link ArticulatedIteration} as one sparse system in the motions z of the links,
 * the wrenches w in their joints, the velocities x and the multipliers λ of loops. Workspace of one
 * thread.
 *
 * <pre>
 * z_i − X_i z_p − Z_i x_i = 0
 * w_i − P_i z_i − R_i z_p − G_i x_i − Σ_c (X_c* w_c + Q_c z_c) − Σ_j (F_ij z_j + H_ij x_j) − Jᵀ λ = 0
 * S_iᵀ (w_i − G_i x_i) + D_i x_i + Σ_j (f_ij z_j + h_ij x_j) + Jᵀ λ = b_i
 * J u − λ / α = −g,   u_i = X_i u_p + S_i x_i
 * </pre>
 *
 * <p>where u are the changes of the links' velocities: ξ / hγ² if there are no balls, unknowns of
 * their own otherwise.
 *
 * <p>Its graph is the mechanism: joints, forces and loops between links. So the order of
 * elimination is chosen for links, by least degree, once: each with its joint, and a loop right
 * behind its last link. The factors interchange rows where pivots are small. Rows are divided by
 * the inertias, lengths and powers of hγ that belong to them, so that pivots compare.
 */
final class LinkSystem {
  /** Inertia of a link without one, as a part of the largest. */
  private static final double LEAST_INERTIA = 1e-8;

  private final LinkJacobian jacobian;
  private final PlacedLinks links;
  private final FarBlocks far;
  private final LoopWrenches rows;
  private final LinkUnknowns unknowns;

  /** Index of the first unknown of each link. */
  private final int[] at;

  private final SparseAssembly assembly;
  private final double[] scale;
  private final double[] right;
  private final SparsePivotedLu lu;

  /** A length of the links, m. */
  private final double length;

  /** Size of P of each link with all on it, kg. */
  private final double[] inertia;

  private double largestInertia;
  private double hGamma;

  /** 1/α of each row. */
  private final double[] compliance;

  private final double[] lever = new double[9];
  private final double[] unit = new double[3];
  private final double[] turned = new double[3];

  /**
   * Makes a workspace.
   *
   * @param jacobian evaluated before each factorisation
   * @param rows of loops, to be written before each factorisation
   */
  LinkSystem(LinkJacobian jacobian, LoopWrenches rows) {
    this.jacobian = jacobian;
    this.rows = rows;
    links = jacobian.links;
    far = jacobian.far;
    length = jacobian.inertias.meanRadius();
    unknowns = new LinkUnknowns(links, far, rows);
    at = unknowns.at;
    scale = new double[unknowns.count];
    right = new double[unknowns.count];
    inertia = new double[links.tree.linkCount];
    compliance = new double[rows.count()];
    assembly = new SparseAssembly(unknowns.count);
    assemble(new LinkColumns(links.tree.velocityCount));
    lu = new SparsePivotedLu(assembly.learn(), unknowns.order());
  }

  /**
   * Factors.
   *
   * @param columns of A; not modified
   * @param step hγ that they belong to, s
   * @param penalties α of each row; not modified
   * @return a negative number, or a velocity without a pivot
   */
  int factor(LinkColumns columns, double step, double[] penalties) {
    hGamma = step;
    weigh(columns.force);
    for (int row = 0; row < rows.count(); row++) {
      compliance[row] = 1 / penalties[row];
    }
    assembly.clear();
    assemble(columns);
    int failed = lu.factor(assembly.values());
    return failed == LinearSolver.NONSINGULAR ? failed : unknowns.velocityOf(failed);
  }

  /** Finds the inertias that the rows are divided by, and their scales. */
  private void weigh(double[] d) {
    TreeGeometry tree = links.tree;
    largestInertia = 0;
    for (int link = 0; link < tree.linkCount; link++) {
      double size = Math.max(moving(link), turning(link) / (length * length));
      for (int k = links.first(link); k < links.end(link); k++) {
        boolean turns = tree.kind[link] != LinkKind.SLIDE;
        double ofJoint = Math.abs(d[3 * k + k - links.first(link)]);
        size = Math.max(size, turns ? ofJoint / (length * length) : ofJoint);
      }
      inertia[link] = size;
      largestInertia = Math.max(largestInertia, size);
    }
    largestInertia = Math.max(largestInertia, Double.MIN_NORMAL / LEAST_INERTIA);
    for (int link = tree.linkCount - 1; link >= 0; link--) {
      inertia[link] = Math.max(inertia[link], LEAST_INERTIA * largestInertia);
      int parent = tree.parent[link];
      if (parent != TreeGeometry.ROOT) {
        inertia[parent] = Math.max(inertia[parent], inertia[link]);
      }
      scaleRows(link);
    }
    Arrays.fill(scale, unknowns.firstMultiplier, scale.length, 1);
  }

  private void scaleRows(int link) {
    double power = 1;
    for (int r = 0; r < WIDTH; r++) {
      if (r > 0 && r % 6 == 0) {
        power /= hGamma;
      }
      scale[at[link] + r] = r % 6 < 3 ? power * length : power;
    }
    for (int r = 0; r < 6; r++) {
      scale[at[link] + WRENCH + r] = 1 / (r < 3 ? inertia[link] * length : inertia[link]);
    }
    for (int r = SPEED; r < unknowns.ofLink; r++) {
      scale[at[link] + r] = r < SPEED + 3 ? length : 1;
    }
    boolean turns = links.tree.kind[link] != LinkKind.SLIDE;
    Arrays.fill(
        scale,
        at[link] + unknowns.ofLink,
        at[link + 1],
        1 / (turns ? inertia[link] * length : inertia[link]));
  }

  /** Returns the largest inertia of a link against displacements, with its forces in a step, kg. */
  private double moving(int link) {
    return Math.max(against(link, 3), Math.max(against(link, 4), against(link, 5)));
  }

  /** Returns the same against rotations, kg·m². */
  private double turning(int link) {
    return Math.max(against(link, 0), Math.max(against(link, 1), against(link, 2)));
  }

  private double against(int link, int r) {
    int e = BLOCK * link + WIDTH * r + r;
    return Math.abs(jacobian.own[e])
        + hGamma * (Math.abs(jacobian.own[e + 6]) + hGamma * Math.abs(jacobian.own[e + 12]));
  }

  /** Puts all elements, always in the same order. */
  private void assemble(LinkColumns columns) {
    for (int link = 0; link < links.tree.linkCount; link++) {
      putMotion(link, columns.motion);
      putWrench(link, columns.wrench);
      putForces(link, columns.wrench, columns.force);
    }
    for (int pair = 0; pair < far.count(); pair++) {
      putPair(pair);
    }
    for (int row = 0; row < rows.count(); row++) {
      putRow(row);
    }
  }

  /** Adds to an element of the matrix, multiplied by the scale of its row. */
  private void put(int row, int column, double value) {
    assembly.put(row, column, scale[row] * value);
  }

  /** z_i − X_i z_p − Z_i x_i. */
  private void putMotion(int link, double[] z) {
    int from = at[link];
    for (int r = 0; r < WIDTH; r++) {
      put(from + r, from + r, 1);
      for (int k = links.first(link); k < links.end(link); k++) {
        put(from + r, unknowns.x(link, k), -z[WIDTH * k + r]);
      }
    }
    for (int r = SPEED; r < unknowns.ofLink; r++) {
      put(from + r, from + r, 1);
      for (int k = links.first(link); k < links.end(link); k++) {
        put(from + r, unknowns.x(link, k), -links.subspace[6 * k + r - SPEED]);
      }
    }
    int parent = links.tree.parent[link];
    if (parent != TreeGeometry.ROOT) {
      formLever(link);
      for (int block = 0; block < WIDTH; block += 6) {
        putCarried(from + block, at[parent] + block, link);
      }
      if (unknowns.hasSpeeds) {
        putCarried(from + SPEED, at[parent] + SPEED, link);
      }
    }
  }

  /** −X for six numbers of a motion. */
  private void putCarried(int row, int column, int link) {
    for (int r = 0; r < 3; r++) {
      for (int c = 0; c < 3; c++) {
        double turn = links.rotation[9 * link + 3 * c + r];
        put(row + r, column + c, -turn);
        put(row + 3 + r, column + 3 + c, -turn);
        put(row + 3 + r, column + c, -lever[3 * r + c]);
      }
    }
  }

  /** Rᵀ [−p]×: what a rotation of the parent displaces at the link, in its axes. */
  private void formLever(int link) {
    for (int c = 0; c < 3; c++) {
      Arrays.fill(unit, 0);
      unit[c] = 1;
      cross(unit, 0, links.position, 3 * link, turned, 0);
      for (int r = 0; r < 3; r++) {
        double sum = 0;
        for (int i = 0; i < 3; i++) {
          sum += links.rotation[9 * link + 3 * i + r] * turned[i];
        }
        lever[3 * r + c] = sum;
      }
    }
  }

  /** w_i − P_i z_i − R_i z_p − G_i x_i, and −X* w_i − Q_i z_i of the parent. */
  private void putWrench(int link, double[] g) {
    int parent = links.tree.parent[link];
    for (int r = 0; r < 6; r++) {
      int row = at[link] + WRENCH + r;
      put(row, row, 1);
      for (int c = 0; c < WIDTH; c++) {
        put(row, at[link] + c, -jacobian.own[BLOCK * link + WIDTH * r + c]);
      }
      for (int k = links.first(link); k < links.end(link); k++) {
        put(row, unknowns.x(link, k), -g[6 * k + r]);
      }
    }
    if (parent == TreeGeometry.ROOT) {
      return;
    }
    putToParent(link, parent);
    if (far.count() == 0) {
      putNeighbours(link, parent);
    }
  }

  /** −X* w_i: f_p = R f, n_p = R n + p × R f. */
  private void putToParent(int link, int parent) {
    formLever(link);
    int to = at[parent] + WRENCH;
    int from = at[link] + WRENCH;
    for (int r = 0; r < 3; r++) {
      for (int c = 0; c < 3; c++) {
        double turn = links.rotation[9 * link + 3 * r + c];
        put(to + r, from + c, -turn);
        put(to + 3 + r, from + 3 + c, -turn);
        put(to + r, from + 3 + c, -lever[3 * c + r]);
      }
    }
  }

  /** R and Q. */
  private void putNeighbours(int link, int parent) {
    for (int r = 0; r < 6; r++) {
      for (int c = 0; c < WIDTH; c++) {
        int e = BLOCK * link + WIDTH * r + c;
        put(
            at[link] + WRENCH + r,
            at[parent] + c,
            jacobian.coupled[link] ? -jacobian.byParent[e] : 0);
        put(
            at[parent] + WRENCH + r,
            at[link] + c,
            jacobian.coupled[link] ? -jacobian.onParent[e] : 0);
      }
    }
  }

  /** S_iᵀ (w_i − G_i x_i) + D_i x_i. */
  private void putForces(int link, double[] g, double[] d) {
    int first = links.first(link);
    for (int j = first; j < links.end(link); j++) {
      for (int r = 0; r < 6; r++) {
        put(unknowns.x(link, j), at[link] + WRENCH + r, links.subspace[6 * j + r]);
      }
      for (int k = first; k < links.end(link); k++) {
        double turning = dot6(links.subspace, 6 * j, g, 6 * k);
        put(unknowns.x(link, j), unknowns.x(link, k), d[3 * k + j - first] - turning);
      }
    }
  }

  /** −F z − H x in the wrench on a link, f z + h x in its joint. */
  private void putPair(int pair) {
    int on = far.on[pair];
    int by = far.by[pair];
    int first = links.first(by);
    for (int r = 0; r < 6; r++) {
      int row = at[on] + WRENCH + r;
      for (int c = 0; c < WIDTH; c++) {
        put(row, at[by] + c, -far.wrench[BLOCK * pair + WIDTH * r + c]);
      }
      for (int k = first; k < links.end(by); k++) {
        put(row, unknowns.x(by, k), -far.wrenchBy.combined[far.wrenchBy.at(pair, k - first) + r]);
      }
    }
    for (int j = links.first(on); j < links.end(on); j++) {
      int line = FarBlocks.MOST * pair + j - links.first(on);
      for (int c = 0; c < WIDTH; c++) {
        put(unknowns.x(on, j), at[by] + c, far.force[WIDTH * line + c]);
      }
      for (int k = first; k < links.end(by); k++) {
        int e = far.forceBy.at(pair, k - first) + j - links.first(on);
        put(unknowns.x(on, j), unknowns.x(by, k), far.forceBy.combined[e]);
      }
    }
  }

  /** J u − λ / α, and −Jᵀ λ in the wrenches, Jᵀ λ in the joints. */
  private void putRow(int row) {
    int line = unknowns.firstMultiplier + row;
    double square = unknowns.hasSpeeds ? 1 : hGamma * hGamma;
    put(line, line, -compliance[row]);
    int from = rows.wrenchAt[row];
    for (int link : rows.links[row]) {
      for (int r = 0; r < 6; r++) {
        double push = rows.wrench[from++];
        put(line, at[link] + (unknowns.hasSpeeds ? SPEED : PLACE) + r, push / square);
        put(at[link] + WRENCH + r, line, -push);
      }
    }
    from = rows.forceAt[row];
    for (int k : rows.velocities[row]) {
      int unknown = unknowns.x(links.tree.linkOfVelocity[k], k);
      put(line, unknown, rows.force[from]);
      put(unknown, line, rows.force[from++]);
    }
  }

  /**
   * Solves with the last factors.
   *
   * @param b right-hand sides of the velocities; overwritten with x
   * @param gap g of each row; overwritten with λ
   */
  void solve(double[] b, double[] gap) {
    Arrays.fill(right, 0);
    for (int link = 0; link < links.tree.linkCount; link++) {
      for (int k = links.first(link); k < links.end(link); k++) {
        right[unknowns.x(link, k)] = scale[unknowns.x(link, k)] * b[k];
      }
    }
    for (int row = 0; row < rows.count(); row++) {
      right[unknowns.firstMultiplier + row] = -gap[row];
    }
    lu.solve(right);
    for (int link = 0; link < links.tree.linkCount; link++) {
      for (int k = links.first(link); k < links.end(link); k++) {
        b[k] = right[unknowns.x(link, k)];
      }
    }
    System.arraycopy(right, unknowns.firstMultiplier, gap, 0, gap.length);
  }
}
