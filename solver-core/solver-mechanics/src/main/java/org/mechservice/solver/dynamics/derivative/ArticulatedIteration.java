package org.mechservice.solver.dynamics.derivative;

import static org.mechservice.solver.dynamics.derivative.PlacedLinks.BLOCK;
import static org.mechservice.solver.dynamics.derivative.PlacedLinks.WIDTH;
import static org.mechservice.solver.dynamics.derivative.PlacedLinks.add;
import static org.mechservice.solver.dynamics.derivative.PlacedLinks.dot6;
import static org.mechservice.solver.dynamics.derivative.PlacedLinks.multiply;
import static org.mechservice.solver.spatial.Blocks.dot;

import java.util.Arrays;
import java.util.Optional;
import org.mechservice.solver.dynamics.recursion.LinkInertias;
import org.mechservice.solver.dynamics.recursion.NewtonEuler;
import org.mechservice.solver.force.applied.ForceJacobian;
import org.mechservice.solver.kinematics.LinkKind;
import org.mechservice.solver.kinematics.StateCoordinates;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;

/**
 * The equations of an implicit step of a tree, eliminated from link to link: O(n), where the matrix
 * of a chain has n² elements. Workspace of one thread.
 *
 * <p>The matrix A = M + hγ C + hγ² K is never formed. By the derivatives of {@link
 * ResidualJacobian}, A x is a sweep outwards and one inwards, like the equations of motion. With
 * z_i = [a; b; ξ] of link i, the 18 numbers that x changes in its acceleration, velocity and place,
 *
 * <pre>
 * z_i = X_i z_p + Z_i x_i,     Z = [S + hγ (ψ' + S') + hγ² ψ''; hγ S + hγ² ψ'; hγ² S]
 * w_i = P_i z_i + R_i z_p + G_i x_i + Σ_c (X_c* w_c + Q_c z_c)
 * (A x)_i = S_iᵀ (w_i − G_i x_i) + D_i x_i,     P = [I, 2B − ∂f/∂V, −∂f/∂X],  G = hγ² S ×* f
 * </pre>
 *
 * <p>where c are the links on link i, f is the force that the parent exerts, D holds joint springs
 * and dampers, and R and Q the forces between a link and its parent. Columns of balls are turned as
 * in {@link StepReduction}. As in the articulated-body algorithm (Featherstone 2008, ch. 7), w_i =
 * Pᴬ z_p + p once the links beyond are eliminated, with a 6 × 18 matrix Pᴬ in the place of the
 * articulated inertia: x_i follows from n_i equations and is put into the others.
 *
 * <p>Where a pivot vanishes, or numbers are subtracted that are a thousand times larger than what
 * they are subtracted from, and where forces or loops couple links that are not neighbours, the
 * equations are factored as {@linkplain LinkSystem one sparse system} with interchanges.
 */
public final class ArticulatedIteration extends StepReduction implements StepDerivatives {
  /**
   * Mean square of the velocities on the way to the root above which elimination from link to link
   * pays. It takes some 2000 operations a link, two for each pair of them along the tree.
   */
  private static final double MEAN_SQUARE_PAYS = 2000;

  /** The same for one sparse system, which takes some times as many. */
  private static final double FAR_COUPLINGS_PAY = 10000;

  private final TreeMotion motion;
  private final TreeGeometry tree;
  private final LinkInertias inertias;
  private final NewtonEuler newtonEuler;
  private final VelocityDerivatives changes;
  private final MotionColumns columns;
  private final double[] residual;
  private final double[] noForces;
  private final double[] noWrench = {};

  /** Where the links are at the derivatives. */
  private final PlacedLinks links;

  /** P, R and Q, 6 × 18 for each link: P by its motion, R by its parent's, Q that on the parent. */
  private final double[] own;

  private final double[] byParent;
  private final double[] onParent;

  /** Whether a link has R or Q. */
  private final boolean[] coupled;

  /** Z, 18 for each velocity: by positions, by velocities, and of the matrix factored last. */
  private final double[] placeColumn;

  private final double[] velocityColumn;
  private final double[] column;

  /** G, 6 for each velocity: by positions, and of the matrix. */
  private final double[] placeForce;

  private final double[] force;

  /** D, three for each velocity: by positions, by velocities, and of the matrix. */
  private final double[] placeDirect;

  private final double[] velocityDirect;
  private final double[] direct;

  private final LinkElimination ofMatrix;
  private final LinkElimination ofInertia;
  private boolean inertiaFactored;
  private boolean inertiaRegular;

  /** Sweeps: 18 for each link, and 6. */
  private final double[] moved;

  private final double[] wrench;
  private final double[] work = new double[WIDTH];
  private final double[] triple = new double[3];
  private int singular;
  private final ForceJacobian forces = new LinkForces();

  /** What couples links that are not neighbours, and loops. */
  private final FarBlocks far;

  private final LoopWrenches rows;
  private final double[] noGap = {};

  /** Mass of what is on a link and its moment of inertia about the link, two for each. */
  private final double[] carried;

  /**
   * The equations as one system: for far couplings and loops, or where elimination loses digits.
   */
  private Optional<LinkSystem> system = Optional.empty();

  private boolean isOneSystem;
  private long interchanges;

  /**
   * Makes a workspace.
   *
   * @param motion swept by the caller, with accelerations, before each evaluation
   */
  public ArticulatedIteration(TreeMotion motion) {
    this(motion, new int[0], LoopWrenches.NONE);
  }

  /**
   * Makes a workspace for forces and loops between any links.
   *
   * @param motion swept by the caller, with accelerations, before each evaluation
   * @param pairs links that forces and loops couple, two for each pair; empty if all are neighbours
   * @param rows of loops for {@link #factorWithRows}, written by the caller at each linearisation
   */
  public ArticulatedIteration(TreeMotion motion, int[] pairs, LoopWrenches rows) {
    super(new StateCoordinates(motion.tree().mechanism()));
    this.motion = motion;
    tree = motion.tree();
    inertias = new LinkInertias(tree);
    newtonEuler = new NewtonEuler(motion, inertias);
    changes = new VelocityDerivatives(motion, inertias);
    columns = new MotionColumns(motion, newtonEuler);
    residual = new double[tree.velocityCount];
    noForces = new double[tree.velocityCount];
    int count = tree.linkCount;
    links = new PlacedLinks(tree);
    own = new double[BLOCK * count];
    byParent = new double[BLOCK * count];
    onParent = new double[BLOCK * count];
    coupled = new boolean[count];
    int n = tree.velocityCount;
    placeColumn = new double[WIDTH * n];
    velocityColumn = new double[WIDTH * n];
    column = new double[WIDTH * n];
    placeForce = new double[6 * n];
    force = new double[6 * n];
    placeDirect = new double[3 * n];
    velocityDirect = new double[3 * n];
    direct = new double[3 * n];
    ofMatrix = new LinkElimination(links, own, byParent, onParent, coupled);
    ofInertia = new LinkElimination(links, own, byParent, onParent, coupled);
    moved = new double[WIDTH * count];
    wrench = new double[6 * count];
    far = new FarBlocks(tree, pairs);
    this.rows = rows;
    carried = new double[2 * count];
  }

  /** Returns whether elimination from link to link takes fewer operations than along the tree. */
  public static boolean pays(TreeGeometry tree) {
    return meanSquare(tree) > MEAN_SQUARE_PAYS;
  }

  /** Returns whether one sparse system of the links takes fewer operations than a matrix. */
  public static boolean paysFarCouplings(TreeGeometry tree) {
    return meanSquare(tree) > FAR_COUPLINGS_PAY;
  }

  /** Returns the mean square of the number of velocities on the way to the root. */
  private static double meanSquare(TreeGeometry tree) {
    int[] onWay = new int[tree.linkCount];
    double sum = 0;
    for (int link = 0; link < tree.linkCount; link++) {
      int above = tree.parent[link] == TreeGeometry.ROOT ? 0 : onWay[tree.parent[link]];
      int count = tree.driven[link] ? 0 : tree.kind[link].velocityCount();
      for (int k = 0; k < count; k++) {
        sum += (double) (above + k) * (above + k);
      }
      onWay[link] = above + count;
    }
    return sum / Math.max(1, tree.stateVelocityCount);
  }

  /**
   * {@inheritDoc} It takes those that act between a link and its parent, between a link and the
   * root, or between coordinates of one link.
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
    Arrays.fill(placeDirect, 0);
    Arrays.fill(velocityDirect, 0);
    far.clear();
    inertiaFactored = false;
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
    System.arraycopy(columns.second, 6 * k, placeColumn, at, 6);
    System.arraycopy(columns.first, 6 * k, placeColumn, at + 6, 6);
    System.arraycopy(motion.subspace, 6 * k, placeColumn, at + 12, 6);
    System.arraycopy(columns.both, 6 * k, velocityColumn, at, 6);
    System.arraycopy(motion.subspace, 6 * k, velocityColumn, at + 6, 6);
    Arrays.fill(placeForce, 6 * k, 6 * k + 6, 0);
    ResidualJacobian.addForceTurned(
        motion.subspace, 6 * k, newtonEuler.force, 6 * link, placeForce, 6 * k);
  }

  /** {@inheritDoc} They get ∂F/∂v [ω]× + M [ω']×, and −[Sᵀ f]× in their own rows. */
  @Override
  public void finish() {
    for (int link = 0; link < tree.linkCount; link++) {
      if (tree.kind[link] == LinkKind.BALL && !tree.driven[link] && !tree.inverse[link]) {
        int k = links.first(link);
        addTurned(velocityColumn, WIDTH, k, 12, motion.v, placeColumn);
        addTurnedSubspace(k);
        addTurned(velocityDirect, 3, k, 3, motion.v, placeDirect);
        for (int c = 0; c < 3; c++) {
          int next = (c + 1) % 3;
          int last = (c + 2) % 3;
          placeDirect[3 * (k + last) + next] += residual[k + c];
          placeDirect[3 * (k + next) + last] -= residual[k + c];
        }
      }
    }
  }

  /**
   * Adds x [ω]× to three columns.
   *
   * @param numbers of each column that are added
   */
  private void addTurned(
      double[] from, int height, int k, int numbers, double[] omega, double[] to) {
    for (int r = 0; r < numbers; r++) {
      int at = height * k + r;
      turn(from[at], from[at + height], from[at + 2 * height], omega, k);
      for (int c = 0; c < 3; c++) {
        to[at + c * height] += triple[c];
      }
    }
  }

  /** Adds S [ω']× to the accelerations by place. */
  private void addTurnedSubspace(int k) {
    double[] s = motion.subspace;
    for (int r = 0; r < 6; r++) {
      turn(s[6 * k + r], s[6 * k + 6 + r], s[6 * k + 12 + r], motion.a, k);
      for (int c = 0; c < 3; c++) {
        placeColumn[WIDTH * (k + c) + r] += triple[c];
      }
    }
  }

  /** Writes the row x [ω]×. */
  private void turn(double x, double y, double z, double[] omega, int at) {
    triple[0] = y * omega[at + 2] - z * omega[at + 1];
    triple[1] = z * omega[at] - x * omega[at + 2];
    triple[2] = x * omega[at + 1] - y * omega[at];
  }

  @Override
  public boolean isFinite() {
    double sum = far.sum();
    for (double element : own) {
      sum += element;
    }
    for (double element : placeDirect) {
      sum += element;
    }
    for (double element : velocityDirect) {
      sum += element;
    }
    for (int k = 0; k < WIDTH * tree.stateVelocityCount; k++) {
      sum += placeColumn[k] + velocityColumn[k];
    }
    return Double.isFinite(sum);
  }

  /**
   * {@inheritDoc}
   *
   * @throws IllegalStateException if there are rows of loops, see {@link #factorWithRows}
   */
  @Override
  public boolean factor(double step) {
    if (rows.count() > 0) {
      throw new IllegalStateException("A is factored with the rows of the loops");
    }
    form(step);
    isOneSystem = far.count() > 0 || !ofMatrix.eliminate(column, force, direct);
    if (!isOneSystem) {
      return true;
    }
    if (far.count() == 0) {
      interchanges++;
    }
    return factorSystem(step, noGap);
  }

  /**
   * Factors A with the rows J of loops, for {@link #solveWithRows}.
   *
   * @param step hγ, s
   * @param penalties α of each row; not modified
   * @return whether it is regular
   */
  public boolean factorWithRows(double step, double[] penalties) {
    form(step);
    isOneSystem = true;
    return factorSystem(step, penalties);
  }

  private boolean factorSystem(double step, double[] penalties) {
    if (system.isEmpty()) {
      system =
          Optional.of(
              new LinkSystem(
                  links, own, byParent, onParent, coupled, far, rows, inertias.meanRadius()));
    }
    singular = system.get().factor(column, force, direct, step, penalties);
    return singular < 0;
  }

  /**
   * Returns the largest inertia on the diagonal of A: of all links on a joint, with joint springs
   * and dampers as they count in a step; at most twice as large if the links on it are folded.
   *
   * @param step hγ, s
   * @param units of the velocities, which scale the rows and columns of A; not modified
   */
  public double largestInertia(double step, double[] units) {
    double largest = Double.MIN_NORMAL;
    Arrays.fill(carried, 0);
    for (int link = tree.linkCount - 1; link >= 0; link--) {
      double[] second = inertias.second;
      double straight = carried[2 * link] + tree.mass[link];
      double trace = second[9 * link] + second[9 * link + 4] + second[9 * link + 8];
      double turned = carried[2 * link + 1] + trace;
      for (int k = links.first(link); k < links.end(link); k++) {
        int own = 3 * k + k - links.first(link);
        double joint =
            step * Math.abs(velocityDirect[own]) + step * step * Math.abs(placeDirect[own]);
        double moved = tree.kind[link] == LinkKind.SLIDE ? straight : turned;
        largest = Math.max(largest, (moved + joint) * units[k] * units[k]);
      }
      int parent = tree.parent[link];
      if (parent != TreeGeometry.ROOT) {
        double arm = Math.sqrt(dot(links.position, 3 * link, links.position, 3 * link));
        double radius = Math.sqrt(turned) + arm * Math.sqrt(straight);
        carried[2 * parent] += straight;
        carried[2 * parent + 1] += radius * radius;
      }
    }
    return largest;
  }

  /** Forms the columns of the matrix. */
  private void form(double step) {
    hGamma = step;
    combine(placeColumn, velocityColumn, WIDTH, column);
    combine(placeForce, noWrench, 6, force);
    combine(placeDirect, velocityDirect, 3, direct);
    for (int k = 0; k < tree.stateVelocityCount; k++) {
      for (int r = 0; r < 6; r++) {
        column[WIDTH * k + r] += links.subspace[6 * k + r];
      }
    }
    combine(far.wrenchBy);
    combine(far.forceBy);
  }

  /** Writes hγ by velocity + hγ² by place for columns of far couplings, turned for balls. */
  private void combine(FarBlocks.Columns columns) {
    double square = hGamma * hGamma;
    for (int i = 0; i < columns.combined.length; i++) {
      columns.combined[i] = square * columns.place[i] + hGamma * columns.velocity[i];
    }
    for (int pair = 0; pair < far.count(); pair++) {
      int by = far.by[pair];
      if (tree.kind[by] == LinkKind.BALL && !tree.driven[by]) {
        int k = links.first(by);
        addTurnedColumns(columns.place, columns.combined, columns.height, columns.at(pair, 0), k);
      }
    }
  }

  /**
   * Writes hγ by velocity + hγ² by place, turned for balls.
   *
   * @param byVelocity with fewer numbers than there are columns for none
   */
  private void combine(double[] byPlace, double[] byVelocity, int height, double[] sum) {
    double square = hGamma * hGamma;
    boolean moves = byVelocity.length == sum.length;
    for (int i = 0; i < sum.length; i++) {
      sum[i] = square * byPlace[i] + (moves ? hGamma * byVelocity[i] : 0);
    }
    for (int ball = 0; ball < coordinates.ballCount(); ball++) {
      int k = coordinates.ballVelocity(ball);
      addTurnedColumns(byPlace, sum, height, height * k, k);
    }
  }

  /** Adds what the rotation in a step adds to three columns of a ball from {@code from}. */
  private void addTurnedColumns(double[] byPlace, double[] sum, int height, int from, int k) {
    double square = hGamma * hGamma;
    double shrunk = shrunk(k);
    for (int at = from; at < from + height; at++) {
      turn(byPlace[at], byPlace[at + height], byPlace[at + 2 * height], v, k);
      for (int c = 0; c < 3; c++) {
        sum[at + c * height] +=
            square * ((shrunk - 1) * byPlace[at + c * height] + 0.5 * hGamma * shrunk * triple[c]);
      }
    }
  }

  @Override
  public int singularUnknown() {
    return q.length + singular;
  }

  /** Returns the velocity whose column had no pivot in the last, failed factorisation. */
  public int singularVelocity() {
    return singular;
  }

  @Override
  long denseFactorizations() {
    return interchanges;
  }

  @Override
  public void solveReduced(double[] b) {
    if (isOneSystem) {
      solveWithRows(b, noGap);
    } else {
      ofMatrix.solve(b);
    }
  }

  /**
   * Solves A x + Jᵀ λ = b, J x − λ / α = −g in place with the last factors of {@link
   * #factorWithRows}.
   *
   * @param b right-hand side of the velocities; overwritten with x
   * @param gap g, one for each row; overwritten with λ
   */
  public void solveWithRows(double[] b, double[] gap) {
    system
        .orElseThrow(() -> new IllegalStateException("no equations have been factored"))
        .solve(b, gap);
  }

  @Override
  void addByPosition(double factor, double[] x, double[] sum) {
    addProduct(x, placeColumn, placeForce, placeDirect, factor, sum);
  }

  /** Adds factor · A x, for A as factored last. */
  public void addMatrixProduct(double factor, double[] x, double[] sum) {
    addProduct(x, column, force, direct, factor, sum);
  }

  @Override
  boolean solveInertia(double[] b) {
    if (!inertiaFactored) {
      double[] still = new double[column.length];
      for (int k = 0; k < tree.stateVelocityCount; k++) {
        System.arraycopy(links.subspace, 6 * k, still, WIDTH * k, 6);
      }
      inertiaRegular =
          ofInertia.eliminate(still, new double[force.length], new double[direct.length]);
      inertiaFactored = true;
    }
    if (inertiaRegular) {
      ofInertia.solve(b);
    }
    return inertiaRegular;
  }

  /** Adds factor times the matrix of the columns Z, G and D times x. */
  private void addProduct(
      double[] x, double[] z, double[] g, double[] d, double factor, double[] sum) {
    for (int link = 0; link < tree.linkCount; link++) {
      links.carry(link, moved);
      for (int k = links.first(link); k < links.end(link); k++) {
        for (int i = 0; i < WIDTH; i++) {
          moved[WIDTH * link + i] += z[WIDTH * k + i] * x[k];
        }
      }
      multiply(own, link, moved, WIDTH * link, wrench, 6 * link);
      if (coupled[link]) {
        multiply(byParent, link, moved, WIDTH * tree.parent[link], work, 0);
        add(work, 0, 1, wrench, 6 * link);
      }
    }
    far.addProduct(moved, x, z == placeColumn, factor, wrench, sum);
    for (int link = tree.linkCount - 1; link >= 0; link--) {
      int first = links.first(link);
      for (int j = first; j < links.end(link); j++) {
        double row = dot6(links.subspace, 6 * j, wrench, 6 * link);
        for (int k = first; k < links.end(link); k++) {
          row += d[3 * k + j - first] * x[k];
        }
        sum[j] += factor * row;
      }
      for (int k = first; k < links.end(link); k++) {
        add(g, 6 * k, x[k], wrench, 6 * link);
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
        subtract(own, BLOCK * on, 6, byPlace, byVelocity);
      } else if (far.count() > 0) {
        subtract(far.wrench, BLOCK * far.find(on, by), 6, byPlace, byVelocity);
      } else if (tree.parent[on] == by) {
        coupled[on] = true;
        subtract(byParent, BLOCK * on, 6, byPlace, byVelocity);
      } else if (tree.parent[by] == on) {
        coupled[by] = true;
        subtract(onParent, BLOCK * by, 6, byPlace, byVelocity);
      } else {
        far.find(on, by);
      }
    }

    private void subtract(
        double[] matrix, int from, int lines, double[] byPlace, double[] byVelocity) {
      for (int r = 0; r < lines; r++) {
        int at = from + WIDTH * r;
        for (int c = 0; c < 6; c++) {
          matrix[at + 6 + c] -= byVelocity[6 * r + c];
          matrix[at + 12 + c] -= byPlace[6 * r + c];
        }
      }
    }

    @Override
    public void wrenchByCoordinate(int on, int by, double[] byPlace, double[] byVelocity) {
      if (by >= tree.stateVelocityCount) {
        return;
      }
      int link = tree.linkOfVelocity[by];
      int at = far.wrenchBy.at(far.find(on, link), by - tree.velocityAt[link]);
      for (int r = 0; r < 6; r++) {
        far.wrenchBy.place[at + r] -= byPlace[r];
        far.wrenchBy.velocity[at + r] -= byVelocity[r];
      }
    }

    @Override
    public void forceByLink(int on, int by, double[] byPlace, double[] byVelocity) {
      if (on >= tree.stateVelocityCount) {
        return;
      }
      int link = tree.linkOfVelocity[on];
      int line = FarBlocks.MOST * far.find(link, by) + on - tree.velocityAt[link];
      subtract(far.force, WIDTH * line, 1, byPlace, byVelocity);
    }

    @Override
    public void forceByCoordinate(int on, int by, double byPlace, double byVelocity) {
      if (on >= tree.stateVelocityCount || by >= tree.stateVelocityCount) {
        return;
      }
      int link = tree.linkOfVelocity[by];
      int other = tree.linkOfVelocity[on];
      int row = on - tree.velocityAt[other];
      if (other != link) {
        int at = far.forceBy.at(far.find(other, link), by - tree.velocityAt[link]) + row;
        far.forceBy.place[at] -= byPlace;
        far.forceBy.velocity[at] -= byVelocity;
        return;
      }
      placeDirect[3 * by + row] -= byPlace;
      velocityDirect[3 * by + row] -= byVelocity;
      if (tree.kind[link] == LinkKind.BALL && !tree.inverse[link]) {
        // finish() turns the columns of velocities, which these forces do not need
        int ball = tree.velocityAt[link];
        int next = ball + (by - ball + 1) % 3;
        int last = ball + (by - ball + 2) % 3;
        placeDirect[3 * last + row] += byVelocity * motion.v[next];
        placeDirect[3 * next + row] -= byVelocity * motion.v[last];
      }
    }
  }
}
