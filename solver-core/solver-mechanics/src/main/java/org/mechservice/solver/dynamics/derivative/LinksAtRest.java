package org.mechservice.solver.dynamics.derivative;

import static org.mechservice.solver.dynamics.derivative.PlacedLinks.BLOCK;
import static org.mechservice.solver.dynamics.derivative.PlacedLinks.WIDTH;
import static org.mechservice.solver.spatial.Blocks.cross;
import static org.mechservice.solver.spatial.Blocks.dot;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.stream.IntStream;
import org.mechservice.solver.dynamics.recursion.LinkInertias;
import org.mechservice.solver.dynamics.recursion.NewtonEuler;
import org.mechservice.solver.force.applied.ForceJacobian;
import org.mechservice.solver.kinematics.LinkKind;
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
 * Σ_i u_iᵀ H_i u_i + Σ_ij u_iᵀ F_ij u_j + k Σ_i f_i · (X_i u_p × u_i) + Σ_i x_iᵀ D_i x_i,   u_i = X_i u_p + S_i x_i
 * H = m I + k [−h × g ×, 0; −m g ×, 0] − k ∂f/∂X − c ∂f/∂V
 * </pre>
 *
 * <p>with the force f in each joint and F of forces between links and by coordinates. With the
 * wrenches w that enforce u_i − X_i u_p − S_i x_i = 0 and the multipliers λ of loops it is the
 * symmetric system
 *
 * <pre>
 * (H u)_i + (F u)_i + w_i − Σ_c X_cᵀ w_c + J_uᵀ λ = 0
 * D_i x_i − S_iᵀ w_i + J_xᵀ λ = b_i
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

  /** Places and velocities in a block of {@link FarBlocks}. */
  private static final int BY_VELOCITY = 6;

  private static final int BY_PLACE = 12;

  /** Size of a link without any, as a part of the largest. */
  private static final double LEAST_SIZE = 1e-8;

  /** Smallest element of D, as a fraction of its largest. */
  private static final double LEAST_WEIGHT = 1e-9;

  /** Elements that differ from those across by less than this part of the largest are symmetric. */
  private static final double SYMMETRIC = 1e-9;

  private final TreeMotion motion;
  private final TreeGeometry tree;
  private final LinkInertias inertias;
  private final NewtonEuler newtonEuler;
  private final PlacedLinks links;
  private final FarBlocks far;
  private final LoopWrenches rows;
  private final double[] residual;
  private final double[] noForces;
  private double[] wrenches = {};

  /** X, 36 for each link. */
  private final double[] carrying;

  /** D: of the rotation of each link, N·m, and of each velocity, N·m or N/m. */
  private final double[] turnWeight;

  private final double[] jointWeight;
  private final double length;
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
  private final double[] block = new double[36];
  private final double[] product = new double[36];
  private final double[] turned = new double[36];
  private final double[] net = new double[6];
  private final double[] work = new double[6];
  private final ForceJacobian forces = new LinkForces();

  /**
   * Makes a workspace.
   *
   * @param motion swept by the caller at rest, with accelerations of zero, before each evaluation
   * @param pairs links that forces and loops couple, two for each pair
   * @param rows of loops, written by the caller before each factorisation; rows of zeros are
   *     permitted
   */
  public LinksAtRest(TreeMotion motion, int[] pairs, LoopWrenches rows) {
    this.motion = motion;
    this.rows = rows;
    tree = motion.tree();
    inertias = new LinkInertias(tree);
    newtonEuler = new NewtonEuler(motion, inertias);
    links = new PlacedLinks(tree);
    int count = tree.linkCount;
    far = new FarBlocks(tree, withSelf(pairs));
    residual = new double[tree.velocityCount];
    noForces = new double[tree.velocityCount];
    carrying = new double[36 * count];
    turnWeight = new double[count];
    jointWeight = new double[tree.velocityCount];
    length = inertias.meanRadius();
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
        unit[unknown] = r < WRENCH ? unit(r) : unitOf(link);
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

  private int[] withSelf(int[] pairs) {
    int[] all = Arrays.copyOf(pairs, pairs.length + 2 * tree.linkCount);
    for (int link = 0; link < tree.linkCount; link++) {
      all[pairs.length + 2 * link] = link;
      all[pairs.length + 2 * link + 1] = link;
    }
    return all;
  }

  /**
   * Returns the unknowns of each link in the order of elimination: u and w in turn, which are
   * pivots of two rows, x, and the loops whose last link it is.
   */
  private int[][] groups() {
    int[] order = order();
    int[] turn = new int[tree.linkCount];
    IntStream.Builder[] groups = new IntStream.Builder[tree.linkCount];
    for (int i = 0; i < order.length; i++) {
      int from = at[order[i]];
      turn[order[i]] = i;
      groups[i] = IntStream.builder();
      for (int r = 0; r < WRENCH; r++) {
        groups[i].add(from + r).add(from + WRENCH + r);
      }
      IntStream.range(from + JOINT, at[order[i] + 1]).forEach(groups[i]::add);
    }
    for (int row = 0; row < rows.count(); row++) {
      int last = IntStream.of(touched(row)).map(link -> turn[link]).max().orElse(0);
      groups[last].add(firstMultiplier + row);
    }
    return Arrays.stream(groups).map(group -> group.build().toArray()).toArray(int[][]::new);
  }

  /**
   * Returns the links, each behind those on it: always one that is coupled with the fewest others.
   */
  private int[] order() {
    List<SortedSet<Integer>> coupled = couplings();
    int[] onIt = new int[tree.linkCount];
    for (int parent : tree.parent) {
      if (parent != TreeGeometry.ROOT) {
        onIt[parent]++;
      }
    }
    // by degree, and the outermost first
    SortedSet<long[]> ready =
        new TreeSet<>((a, b) -> a[0] != b[0] ? Long.compare(a[0], b[0]) : Long.compare(b[1], a[1]));
    for (int link = 0; link < tree.linkCount; link++) {
      if (onIt[link] == 0) {
        ready.add(new long[] {coupled.get(link).size(), link});
      }
    }
    int[] order = new int[tree.linkCount];
    for (int i = 0; i < order.length; i++) {
      int link = (int) ready.first()[1];
      ready.remove(ready.first());
      order[i] = link;
      SortedSet<Integer> left = coupled.get(link);
      for (int other : left) {
        boolean isReady = onIt[other] == 0;
        if (isReady) {
          ready.remove(new long[] {coupled.get(other).size(), other});
        }
        coupled.get(other).addAll(left);
        coupled.get(other).remove(other);
        coupled.get(other).remove(link);
        boolean wasOnIt = tree.parent[link] == other;
        onIt[other] -= wasOnIt ? 1 : 0;
        if (isReady || (wasOnIt && onIt[other] == 0)) {
          ready.add(new long[] {coupled.get(other).size(), other});
        }
      }
    }
    return order;
  }

  /** Returns the links that each is coupled with, by joints, forces and loops. */
  private List<SortedSet<Integer>> couplings() {
    List<SortedSet<Integer>> coupled = new ArrayList<>();
    for (int link = 0; link < tree.linkCount; link++) {
      coupled.add(new TreeSet<>());
    }
    for (int link = 0; link < tree.linkCount; link++) {
      couple(coupled, link, tree.parent[link]);
    }
    for (int pair = 0; pair < far.count(); pair++) {
      couple(coupled, far.on[pair], far.by[pair]);
    }
    for (int row = 0; row < rows.count(); row++) {
      int[] touched = touched(row);
      for (int link : touched) {
        couple(coupled, touched[0], link);
      }
    }
    return coupled;
  }

  private static void couple(List<SortedSet<Integer>> coupled, int a, int b) {
    if (a != b && b != TreeGeometry.ROOT) {
      coupled.get(a).add(b);
      coupled.get(b).add(a);
    }
  }

  /** Returns the links of a row, with those of its velocities. */
  private int[] touched(int row) {
    return IntStream.concat(
            IntStream.of(rows.links[row]),
            IntStream.of(rows.velocities[row]).map(k -> tree.linkOfVelocity[k]))
        .toArray();
  }

  /**
   * Places the links and forgets the derivatives of forces, which {@link #forces} then takes.
   *
   * @param wrenches external ones with those of loops, 6 per link; kept
   */
  public void evaluate(double[] wrenches) {
    this.wrenches = wrenches;
    newtonEuler.evaluate(wrenches, noForces, residual);
    links.placeAt(motion);
    far.clear();
    Arrays.fill(multiplier, Double.NaN);
    for (int link = 0; link < tree.linkCount; link++) {
      formCarrying(link);
    }
  }

  /** Returns what takes the derivatives of forces between the links that were announced. */
  public ForceJacobian forces() {
    return forces;
  }

  /** X = [Rᵀ, 0; −Rᵀ p ×, Rᵀ]. */
  private void formCarrying(int link) {
    if (tree.parent[link] == TreeGeometry.ROOT) {
      return;
    }
    int to = 36 * link;
    for (int c = 0; c < 3; c++) {
      Arrays.fill(work, 0);
      work[c] = 1;
      cross(work, 0, links.position, 3 * link, work, 3);
      for (int r = 0; r < 3; r++) {
        double turn = links.rotation[9 * link + 3 * c + r];
        double lever = 0;
        for (int i = 0; i < 3; i++) {
          lever += links.rotation[9 * link + 3 * i + r] * work[3 + i];
        }
        carrying[to + 6 * r + c] = turn;
        carrying[to + 6 * (3 + r) + 3 + c] = turn;
        carrying[to + 6 * (3 + r) + c] = lever;
      }
    }
  }

  /** Returns whether K is symmetric at an equilibrium: whether the forces have a potential. */
  public boolean isStiffnessSymmetric() {
    return isSymmetric(BY_PLACE);
  }

  /** Returns whether C has an element that is not zero. */
  public boolean isDamped() {
    for (int e = 0; e < far.wrench.length; e++) {
      int column = e % WIDTH;
      if (column >= BY_VELOCITY && column < BY_PLACE && far.wrench[e] != 0) {
        return true;
      }
    }
    for (int e = 0; e < far.force.length; e++) {
      int column = e % WIDTH;
      if (column >= BY_VELOCITY && column < BY_PLACE && far.force[e] != 0) {
        return true;
      }
    }
    return Arrays.stream(far.wrenchBy.velocity).anyMatch(element -> element != 0)
        || Arrays.stream(far.forceBy.velocity).anyMatch(element -> element != 0);
  }

  /** Returns whether C is symmetric. */
  public boolean isDampingSymmetric() {
    return isSymmetric(BY_VELOCITY);
  }

  private boolean isSymmetric(int column) {
    double largest = 0;
    double across = 0;
    for (int pair = 0; pair < far.count(); pair++) {
      int on = far.on[pair];
      int by = far.by[pair];
      int mirror = far.find(by, on);
      if (on == by) {
        formTurning(on, column == BY_PLACE);
      } else {
        Arrays.fill(turned, 0);
      }
      for (int r = 0; r < 6; r++) {
        for (int c = 0; c < 6; c++) {
          double units = unit(r) * unit(c);
          double element = far.wrench[BLOCK * pair + WIDTH * r + column + c];
          double other = far.wrench[BLOCK * mirror + WIDTH * c + column + r];
          largest = Math.max(largest, units * (Math.abs(element) + Math.abs(turned[6 * r + c])));
          across = Math.max(across, units * Math.abs(element - other + turned[6 * r + c]));
        }
      }
      for (int k = 0; k < count(by); k++) {
        double unit = unitOf(by);
        for (int r = 0; r < 6; r++) {
          double element = columns(far.wrenchBy, column)[far.wrenchBy.at(pair, k) + r];
          double other = far.force[WIDTH * (FarBlocks.MOST * mirror + k) + column + r];
          double units = unit * unit(r);
          largest = Math.max(largest, units * Math.abs(element));
          across = Math.max(across, units * Math.abs(element - other));
        }
        for (int j = 0; j < count(on); j++) {
          double[] elements = columns(far.forceBy, column);
          double element = elements[far.forceBy.at(pair, k) + j];
          double other = elements[far.forceBy.at(mirror, j) + k];
          double units = unit * unitOf(on);
          largest = Math.max(largest, units * Math.abs(element));
          across = Math.max(across, units * Math.abs(element - other));
        }
      }
    }
    return across <= SYMMETRIC * largest;
  }

  private static double[] columns(FarBlocks.Columns of, int column) {
    return column == BY_PLACE ? of.place : of.velocity;
  }

  private double unit(int r) {
    return r < 3 ? 1 : length;
  }

  private double unitOf(int link) {
    return tree.kind[link] == LinkKind.SLIDE ? length : 1;
  }

  private int count(int link) {
    return links.end(link) - links.first(link);
  }

  /**
   * Writes what the stiffness of a link by its loads adds to the difference of elements across: its
   * weight's own, and −[n ×, f ×; f ×, 0] of all loads, whose displacements do not commute.
   */
  private void formTurning(int link, boolean byPlace) {
    Arrays.fill(turned, 0);
    if (!byPlace) {
      return;
    }
    Arrays.fill(block, 0);
    addWeight(link, 1);
    double[] g = newtonEuler.gravity;
    cross(g, 3 * link, inertias.moment, 3 * link, net, 0);
    for (int i = 0; i < 3; i++) {
      net[3 + i] = -tree.mass[link] * g[3 * link + i];
    }
    for (int i = 0; i < 6; i++) {
      net[i] -= wrenches.length == 0 ? 0 : wrenches[6 * link + i];
    }
    addForce(net, 0, 1, turned);
    for (int r = 0; r < 6; r++) {
      for (int c = 0; c < 6; c++) {
        turned[6 * r + c] += block[6 * r + c] - block[6 * c + r];
      }
    }
  }

  /** Adds the stiffness of a link's weight, [−h × g ×, 0; −m g ×, 0], to the block. */
  private void addWeight(int link, double factor) {
    double[] g = newtonEuler.gravity;
    for (int c = 0; c < 3; c++) {
      Arrays.fill(work, 0);
      work[c] = 1;
      cross(g, 3 * link, work, 0, work, 3);
      cross(inertias.moment, 3 * link, work, 3, work, 0);
      for (int r = 0; r < 3; r++) {
        block[6 * r + c] -= factor * work[r];
        block[6 * (3 + r) + c] -= factor * tree.mass[link] * work[3 + r];
      }
    }
  }

  /** Adds −[n ×, f ×; f ×, 0] for a wrench [n; f]. */
  private static void addForce(double[] w, int at, double factor, double[] sum) {
    for (int c = 0; c < 3; c++) {
      int next = (c + 1) % 3;
      int last = (c + 2) % 3;
      double n = factor * w[at + last];
      double f = factor * w[at + 3 + last];
      // (w ×) has −w_last in (c, next) and w_last in (next, c)
      sum[6 * c + next] += n;
      sum[6 * next + c] -= n;
      sum[6 * c + 3 + next] += f;
      sum[6 * next + 3 + c] -= f;
      sum[6 * (3 + c) + next] += f;
      sum[6 * (3 + next) + c] -= f;
    }
  }

  /**
   * Forms D for the place and forces last evaluated.
   *
   * @param left residual forces, one for each velocity of the state; not modified
   * @param units of the velocities of the state; not modified
   */
  public void weigh(double[] left, double[] units) {
    double[] along = slidingStiffness();
    double most = Double.MIN_NORMAL;
    Arrays.fill(turnWeight, 0);
    for (int link = tree.linkCount - 1; link >= 0; link--) {
      int pair = far.find(link, link);
      double own =
          norm(inertias.moment, 3 * link) * norm(newtonEuler.gravity, 3 * link)
              + (wrenches.length == 0 ? 0 : norm(wrenches, 6 * link));
      for (int r = 0; r < 3; r++) {
        own += Math.abs(far.wrench[BLOCK * pair + WIDTH * r + BY_PLACE + r]);
      }
      turnWeight[link] += own;
      int parent = tree.parent[link];
      if (parent != TreeGeometry.ROOT) {
        turnWeight[parent] +=
            norm(newtonEuler.force, 6 * link + 3) * norm(links.position, 3 * link);
      }
      most = Math.max(most, turnWeight[link]);
      for (int k = links.first(link); k < links.end(link); k++) {
        int j = k - links.first(link);
        double weight = Math.abs(far.forceBy.place[far.forceBy.at(pair, j) + j]);
        if (tree.kind[link] == LinkKind.SLIDE) {
          weight += Math.abs(along[k]) + Math.abs(left[k]) / units[k];
        }
        jointWeight[k] = weight;
        most = Math.max(most, weight * unitOf(link) * unitOf(link));
      }
    }
    for (int link = 0; link < tree.linkCount; link++) {
      turnWeight[link] = Math.max(turnWeight[link], LEAST_WEIGHT * most);
      for (int k = links.first(link); k < links.end(link); k++) {
        double least = LEAST_WEIGHT * most / (unitOf(link) * unitOf(link));
        jointWeight[k] =
            tree.kind[link] == LinkKind.SLIDE ? Math.max(jointWeight[k], least) : jointWeight[k];
      }
    }
  }

  /** Returns Sᵀ K S of sliding joints, by the links on them as one rigid body each. */
  private double[] slidingStiffness() {
    double[] along = new double[tree.velocityCount];
    if (Arrays.stream(tree.kind).noneMatch(kind -> kind == LinkKind.SLIDE)) {
      return along;
    }
    double[] rigid = new double[36 * tree.linkCount];
    for (int link = tree.linkCount - 1; link >= 0; link--) {
      formOwn(link, 0, 0, 1);
      for (int i = 0; i < 36; i++) {
        rigid[36 * link + i] += block[i];
      }
      for (int k = links.first(link); k < links.end(link); k++) {
        for (int r = 0; r < 6; r++) {
          for (int c = 0; c < 6; c++) {
            along[k] +=
                links.subspace[6 * k + r]
                    * rigid[36 * link + 6 * r + c]
                    * links.subspace[6 * k + c];
          }
        }
      }
      if (tree.parent[link] != TreeGeometry.ROOT) {
        multiply(rigid, 36 * link, carrying, 36 * link, product);
        addTransposedProduct(carrying, 36 * link, product, rigid, 36 * tree.parent[link]);
      }
    }
    return along;
  }

  private static double norm(double[] x, int at) {
    return Math.sqrt(dot(x, at, x, at));
  }

  /** Writes the product of two matrices of 6 rows. */
  private static void multiply(double[] a, int ia, double[] b, int ib, double[] out) {
    for (int r = 0; r < 6; r++) {
      for (int c = 0; c < 6; c++) {
        double sum = 0;
        for (int i = 0; i < 6; i++) {
          sum += a[ia + 6 * r + i] * b[ib + 6 * i + c];
        }
        out[6 * r + c] = sum;
      }
    }
  }

  /** Adds aᵀ b. */
  private static void addTransposedProduct(double[] a, int ia, double[] b, double[] out, int to) {
    for (int r = 0; r < 6; r++) {
      for (int c = 0; c < 6; c++) {
        double sum = 0;
        for (int i = 0; i < 6; i++) {
          sum += a[ia + 6 * i + r] * b[6 * i + c];
        }
        out[to + 6 * r + c] += sum;
      }
    }
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
        scale[unknown] = ofWrench ? root / unit(r - WRENCH) : unit[unknown] / root;
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
          put(row, at[parent] + c, -carrying[36 * link + 6 * r + c]);
        }
      }
    }
  }

  /** Writes the symmetric part of H. */
  private void formOwn(int link, double m, double c, double k) {
    Arrays.fill(block, 0);
    addWeight(link, k);
    int from = BLOCK * far.find(link, link);
    for (int r = 0; r < 6; r++) {
      for (int e = 0; e < 6; e++) {
        int element = from + WIDTH * r + e;
        block[6 * r + e] +=
            c * far.wrench[element + BY_VELOCITY] + k * far.wrench[element + BY_PLACE];
      }
    }
    double[] h = inertias.moment;
    for (int r = 0; r < 3; r++) {
      for (int e = 0; e < 3; e++) {
        block[6 * r + e] += m * inertias.second[9 * link + 3 * r + e];
      }
      int after = (r + 1) % 3;
      int last = (r + 2) % 3;
      // I = [J, h ×; −h ×, m]
      block[6 * r + 3 + last] += m * h[3 * link + after];
      block[6 * r + 3 + after] -= m * h[3 * link + last];
      block[6 * (3 + r) + last] -= m * h[3 * link + after];
      block[6 * (3 + r) + after] += m * h[3 * link + last];
      block[6 * (3 + r) + 3 + r] += m * tree.mass[link];
    }
    for (int r = 0; r < 6; r++) {
      for (int e = 0; e < r; e++) {
        double mean = 0.5 * (block[6 * r + e] + block[6 * e + r]);
        block[6 * r + e] = mean;
        block[6 * e + r] = mean;
      }
    }
  }

  /** H, D and the coupling of both, with D of the shift. */
  private void putOwn(int link, double m, double c, double k, double shift) {
    formOwn(link, m, c, k);
    for (int r = 0; r < 6; r++) {
      for (int e = 0; e <= r; e++) {
        double weight = r == e && r < 3 ? shift * turnWeight[link] : 0;
        put(at[link] + r, at[link] + e, block[6 * r + e] + weight);
      }
    }
    for (int j = links.first(link); j < links.end(link); j++) {
      put(x(link, j), x(link, j), shift * jointWeight[j]);
    }
  }

  /** k f · (X u_p × u), half of it on each side of the diagonal. */
  private void putForce(int link, double k) {
    int parent = tree.parent[link];
    if (parent == TreeGeometry.ROOT) {
      return;
    }
    Arrays.fill(turned, 0);
    addForce(newtonEuler.force, 6 * link, 0.5 * k, turned);
    Arrays.fill(product, 0);
    addTransposedProduct(carrying, 36 * link, turned, product, 0);
    for (int r = 0; r < 6; r++) {
      for (int c = 0; c < 6; c++) {
        if (r < 3 || c < 3) {
          put(at[parent] + r, at[link] + c, product[6 * r + c]);
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
        double force = c * far.wrench[element + BY_VELOCITY] + k * far.wrench[element + BY_PLACE];
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
        double force = c * far.force[from + BY_VELOCITY + e] + k * far.force[from + BY_PLACE + e];
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
          sum[at[parent] + c] += carrying[36 * link + 6 * r + c] * sum[at[link] + r];
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
          displaced += carrying[36 * link + 6 * r + c] * right[at[parent] + c];
        }
        for (int k = links.first(link); k < links.end(link); k++) {
          displaced += links.subspace[6 * k + r] * x[k];
        }
        right[at[link] + r] = displaced;
      }
    }
  }

  /** Takes derivatives of forces, whose sign is the opposite: F = M a + b − τ − Jᵀ w. */
  private final class LinkForces implements ForceJacobian {
    @Override
    public void wrenchByLink(int on, int by, double[] byPlace, double[] byVelocity) {
      subtract(far.wrench, BLOCK * far.find(on, by), 6, byPlace, byVelocity);
    }

    private void subtract(
        double[] matrix, int from, int lines, double[] byPlace, double[] byVelocity) {
      for (int r = 0; r < lines; r++) {
        for (int c = 0; c < 6; c++) {
          matrix[from + WIDTH * r + BY_VELOCITY + c] -= byVelocity[6 * r + c];
          matrix[from + WIDTH * r + BY_PLACE + c] -= byPlace[6 * r + c];
        }
      }
    }

    @Override
    public void wrenchByCoordinate(int on, int by, double[] byPlace, double[] byVelocity) {
      if (by < tree.stateVelocityCount) {
        int link = tree.linkOfVelocity[by];
        int from = far.wrenchBy.at(far.find(on, link), by - tree.velocityAt[link]);
        for (int r = 0; r < 6; r++) {
          far.wrenchBy.place[from + r] -= byPlace[r];
          far.wrenchBy.velocity[from + r] -= byVelocity[r];
        }
      }
    }

    @Override
    public void forceByLink(int on, int by, double[] byPlace, double[] byVelocity) {
      if (on < tree.stateVelocityCount) {
        int link = tree.linkOfVelocity[on];
        int line = FarBlocks.MOST * far.find(link, by) + on - tree.velocityAt[link];
        subtract(far.force, WIDTH * line, 1, byPlace, byVelocity);
      }
    }

    @Override
    public void forceByCoordinate(int on, int by, double byPlace, double byVelocity) {
      if (on < tree.stateVelocityCount && by < tree.stateVelocityCount) {
        int link = tree.linkOfVelocity[by];
        int other = tree.linkOfVelocity[on];
        int element =
            far.forceBy.at(far.find(other, link), by - tree.velocityAt[link])
                + on
                - tree.velocityAt[other];
        far.forceBy.place[element] -= byPlace;
        far.forceBy.velocity[element] -= byVelocity;
      }
    }
  }
}
