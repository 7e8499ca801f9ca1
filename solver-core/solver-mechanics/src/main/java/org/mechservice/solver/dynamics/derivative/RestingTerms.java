package org.mechservice.solver.dynamics.derivative;

import static org.mechservice.solver.dynamics.derivative.FarBlocks.PLACE;
import static org.mechservice.solver.dynamics.derivative.FarBlocks.VELOCITY;
import static org.mechservice.solver.dynamics.derivative.PlacedLinks.BLOCK;
import static org.mechservice.solver.dynamics.derivative.PlacedLinks.WIDTH;
import static org.mechservice.solver.spatial.Blocks.cross;
import static org.mechservice.solver.spatial.Blocks.dot;

import java.util.Arrays;
import org.mechservice.solver.dynamics.recursion.LinkInertias;
import org.mechservice.solver.dynamics.recursion.NewtonEuler;
import org.mechservice.solver.kinematics.LinkKind;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;

/**
 * The terms of {@link LinksAtRest}, link by link: X, H, the forces in joints, F by {@link #far},
 * and the weights D. Matrices are 6 × 6, row by row, for small displacements [rotation;
 * displacement] in link axes, rad and m, and wrenches [moment; force], N·m and N. Workspace of one
 * thread.
 */
final class RestingTerms {
  /** Smallest element of D, as a fraction of its largest. */
  private static final double LEAST_WEIGHT = 1e-9;

  /** Elements that differ from those across by less than this part of the largest are symmetric. */
  private static final double SYMMETRIC = 1e-9;

  final TreeGeometry tree;
  final PlacedLinks links;

  /** Derivatives of forces between links, with a pair for each link and itself. */
  final FarBlocks far;

  /** X, 36 for each link. */
  final double[] carrying;

  /** H of the link formed last. */
  final double[] block = new double[36];

  /** The product formed last by {@link #formForce}. */
  final double[] product = new double[36];

  /** D: of the rotation of each link, N·m, and of each velocity, N·m or N/m. */
  final double[] turnWeight;

  final double[] jointWeight;

  private final TreeMotion motion;
  private final LinkInertias inertias;
  private final NewtonEuler newtonEuler;
  private final double[] residual;
  private final double[] noForces;
  private final double length;
  private double[] wrenches = {};
  private final double[] turned = new double[36];
  private final double[] net = new double[6];
  private final double[] work = new double[6];

  /**
   * @param motion swept by the caller at rest before each evaluation
   * @param pairs links that forces and loops couple, two for each pair
   */
  RestingTerms(TreeMotion motion, int[] pairs) {
    this.motion = motion;
    tree = motion.tree();
    inertias = new LinkInertias(tree);
    newtonEuler = new NewtonEuler(motion, inertias);
    links = new PlacedLinks(tree);
    far = new FarBlocks(tree, withSelf(pairs));
    carrying = new double[36 * tree.linkCount];
    turnWeight = new double[tree.linkCount];
    jointWeight = new double[tree.velocityCount];
    residual = new double[tree.velocityCount];
    noForces = new double[tree.velocityCount];
    length = inertias.meanRadius();
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
   * Places the links and forgets the derivatives of forces.
   *
   * @param wrenches external ones with those of loops, 6 per link; kept
   */
  void evaluate(double[] wrenches) {
    this.wrenches = wrenches;
    newtonEuler.evaluate(wrenches, noForces, residual);
    links.placeAt(motion);
    far.clear();
    for (int link = 0; link < tree.linkCount; link++) {
      formCarrying(link);
    }
  }

  /** Returns the unit of component r of a displacement: 1 for rotations, a length of the links. */
  double unit(int r) {
    return r < 3 ? 1 : length;
  }

  /** Returns the unit of a displacement in the joint of a link. */
  double unitOf(int link) {
    return tree.kind[link] == LinkKind.SLIDE ? length : 1;
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

  /** Writes the symmetric part of H = m M + c C + k K of a link to {@link #block}. */
  void formOwn(int link, double m, double c, double k) {
    Arrays.fill(block, 0);
    addWeight(link, k);
    int from = BLOCK * far.find(link, link);
    for (int r = 0; r < 6; r++) {
      for (int e = 0; e < 6; e++) {
        int element = from + WIDTH * r + e;
        block[6 * r + e] += c * far.wrench[element + VELOCITY] + k * far.wrench[element + PLACE];
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

  /** Writes half of Xᵀ (k f ×) of the force f in the joint of a link to {@link #product}. */
  void formForce(int link, double k) {
    Arrays.fill(turned, 0);
    addForce(newtonEuler.force, 6 * link, 0.5 * k, turned);
    Arrays.fill(product, 0);
    addTransposedProduct(carrying, 36 * link, turned, product, 0);
  }

  /** Returns whether K is symmetric at an equilibrium: whether the forces have a potential. */
  boolean isStiffnessSymmetric() {
    return isSymmetric(PLACE);
  }

  /** Returns whether C has an element that is not zero. */
  boolean isDamped() {
    for (int e = 0; e < far.wrench.length; e++) {
      int column = e % WIDTH;
      if (column >= VELOCITY && column < PLACE && far.wrench[e] != 0) {
        return true;
      }
    }
    for (int e = 0; e < far.force.length; e++) {
      int column = e % WIDTH;
      if (column >= VELOCITY && column < PLACE && far.force[e] != 0) {
        return true;
      }
    }
    return Arrays.stream(far.wrenchBy.velocity).anyMatch(element -> element != 0)
        || Arrays.stream(far.forceBy.velocity).anyMatch(element -> element != 0);
  }

  /** Returns whether C is symmetric. */
  boolean isDampingSymmetric() {
    return isSymmetric(VELOCITY);
  }

  private boolean isSymmetric(int column) {
    double largest = 0;
    double across = 0;
    for (int pair = 0; pair < far.count(); pair++) {
      int on = far.on[pair];
      int by = far.by[pair];
      int mirror = far.find(by, on);
      if (on == by) {
        formTurning(on, column == PLACE);
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
    return column == PLACE ? of.place : of.velocity;
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
  void weigh(double[] left, double[] units) {
    double[] along = slidingStiffness();
    double most = Double.MIN_NORMAL;
    Arrays.fill(turnWeight, 0);
    for (int link = tree.linkCount - 1; link >= 0; link--) {
      int pair = far.find(link, link);
      double own =
          norm(inertias.moment, 3 * link) * norm(newtonEuler.gravity, 3 * link)
              + (wrenches.length == 0 ? 0 : norm(wrenches, 6 * link));
      for (int r = 0; r < 3; r++) {
        own += Math.abs(far.wrench[BLOCK * pair + WIDTH * r + PLACE + r]);
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
}
