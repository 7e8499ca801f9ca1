package org.mechservice.solver.dynamics.derivative;

import static org.mechservice.solver.dynamics.derivative.PlacedLinks.BLOCK;
import static org.mechservice.solver.dynamics.derivative.PlacedLinks.WIDTH;
import static org.mechservice.solver.dynamics.derivative.PlacedLinks.add;
import static org.mechservice.solver.dynamics.derivative.PlacedLinks.dot6;
import static org.mechservice.solver.dynamics.derivative.PlacedLinks.multiply;
import static org.mechservice.solver.dynamics.derivative.PlacedLinks.turn;

import java.util.Arrays;
import org.mechservice.solver.dynamics.recursion.LinkInertias;
import org.mechservice.solver.dynamics.recursion.NewtonEuler;
import org.mechservice.solver.force.applied.ForceJacobian;
import org.mechservice.solver.kinematics.LinkKind;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;

/**
 * The derivatives of {@link ResidualJacobian} by motions of links instead of velocities: O(n)
 * numbers, where the matrices of a chain have n² elements. Workspace of one thread.
 *
 * <p>A product of M, C = ∂F/∂v or K = ∂F/∂q with x is a sweep outwards and one inwards, like the
 * equations of motion. With z_i = [a; b; ξ] of link i, the 18 numbers that x changes in its
 * acceleration, velocity and place,
 *
 * <pre>
 * z_i = X_i z_p + Z_i x_i
 * w_i = P_i z_i + R_i z_p + G_i x_i + Σ_c (X_c* w_c + Q_c z_c)
 * F_i = S_iᵀ (w_i − G_i x_i) + D_i x_i,     P = [I, 2B − ∂f/∂V, −∂f/∂X]
 *
 *      M            C                   K
 * Z    [S; 0; 0]    [ψ' + S'; S; 0]     [ψ''; ψ'; S]
 * G    0            0                   S ×* f
 * D    armatures    dampers             springs
 * </pre>
 *
 * <p>where c are the links on link i, f is the force that the parent exerts, and R and Q the forces
 * between a link and its parent. Other pairs of links have {@linkplain FarBlocks blocks of their
 * own}. Columns of balls that are given in the axes of the parent turn as in {@link
 * ResidualJacobian}.
 */
public final class LinkJacobian implements StepDerivatives {
  final TreeGeometry tree;
  final LinkInertias inertias;

  /** Where the links are at the derivatives. */
  final PlacedLinks links;

  /** P, R and Q, 6 × 18 for each link: P by its motion, R by its parent's, Q that on the parent. */
  final double[] own;

  final double[] byParent;
  final double[] onParent;

  /** Whether a link has R or Q. */
  final boolean[] coupled;

  /** Couplings of links that are not neighbours, or of coordinates of different joints. */
  final FarBlocks far;

  /** Columns of K and of C. */
  final LinkColumns placeColumns;

  final LinkColumns velocityColumns;

  private final TreeMotion motion;
  private final NewtonEuler newtonEuler;
  private final VelocityDerivatives changes;
  private final MotionColumns columns;
  private final double[] residual;
  private final double[] noForces;
  private final ForceJacobian forces = new LinkForces();

  /** Sweeps: 18 for each link, and 6. */
  private final double[] moved;

  private final double[] wrench;
  private final double[] work = new double[WIDTH];
  private final double[] triple = new double[3];

  /**
   * Makes a workspace for forces between neighbours alone.
   *
   * @param motion swept by the caller, with accelerations, before each evaluation
   */
  public LinkJacobian(TreeMotion motion) {
    this(motion, new int[0]);
  }

  /**
   * Makes a workspace.
   *
   * @param motion swept by the caller, with accelerations, before each evaluation
   * @param pairs links that forces couple, two for each pair; empty if all are neighbours
   */
  public LinkJacobian(TreeMotion motion, int[] pairs) {
    this.motion = motion;
    tree = motion.tree();
    inertias = new LinkInertias(tree);
    newtonEuler = new NewtonEuler(motion, inertias);
    changes = new VelocityDerivatives(motion, inertias);
    columns = new MotionColumns(motion, newtonEuler);
    residual = new double[tree.velocityCount];
    noForces = new double[tree.velocityCount];
    links = new PlacedLinks(tree);
    int count = tree.linkCount;
    own = new double[BLOCK * count];
    byParent = new double[BLOCK * count];
    onParent = new double[BLOCK * count];
    coupled = new boolean[count];
    far = new FarBlocks(tree, pairs);
    placeColumns = new LinkColumns(tree.velocityCount);
    velocityColumns = new LinkColumns(tree.velocityCount);
    moved = new double[WIDTH * count];
    wrench = new double[6 * count];
  }

  /**
   * {@inheritDoc} It takes those that act between a link and its parent, between a link and the
   * root, between coordinates of one link, and between the pairs of links given at the start.
   */
  @Override
  public ForceJacobian forces() {
    return forces;
  }

  @Override
  public void evaluate(double[] wrenches) {
    newtonEuler.evaluate(wrenches, noForces, residual);
    links.placeAt(motion);
    changes.formAlone();
    Arrays.fill(own, 0);
    for (int link = 0; link < tree.linkCount; link++) {
      if (coupled[link]) {
        Arrays.fill(byParent, BLOCK * link, BLOCK * (link + 1), 0);
        Arrays.fill(onParent, BLOCK * link, BLOCK * (link + 1), 0);
        coupled[link] = false;
      }
      formInertia(link);
      columns.form(link);
      for (int k = links.first(link); k < links.end(link); k++) {
        formColumns(link, k);
      }
    }
    Arrays.fill(placeColumns.force, 0);
    Arrays.fill(velocityColumns.force, 0);
    far.clear();
  }

  /** P = [I, 2B, 0] with I = [J, h×; −h×, m]. */
  private void formInertia(int link) {
    int at = BLOCK * link;
    double[] h = inertias.moment;
    for (int r = 0; r < 3; r++) {
      for (int c = 0; c < 3; c++) {
        own[at + WIDTH * r + c] = inertias.second[9 * link + 3 * r + c];
      }
      int next = (r + 1) % 3;
      int last = (r + 2) % 3;
      own[at + WIDTH * r + 3 + last] = h[3 * link + next];
      own[at + WIDTH * r + 3 + next] = -h[3 * link + last];
      own[at + WIDTH * (3 + r) + last] = -h[3 * link + next];
      own[at + WIDTH * (3 + r) + next] = h[3 * link + last];
      own[at + WIDTH * (3 + r) + 3 + r] = tree.mass[link];
    }
    for (int c = 0; c < 3; c++) {
      Arrays.fill(work, 0, 12, 0);
      work[c] = 1;
      changes.addApplied(link, work, 0, work, 6);
      for (int r = 0; r < 6; r++) {
        own[at + WIDTH * r + 6 + c] = work[6 + r];
      }
    }
  }

  private void formColumns(int link, int k) {
    int at = WIDTH * k;
    System.arraycopy(columns.second, 6 * k, placeColumns.motion, at, 6);
    System.arraycopy(columns.first, 6 * k, placeColumns.motion, at + 6, 6);
    System.arraycopy(motion.subspace, 6 * k, placeColumns.motion, at + 12, 6);
    System.arraycopy(columns.both, 6 * k, velocityColumns.motion, at, 6);
    System.arraycopy(motion.subspace, 6 * k, velocityColumns.motion, at + 6, 6);
    Arrays.fill(placeColumns.wrench, 6 * k, 6 * k + 6, 0);
    ResidualJacobian.addForceTurned(
        motion.subspace, 6 * k, newtonEuler.force, 6 * link, placeColumns.wrench, 6 * k);
  }

  /** Adds the armatures to D of M. */
  void addArmature(double[] force) {
    for (int k = 0; k < tree.stateVelocityCount; k++) {
      force[3 * k + k - tree.velocityAt[tree.linkOfVelocity[k]]] += tree.armature[k];
    }
  }

  /** {@inheritDoc} They get ∂F/∂v [ω]× + M [ω']×, and −[Sᵀ f]× in their own rows. */
  @Override
  public void finish() {
    for (int link = 0; link < tree.linkCount; link++) {
      if (tree.kind[link] == LinkKind.BALL && !tree.driven[link] && !tree.inverse[link]) {
        int k = links.first(link);
        addTurned(12, velocityColumns.motion, WIDTH, motion.v, k, placeColumns.motion, WIDTH);
        addTurned(6, motion.subspace, 6, motion.a, k, placeColumns.motion, WIDTH);
        addTurned(3, velocityColumns.force, 3, motion.v, k, placeColumns.force, 3);
        for (int c = 0; c < 3; c++) {
          int next = (c + 1) % 3;
          int last = (c + 2) % 3;
          // the force that accelerates the armature does not turn with the link
          double turned = residual[k + c] - tree.armature[k + c] * motion.a[k + c];
          placeColumns.force[3 * (k + last) + next] += turned;
          placeColumns.force[3 * (k + next) + last] -= turned;
        }
      }
    }
  }

  /**
   * Adds x [ω]× to the columns of a ball.
   *
   * @param rows of the columns that are added, from the first on
   * @param from x, columns of the given height; not modified
   * @param omega ω at k
   * @param k first velocity of the ball
   * @param to columns of the given height; added to
   */
  private void addTurned(
      int rows, double[] from, int height, double[] omega, int k, double[] to, int toHeight) {
    for (int r = 0; r < rows; r++) {
      int at = height * k + r;
      turn(from[at], from[at + height], from[at + 2 * height], omega, k, triple);
      for (int c = 0; c < 3; c++) {
        to[toHeight * (k + c) + r] += triple[c];
      }
    }
  }

  @Override
  public boolean isFinite() {
    return Double.isFinite(
        PlacedLinks.sum(own) + placeColumns.sum() + velocityColumns.sum() + far.sum());
  }

  /**
   * Adds factor times the product of a matrix with x.
   *
   * @param matrix {@link #placeColumns}, or columns that have been combined with those of {@link
   *     #far}
   * @param x nv numbers; not modified
   * @param sum nv numbers; added to
   */
  void addProduct(LinkColumns matrix, double[] x, double factor, double[] sum) {
    for (int link = 0; link < tree.linkCount; link++) {
      links.carry(link, moved);
      for (int k = links.first(link); k < links.end(link); k++) {
        for (int i = 0; i < WIDTH; i++) {
          moved[WIDTH * link + i] += matrix.motion[WIDTH * k + i] * x[k];
        }
      }
      multiply(own, link, moved, WIDTH * link, wrench, 6 * link);
      if (coupled[link]) {
        multiply(byParent, link, moved, WIDTH * tree.parent[link], work, 0);
        add(work, 0, 1, wrench, 6 * link);
      }
    }
    far.addProduct(moved, x, matrix == placeColumns, factor, wrench, sum);
    for (int link = tree.linkCount - 1; link >= 0; link--) {
      int first = links.first(link);
      for (int j = first; j < links.end(link); j++) {
        double row = dot6(links.subspace, 6 * j, wrench, 6 * link);
        for (int k = first; k < links.end(link); k++) {
          row += matrix.force[3 * k + j - first] * x[k];
        }
        sum[j] += factor * row;
      }
      for (int k = first; k < links.end(link); k++) {
        add(matrix.wrench, 6 * k, x[k], wrench, 6 * link);
      }
      int parent = tree.parent[link];
      if (parent != TreeGeometry.ROOT) {
        links.toParent(link, wrench, 6 * link);
        add(wrench, 6 * link, 1, wrench, 6 * parent);
        if (coupled[link]) {
          multiply(onParent, link, moved, WIDTH * link, work, 0);
          add(work, 0, 1, wrench, 6 * parent);
        }
      }
    }
  }

  /** Takes derivatives of forces, whose sign is the opposite: F = M a + b − τ − Jᵀ w. */
  private final class LinkForces implements ForceJacobian {
    @Override
    public void wrenchByLink(int on, int by, double[] byPlace, double[] byVelocity) {
      if (on == by) {
        FarBlocks.subtract(own, BLOCK * on, 6, byPlace, byVelocity);
      } else if (far.count() > 0) {
        far.wrenchByLink(on, by, byPlace, byVelocity);
      } else if (tree.parent[on] == by) {
        coupled[on] = true;
        FarBlocks.subtract(byParent, BLOCK * on, 6, byPlace, byVelocity);
      } else if (tree.parent[by] == on) {
        coupled[by] = true;
        FarBlocks.subtract(onParent, BLOCK * by, 6, byPlace, byVelocity);
      } else {
        far.find(on, by);
      }
    }

    @Override
    public void wrenchByCoordinate(int on, int by, double[] byPlace, double[] byVelocity) {
      far.wrenchByCoordinate(on, by, byPlace, byVelocity);
    }

    @Override
    public void forceByLink(int on, int by, double[] byPlace, double[] byVelocity) {
      far.forceByLink(on, by, byPlace, byVelocity);
    }

    @Override
    public void forceByCoordinate(int on, int by, double byPlace, double byVelocity) {
      if (on >= tree.stateVelocityCount || by >= tree.stateVelocityCount) {
        return;
      }
      int link = tree.linkOfVelocity[by];
      int other = tree.linkOfVelocity[on];
      if (other != link) {
        far.forceByCoordinate(on, by, byPlace, byVelocity);
        return;
      }
      int row = on - tree.velocityAt[other];
      placeColumns.force[3 * by + row] -= byPlace;
      velocityColumns.force[3 * by + row] -= byVelocity;
      if (tree.kind[link] == LinkKind.BALL && !tree.inverse[link]) {
        // finish() turns the columns of velocities, which these forces do not need
        int ball = tree.velocityAt[link];
        int next = ball + (by - ball + 1) % 3;
        int last = ball + (by - ball + 2) % 3;
        placeColumns.force[3 * last + row] += byVelocity * motion.v[next];
        placeColumns.force[3 * next + row] -= byVelocity * motion.v[last];
      }
    }
  }
}
