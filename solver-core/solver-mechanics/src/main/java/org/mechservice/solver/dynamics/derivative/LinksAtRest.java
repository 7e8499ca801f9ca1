package org.mechservice.solver.dynamics.derivative;

import static org.mechservice.solver.dynamics.derivative.FarBlocks.PLACE;
import static org.mechservice.solver.dynamics.derivative.FarBlocks.VELOCITY;
import static org.mechservice.solver.dynamics.derivative.PlacedLinks.BLOCK;
import static org.mechservice.solver.dynamics.derivative.PlacedLinks.WIDTH;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.mechservice.solver.force.applied.ForceJacobian;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.linear.front.SymmetricFronts;

/**
 * Mass, damping and stiffness of a mechanism at rest as one sparse symmetric system: in joint
 * coordinates those of a long chain have no zeros. Workspace of one thread.
 *
 * <p>The form xᵀ A x with A = m M + c C + k K + s D is a sum over links, by their small
 * displacements u, [rotation; displacement] in link axes, and the displacements x of joints:
 *
 * <pre>
 * Σ_i u_iᵀ H_i u_i + Σ_ij u_iᵀ F_ij u_j + k Σ_i f_i · (X_i u_p × u_i) + Σ_i x_iᵀ (m A_i + D_i) x_i,   u_i = X_i u_p + S_i x_i
 * H = m I + k [−h × g ×, 0; −m g ×, 0] − k ∂f/∂X − c ∂f/∂V
 * </pre>
 *
 * <p>with the armature A of each joint, the force f in it and F of forces between links and by
 * coordinates. With the wrenches w that enforce u_i − X_i u_p − S_i x_i = 0 and the multipliers λ
 * of loops it is the symmetric system
 *
 * <pre>
 * (H u)_i + (F u)_i + w_i − Σ_c X_cᵀ w_c + J_uᵀ λ = 0
 * (m A_i + D_i) x_i − S_iᵀ w_i + J_xᵀ λ = b_i
 * u_i − X_i u_p − S_i x_i = 0,   J_u u + J_x x = 0
 * </pre>
 *
 * <p>A is positive definite along the loops if and only if this has as many negative eigenvalues as
 * equations in its last line (Haynsworth 1968); further ones are those of A along the loops. Links
 * are eliminated from the tips to the root, those first that are coupled with few others, and loops
 * behind their last link.
 *
 * <p>D weighs how much a displacement is worth against trust in K: it has the moment of forces on
 * the arms of each link for the link's rotation in space, and not for that of its joint. The
 * potential of a hanging chain is a sum over such rotations.
 *
 * <p>Where forces have no potential, A is the symmetric part, which {@link #isStiffnessSymmetric}
 * tells.
 */
public final class LinksAtRest {
  /** Where w and x of a link begin among its unknowns. */
  private static final int WRENCH = 6;

  private static final int JOINT = 12;

  /** Size of a link without any, as a part of the largest. */
  private static final double LEAST_SIZE = 1e-8;

  private final TreeGeometry tree;
  private final RestingTerms terms;
  private final PlacedLinks links;
  private final FarBlocks far;
  private final LoopWrenches rows;
  private final int[] at;
  private final int firstMultiplier;
  private final int unknowns;

  /** Unit of each displacement, 1 or a length, and its link; -1 for other unknowns. */
  private final double[] unit;

  private final int[] linkOfDisplacement;

  /** Rows and columns of the elements in the order in which {@link #assemble} puts them. */
  private int[] seenRow = new int[1024];

  private int[] seenColumn = new int[1024];
  private boolean learning;
  private int next;
  private double[] target = {};

  /** Elements of the matrix factored last, and of that multiplied last, without units. */
  private final double[] factored;

  private final double[] multiplied;

  /** m, c and k of what was multiplied last; not valid after {@link #evaluate}. */
  private final double[] multiplier = {Double.NaN, Double.NaN, Double.NaN};

  private final double[] scaled;
  private final double[] scale;
  private final double[] size;
  private final double[] right;
  private final double[] sum;
  private final SymmetricFronts fronts;

  /**
   * Makes a workspace.
   *
   * @param motion swept by the caller at rest, with accelerations of zero, before each evaluation
   * @param pairs links that forces and loops couple, two for each pair
   * @param rows of loops, written by the caller before each factorisation; rows of zeros are
   *     permitted
   */
  public LinksAtRest(TreeMotion motion, int[] pairs, LoopWrenches rows) {
    this.rows = rows;
    terms = new RestingTerms(motion, pairs);
    tree = terms.tree;
    links = terms.links;
    far = terms.far;
    int count = tree.linkCount;
    at = new int[count + 1];
    for (int link = 0; link < count; link++) {
      at[link + 1] = at[link] + JOINT + links.end(link) - links.first(link);
    }
    firstMultiplier = at[count];
    unknowns = firstMultiplier + rows.count();
    unit = new double[unknowns];
    linkOfDisplacement = new int[unknowns];
    Arrays.fill(linkOfDisplacement, -1);
    for (int link = 0; link < count; link++) {
      for (int unknown = at[link]; unknown < at[link + 1]; unknown++) {
        int r = unknown - at[link];
        boolean ofWrench = r >= WRENCH && r < JOINT;
        linkOfDisplacement[unknown] = ofWrench ? -1 : link;
        unit[unknown] = r < WRENCH ? terms.unit(r) : terms.unitOf(link);
      }
    }
    scale = new double[unknowns];
    size = new double[count];
    right = new double[unknowns];
    sum = new double[unknowns];
    learning = true;
    assemble(0, 0, 0, 0, target);
    learning = false;
    seenRow = Arrays.copyOf(seenRow, next);
    seenColumn = Arrays.copyOf(seenColumn, next);
    factored = new double[next];
    multiplied = new double[next];
    scaled = new double[next];
    int[] paired = new int[count];
    Arrays.fill(paired, JOINT);
    fronts = new SymmetricFronts(unknowns, groups(), paired, seenRow, seenColumn);
  }

  /**
   * Returns the unknowns of each link in the order of elimination, from the tips to the root: u and
   * w in turn, which are pivots of two rows, x, and the loops whose last link it is.
   */
  private int[][] groups() {
    LinkCouplings couplings = new LinkCouplings(tree, far, rows);
    int[] order = couplings.fromTips();
    IntStream.Builder[] groups = new IntStream.Builder[tree.linkCount];
    for (int link : order) {
      int from = at[link];
      groups[link] = IntStream.builder();
      for (int r = 0; r < WRENCH; r++) {
        groups[link].add(from + r).add(from + WRENCH + r);
      }
      IntStream.range(from + JOINT, at[link + 1]).forEach(groups[link]::add);
    }
    int[] last = couplings.lastOfRows(order);
    for (int row = 0; row < last.length; row++) {
      groups[last[row]].add(firstMultiplier + row);
    }
    return Arrays.stream(order)
        .mapToObj(link -> groups[link].build().toArray())
        .toArray(int[][]::new);
  }

  /**
   * Places the links and forgets the derivatives of forces, which {@link #forces} then takes.
   *
   * @param wrenches external ones with those of loops, 6 per link, N·m and N in link axes; kept
   */
  public void evaluate(double[] wrenches) {
    terms.evaluate(wrenches);
    Arrays.fill(multiplier, Double.NaN);
  }

  /** Returns what takes the derivatives of forces between the links that were announced. */
  public ForceJacobian forces() {
    return far;
  }

  /**
   * Forms D for the place and forces last evaluated.
   *
   * @param left residual forces, N·m or N, one for each velocity of the state; not modified
   * @param units of the velocities of the state, 1 or a length in m; not modified
   */
  public void weigh(double[] left, double[] units) {
    terms.weigh(left, units);
  }

  /** Returns whether K is symmetric at an equilibrium: whether the forces have a potential. */
  public boolean isStiffnessSymmetric() {
    return terms.isStiffnessSymmetric();
  }

  /** Returns whether C has an element that is not zero. */
  public boolean isDamped() {
    return terms.isDamped();
  }

  /** Returns whether C is symmetric. */
  public boolean isDampingSymmetric() {
    return terms.isDampingSymmetric();
  }

  /**
   * Factors m M + c C + k K + s D along the loops if it is positive definite there.
   *
   * @return whether it is
   */
  public boolean factor(double mass, double damping, double stiffness, double shift) {
    // the links on a joint are a mechanism of their own, which is positive definite as well
    int most = rows.count() == 0 ? 6 : unknowns;
    form(mass, damping, stiffness, shift);
    return fronts.factor(scaled, most) && fronts.negative() == 6 * tree.linkCount + rows.count();
  }

  /**
   * Factors m M + c C + k K.
   *
   * @return the number of its negative eigenvalues along the loops, or -1 if it is not known
   *     because very many are zero
   */
  public int negative(double mass, double damping, double stiffness) {
    form(mass, damping, stiffness, 0);
    fronts.factor(scaled);
    return fronts.isAbandoned() ? -1 : fronts.negative() - 6 * tree.linkCount - rows.count();
  }

  private void form(double mass, double damping, double stiffness, double shift) {
    assemble(mass, damping, stiffness, shift, factored);
    formScale();
    for (int e = 0; e < next; e++) {
      scaled[e] = scale[seenRow[e]] * factored[e] * scale[seenColumn[e]];
    }
  }

  /** Brings the elements of each link and of its equations to sizes of about one. */
  private void formScale() {
    Arrays.fill(size, 0);
    for (int e = 0; e < next; e++) {
      int r = linkOfDisplacement[seenRow[e]];
      int c = linkOfDisplacement[seenColumn[e]];
      if (r >= 0 && c >= 0) {
        double element = Math.abs(factored[e]) * unit[seenRow[e]] * unit[seenColumn[e]];
        size[r] = Math.max(size[r], element);
        size[c] = Math.max(size[c], element);
      }
    }
    double largest = Double.MIN_NORMAL / LEAST_SIZE;
    for (double each : size) {
      largest = Math.max(largest, each);
    }
    for (int link = tree.linkCount - 1; link >= 0; link--) {
      size[link] = Math.max(size[link], LEAST_SIZE * largest);
      int parent = tree.parent[link];
      if (parent != TreeGeometry.ROOT) {
        size[parent] = Math.max(size[parent], size[link]);
      }
      double root = Math.sqrt(size[link]);
      for (int unknown = at[link]; unknown < at[link + 1]; unknown++) {
        int r = unknown - at[link];
        boolean ofWrench = r >= WRENCH && r < JOINT;
        scale[unknown] = ofWrench ? root / terms.unit(r - WRENCH) : unit[unknown] / root;
      }
    }
    for (int row = 0; row < rows.count(); row++) {
      scale[firstMultiplier + row] = scaleOfRow(row);
    }
  }

  private double scaleOfRow(int row) {
    double most = 0;
    int from = rows.wrenchAt[row];
    for (int link : rows.links[row]) {
      for (int r = 0; r < 6; r++) {
        most = Math.max(most, Math.abs(rows.wrench[from++]) * scale[at[link] + r]);
      }
    }
    from = rows.forceAt[row];
    for (int k : rows.velocities[row]) {
      most = Math.max(most, Math.abs(rows.force[from++]) * scale[x(tree.linkOfVelocity[k], k)]);
    }
    return most == 0 ? 1 : 1 / most;
  }

  /** Puts all elements, always in the same order. */
  private void assemble(double m, double c, double k, double shift, double[] to) {
    next = 0;
    target = to;
    for (int link = 0; link < tree.linkCount; link++) {
      putJoint(link);
      putOwn(link, m, c, k, shift);
      putForce(link, k);
    }
    for (int pair = 0; pair < far.count(); pair++) {
      putPair(pair, c, k);
    }
    for (int row = 0; row < rows.count(); row++) {
      putRow(row);
    }
  }

  private void put(int row, int column, double value) {
    if (learning) {
      if (next == seenRow.length) {
        seenRow = Arrays.copyOf(seenRow, 2 * next);
        seenColumn = Arrays.copyOf(seenColumn, 2 * next);
      }
      seenRow[next] = row;
      seenColumn[next++] = column;
    } else {
      target[next++] = value;
    }
  }

  /** u_i − X_i u_p − S_i x_i. */
  private void putJoint(int link) {
    int parent = tree.parent[link];
    for (int r = 0; r < 6; r++) {
      int row = at[link] + WRENCH + r;
      put(row, at[link] + r, 1);
      for (int k = links.first(link); k < links.end(link); k++) {
        put(row, x(link, k), -links.subspace[6 * k + r]);
      }
      for (int c = 0; parent != TreeGeometry.ROOT && c < 6; c++) {
        if (r >= 3 || c < 3) {
          put(row, at[parent] + c, -terms.carrying[36 * link + 6 * r + c]);
        }
      }
    }
  }

  /** H, D and the coupling of both, with D of the shift. */
  private void putOwn(int link, double m, double c, double k, double shift) {
    terms.formOwn(link, m, c, k);
    for (int r = 0; r < 6; r++) {
      for (int e = 0; e <= r; e++) {
        double weight = r == e && r < 3 ? shift * terms.turnWeight[link] : 0;
        put(at[link] + r, at[link] + e, terms.block[6 * r + e] + weight);
      }
    }
    for (int j = links.first(link); j < links.end(link); j++) {
      put(x(link, j), x(link, j), m * tree.armature[j] + shift * terms.jointWeight[j]);
    }
  }

  /** k f · (X u_p × u), half of it on each side of the diagonal. */
  private void putForce(int link, double k) {
    int parent = tree.parent[link];
    if (parent == TreeGeometry.ROOT) {
      return;
    }
    terms.formForce(link, k);
    for (int r = 0; r < 6; r++) {
      for (int c = 0; c < 6; c++) {
        if (r < 3 || c < 3) {
          put(at[parent] + r, at[link] + c, terms.product[6 * r + c]);
        }
      }
    }
  }

  /** Half of F on this side of the diagonal: a pair is there in both orders. */
  private void putPair(int pair, double c, double k) {
    int on = far.on[pair];
    int by = far.by[pair];
    for (int r = 0; on != by && r < 6; r++) {
      for (int e = 0; e < 6; e++) {
        int element = BLOCK * pair + WIDTH * r + e;
        double force = c * far.wrench[element + VELOCITY] + k * far.wrench[element + PLACE];
        put(at[on] + r, at[by] + e, 0.5 * force);
      }
    }
    for (int j = links.first(by); j < links.end(by); j++) {
      int from = far.wrenchBy.at(pair, j - links.first(by));
      for (int r = 0; r < 6; r++) {
        double force = c * far.wrenchBy.velocity[from + r] + k * far.wrenchBy.place[from + r];
        put(at[on] + r, x(by, j), 0.5 * force);
      }
      from = far.forceBy.at(pair, j - links.first(by));
      for (int i = links.first(on); i < links.end(on); i++) {
        int element = from + i - links.first(on);
        double force = c * far.forceBy.velocity[element] + k * far.forceBy.place[element];
        put(x(on, i), x(by, j), i == j ? force : 0.5 * force);
      }
    }
    for (int i = links.first(on); i < links.end(on); i++) {
      int from = WIDTH * (FarBlocks.MOST * pair + i - links.first(on));
      for (int e = 0; e < 6; e++) {
        double force = c * far.force[from + VELOCITY + e] + k * far.force[from + PLACE + e];
        put(x(on, i), at[by] + e, 0.5 * force);
      }
    }
  }

  /** J u; a row of zeros is an equation of λ alone. */
  private void putRow(int row) {
    int line = firstMultiplier + row;
    boolean zero = true;
    int from = rows.wrenchAt[row];
    for (int link : rows.links[row]) {
      for (int r = 0; r < 6; r++) {
        zero &= rows.wrench[from] == 0;
        put(line, at[link] + r, rows.wrench[from++]);
      }
    }
    from = rows.forceAt[row];
    for (int k : rows.velocities[row]) {
      zero &= rows.force[from] == 0;
      put(line, x(tree.linkOfVelocity[k], k), rows.force[from++]);
    }
    put(line, line, zero ? -1 : 0);
  }

  /** Returns the index of a velocity among the unknowns. */
  private int x(int link, int velocity) {
    return at[link] + JOINT + velocity - links.first(link);
  }

  /**
   * Solves A x + Jᵀ λ = b, J x = 0 with the last factors.
   *
   * @param b one number for each velocity of the state; overwritten with x
   */
  public void solve(double[] b) {
    Arrays.fill(right, 0);
    for (int link = 0; link < tree.linkCount; link++) {
      for (int k = links.first(link); k < links.end(link); k++) {
        right[x(link, k)] = scale[x(link, k)] * b[k];
      }
    }
    fronts.solve(right);
    for (int link = 0; link < tree.linkCount; link++) {
      for (int k = links.first(link); k < links.end(link); k++) {
        b[k] = scale[x(link, k)] * right[x(link, k)];
      }
    }
  }

  /**
   * Writes A x for A = m M + c C + k K.
   *
   * @param x one number for each velocity of the state; not modified
   * @param out the same; overwritten
   */
  public void multiply(double mass, double damping, double stiffness, double[] x, double[] out) {
    if (multiplier[0] != mass || multiplier[1] != damping || multiplier[2] != stiffness) {
      assemble(mass, damping, stiffness, 0, multiplied);
      multiplier[0] = mass;
      multiplier[1] = damping;
      multiplier[2] = stiffness;
    }
    displace(x);
    Arrays.fill(sum, 0);
    for (int e = 0; e < multiplied.length; e++) {
      int r = seenRow[e];
      int c = seenColumn[e];
      sum[r] += multiplied[e] * right[c];
      if (r != c) {
        sum[c] += multiplied[e] * right[r];
      }
    }
    for (int link = tree.linkCount - 1; link >= 0; link--) {
      for (int k = links.first(link); k < links.end(link); k++) {
        double force = sum[x(link, k)];
        for (int r = 0; r < 6; r++) {
          force += links.subspace[6 * k + r] * sum[at[link] + r];
        }
        out[k] = force;
      }
      int parent = tree.parent[link];
      for (int c = 0; parent != TreeGeometry.ROOT && c < 6; c++) {
        for (int r = 0; r < 6; r++) {
          sum[at[parent] + c] += terms.carrying[36 * link + 6 * r + c] * sum[at[link] + r];
        }
      }
    }
  }

  /** Writes u and x, without wrenches and multipliers. */
  private void displace(double[] x) {
    Arrays.fill(right, 0);
    for (int link = 0; link < tree.linkCount; link++) {
      int parent = tree.parent[link];
      for (int k = links.first(link); k < links.end(link); k++) {
        right[x(link, k)] = x[k];
      }
      for (int r = 0; r < 6; r++) {
        double displaced = 0;
        for (int c = 0; parent != TreeGeometry.ROOT && c < 6; c++) {
          displaced += terms.carrying[36 * link + 6 * r + c] * right[at[parent] + c];
        }
        for (int k = links.first(link); k < links.end(link); k++) {
          displaced += links.subspace[6 * k + r] * x[k];
        }
        right[at[link] + r] = displaced;
      }
    }
  }
}
