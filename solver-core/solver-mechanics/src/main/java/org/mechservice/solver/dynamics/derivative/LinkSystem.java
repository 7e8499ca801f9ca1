package org.mechservice.solver.dynamics.derivative;

import static org.mechservice.solver.dynamics.derivative.PlacedLinks.BLOCK;
import static org.mechservice.solver.dynamics.derivative.PlacedLinks.WIDTH;
import static org.mechservice.solver.dynamics.derivative.PlacedLinks.dot6;
import static org.mechservice.solver.spatial.Blocks.cross;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.stream.IntStream;
import org.mechservice.solver.kinematics.LinkKind;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.linear.LinearSolver;
import org.mechservice.solver.linear.MinimumDegree;
import org.mechservice.solver.linear.SparseLayout;
import org.mechservice.solver.linear.SparsePivotedLu;

/**
 * The equations of {@link ArticulatedIteration}, whose symbols these are, as one sparse system in
 * the motions z of the links, the wrenches w in their joints, the velocities x and the multipliers
 * λ of loops. Workspace of one thread.
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
  /** Where w and, if there is one, u of a link begin among its unknowns, and ξ in z. */
  private static final int WRENCH = WIDTH;

  private static final int SPEED = WRENCH + 6;
  private static final int PLACE = 12;

  /** Inertia of a link without one, as a part of the largest. */
  private static final double LEAST_INERTIA = 1e-8;

  private final PlacedLinks links;
  private final double[] own;
  private final double[] byParent;
  private final double[] onParent;
  private final boolean[] coupled;
  private final FarBlocks far;
  private final LoopWrenches rows;

  /** Whether u are unknowns, and the number of unknowns of a link besides its velocities. */
  private final boolean hasSpeeds;

  private final int ofLink;

  /** Index of the first unknown of each link, and of the first multiplier. */
  private final int[] at;

  private final int firstMultiplier;

  /** Places of the elements in the order in which {@link #assemble} puts them. */
  private final int[] place;

  private int[] seenRow = new int[64];
  private int[] seenColumn = new int[64];
  private boolean learning;
  private int next;

  private final double[] matrix;
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
   * Makes a workspace; arrays as of {@link LinkElimination}.
   *
   * @param rows of loops, to be written before each factorisation
   * @param length a length of the links, m
   */
  LinkSystem(
      PlacedLinks links,
      double[] own,
      double[] byParent,
      double[] onParent,
      boolean[] coupled,
      FarBlocks far,
      LoopWrenches rows,
      double length) {
    this.links = links;
    this.own = own;
    this.byParent = byParent;
    this.onParent = onParent;
    this.coupled = coupled;
    this.far = far;
    this.rows = rows;
    this.length = length;
    int count = links.tree.linkCount;
    hasSpeeds = rows.count() > 0 && hasBalls(links.tree);
    ofLink = hasSpeeds ? SPEED + 6 : SPEED;
    at = new int[count + 1];
    for (int link = 0; link < count; link++) {
      at[link + 1] = at[link] + ofLink + links.end(link) - links.first(link);
    }
    firstMultiplier = at[count];
    int unknowns = firstMultiplier + rows.count();
    scale = new double[unknowns];
    right = new double[unknowns];
    inertia = new double[count];
    compliance = new double[rows.count()];
    int velocities = links.tree.velocityCount;
    learning = true;
    assemble(
        new double[WIDTH * velocities], new double[6 * velocities], new double[3 * velocities]);
    learning = false;
    SparseLayout layout = SparseLayout.of(pattern(unknowns));
    place = new int[next];
    for (int e = 0; e < next; e++) {
      place[e] = layout.index(seenRow[e], seenColumn[e]);
    }
    seenRow = new int[0];
    seenColumn = new int[0];
    matrix = new double[layout.length()];
    lu = new SparsePivotedLu(layout, order());
  }

  private static boolean hasBalls(TreeGeometry tree) {
    return IntStream.range(0, tree.linkCount)
        .anyMatch(link -> tree.kind[link] == LinkKind.BALL && !tree.driven[link]);
  }

  /** Returns the rows of each column of what has been put. */
  private int[][] pattern(int unknowns) {
    int[] counts = new int[unknowns];
    for (int e = 0; e < next; e++) {
      counts[seenColumn[e]]++;
    }
    int[][] columns = new int[unknowns][];
    Arrays.setAll(columns, j -> new int[counts[j]]);
    for (int e = 0; e < next; e++) {
      int j = seenColumn[e];
      columns[j][--counts[j]] = seenRow[e];
    }
    Arrays.setAll(columns, j -> IntStream.of(columns[j]).sorted().distinct().toArray());
    return columns;
  }

  /**
   * Returns the unknowns in an order of least degree of the links; a loop follows its last link.
   */
  private int[] order() {
    TreeGeometry tree = links.tree;
    List<SortedSet<Integer>> neighbours = new ArrayList<>();
    for (int link = 0; link < tree.linkCount; link++) {
      neighbours.add(new TreeSet<>());
    }
    for (int link = 0; link < tree.linkCount; link++) {
      if (tree.parent[link] != TreeGeometry.ROOT) {
        neighbours.get(link).add(tree.parent[link]);
      }
    }
    for (int pair = 0; pair < far.count(); pair++) {
      neighbours.get(far.on[pair]).add(far.by[pair]);
    }
    for (int row = 0; row < rows.count(); row++) {
      int[] touched = touched(row);
      for (int link : touched) {
        neighbours.get(link).add(touched[0]);
      }
    }
    int[][] graph = new int[tree.linkCount][];
    Arrays.setAll(
        graph, link -> neighbours.get(link).stream().mapToInt(Integer::intValue).toArray());
    int[] ofLinks = MinimumDegree.order(SparseLayout.of(graph));
    int[] turn = new int[tree.linkCount];
    for (int i = 0; i < ofLinks.length; i++) {
      turn[ofLinks[i]] = i;
    }
    IntStream.Builder[] unknowns = new IntStream.Builder[tree.linkCount];
    for (int i = 0; i < unknowns.length; i++) {
      unknowns[i] = IntStream.builder();
      IntStream.range(at[ofLinks[i]], at[ofLinks[i] + 1]).forEach(unknowns[i]::add);
    }
    for (int row = 0; row < rows.count(); row++) {
      int last = IntStream.of(touched(row)).map(link -> turn[link]).max().orElse(0);
      unknowns[last].add(firstMultiplier + row);
    }
    return Arrays.stream(unknowns).flatMapToInt(IntStream.Builder::build).toArray();
  }

  /** Returns the links of a row, with those of its velocities. */
  private int[] touched(int row) {
    return IntStream.concat(
            IntStream.of(rows.links[row]),
            IntStream.of(rows.velocities[row]).map(k -> links.tree.linkOfVelocity[k]))
        .toArray();
  }

  /**
   * Factors.
   *
   * @param z Z, 18 for each velocity; not modified
   * @param g G, 6 for each velocity; not modified
   * @param d D, three for each velocity; not modified
   * @param step hγ that they belong to, s
   * @param penalties α of each row; not modified
   * @return a negative number, or a velocity without a pivot
   */
  int factor(double[] z, double[] g, double[] d, double step, double[] penalties) {
    hGamma = step;
    weigh(d);
    for (int row = 0; row < rows.count(); row++) {
      compliance[row] = 1 / penalties[row];
    }
    Arrays.fill(matrix, 0);
    assemble(z, g, d);
    int failed = lu.factor(matrix);
    return failed == LinearSolver.NONSINGULAR ? failed : velocityOf(failed);
  }

  /** Returns the velocity nearest to an unknown. */
  private int velocityOf(int unknown) {
    if (unknown >= firstMultiplier) {
      int[] touched = touched(unknown - firstMultiplier);
      return touched.length == 0 ? 0 : links.first(touched[0]);
    }
    int found = Arrays.binarySearch(at, unknown);
    int link = found >= 0 ? found : -found - 2;
    return Math.min(links.first(link), Math.max(0, links.tree.stateVelocityCount - 1));
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
    Arrays.fill(scale, firstMultiplier, scale.length, 1);
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
    for (int r = SPEED; r < ofLink; r++) {
      scale[at[link] + r] = r < SPEED + 3 ? length : 1;
    }
    boolean turns = links.tree.kind[link] != LinkKind.SLIDE;
    Arrays.fill(
        scale,
        at[link] + ofLink,
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
    return Math.abs(own[e]) + hGamma * (Math.abs(own[e + 6]) + hGamma * Math.abs(own[e + 12]));
  }

  /** Puts all elements, always in the same order. */
  private void assemble(double[] z, double[] g, double[] d) {
    next = 0;
    for (int link = 0; link < links.tree.linkCount; link++) {
      putMotion(link, z);
      putWrench(link, g);
      putForces(link, g, d);
    }
    for (int pair = 0; pair < far.count(); pair++) {
      putPair(pair);
    }
    for (int row = 0; row < rows.count(); row++) {
      putRow(row);
    }
  }

  /** One element of the matrix, to be multiplied by the scale of its row. */
  private void put(int row, int column, double value) {
    if (learning) {
      if (next == seenRow.length) {
        seenRow = Arrays.copyOf(seenRow, 2 * next);
        seenColumn = Arrays.copyOf(seenColumn, 2 * next);
      }
      seenRow[next] = row;
      seenColumn[next++] = column;
    } else {
      matrix[place[next++]] += scale[row] * value;
    }
  }

  /** z_i − X_i z_p − Z_i x_i. */
  private void putMotion(int link, double[] z) {
    int from = at[link];
    for (int r = 0; r < WIDTH; r++) {
      put(from + r, from + r, 1);
      for (int k = links.first(link); k < links.end(link); k++) {
        put(from + r, x(link, k), -z[WIDTH * k + r]);
      }
    }
    for (int r = SPEED; r < ofLink; r++) {
      put(from + r, from + r, 1);
      for (int k = links.first(link); k < links.end(link); k++) {
        put(from + r, x(link, k), -links.subspace[6 * k + r - SPEED]);
      }
    }
    int parent = links.tree.parent[link];
    if (parent != TreeGeometry.ROOT) {
      formLever(link);
      for (int block = 0; block < WIDTH; block += 6) {
        putCarried(from + block, at[parent] + block, link);
      }
      if (hasSpeeds) {
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
        put(row, at[link] + c, -own[BLOCK * link + WIDTH * r + c]);
      }
      for (int k = links.first(link); k < links.end(link); k++) {
        put(row, x(link, k), -g[6 * k + r]);
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
        put(at[link] + WRENCH + r, at[parent] + c, coupled[link] ? -byParent[e] : 0);
        put(at[parent] + WRENCH + r, at[link] + c, coupled[link] ? -onParent[e] : 0);
      }
    }
  }

  /** S_iᵀ (w_i − G_i x_i) + D_i x_i. */
  private void putForces(int link, double[] g, double[] d) {
    int first = links.first(link);
    for (int j = first; j < links.end(link); j++) {
      for (int r = 0; r < 6; r++) {
        put(x(link, j), at[link] + WRENCH + r, links.subspace[6 * j + r]);
      }
      for (int k = first; k < links.end(link); k++) {
        double turning = dot6(links.subspace, 6 * j, g, 6 * k);
        put(x(link, j), x(link, k), d[3 * k + j - first] - turning);
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
        put(row, x(by, k), -far.wrenchBy.combined[far.wrenchBy.at(pair, k - first) + r]);
      }
    }
    for (int j = links.first(on); j < links.end(on); j++) {
      int line = FarBlocks.MOST * pair + j - links.first(on);
      for (int c = 0; c < WIDTH; c++) {
        put(x(on, j), at[by] + c, far.force[WIDTH * line + c]);
      }
      for (int k = first; k < links.end(by); k++) {
        int e = far.forceBy.at(pair, k - first) + j - links.first(on);
        put(x(on, j), x(by, k), far.forceBy.combined[e]);
      }
    }
  }

  /** J u − λ / α, and −Jᵀ λ in the wrenches, Jᵀ λ in the joints. */
  private void putRow(int row) {
    int line = firstMultiplier + row;
    double square = hasSpeeds ? 1 : hGamma * hGamma;
    put(line, line, -compliance[row]);
    int from = rows.wrenchAt[row];
    for (int link : rows.links[row]) {
      for (int r = 0; r < 6; r++) {
        double push = rows.wrench[from++];
        put(line, at[link] + (hasSpeeds ? SPEED : PLACE) + r, push / square);
        put(at[link] + WRENCH + r, line, -push);
      }
    }
    from = rows.forceAt[row];
    for (int k : rows.velocities[row]) {
      int unknown = x(links.tree.linkOfVelocity[k], k);
      put(line, unknown, rows.force[from]);
      put(unknown, line, rows.force[from++]);
    }
  }

  /** Returns the index of a velocity among the unknowns. */
  private int x(int link, int velocity) {
    return at[link] + ofLink + velocity - links.first(link);
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
        right[x(link, k)] = scale[x(link, k)] * b[k];
      }
    }
    for (int row = 0; row < rows.count(); row++) {
      right[firstMultiplier + row] = -gap[row];
    }
    lu.solve(right);
    for (int link = 0; link < links.tree.linkCount; link++) {
      for (int k = links.first(link); k < links.end(link); k++) {
        b[k] = right[x(link, k)];
      }
    }
    System.arraycopy(right, firstMultiplier, gap, 0, gap.length);
  }
}
