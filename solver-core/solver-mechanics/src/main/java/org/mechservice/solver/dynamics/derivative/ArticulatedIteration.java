package org.mechservice.solver.dynamics.derivative;

import static org.mechservice.solver.spatial.Blocks.addCross;
import static org.mechservice.solver.spatial.Blocks.apply;
import static org.mechservice.solver.spatial.Blocks.applyTransposed;

import java.util.Arrays;
import java.util.Optional;
import org.mechservice.solver.dynamics.recursion.LinkInertias;
import org.mechservice.solver.dynamics.recursion.NewtonEuler;
import org.mechservice.solver.force.applied.ForceJacobian;
import org.mechservice.solver.kinematics.LinkKind;
import org.mechservice.solver.kinematics.StateCoordinates;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.linear.DenseLu;
import org.mechservice.solver.linear.LinearSolver;

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
 * they are subtracted from, the matrix is formed and factored with interchanges (NUMERICS §2).
 */
public final class ArticulatedIteration extends StepReduction implements StepDerivatives {
  /** As in factors along the tree: at most three digits are lost beyond the condition. */
  private static final double GROWTH_ALLOWED = 1e3;

  /**
   * Mean square of the velocities on the way to the root above which elimination from link to link
   * pays. It takes some 2000 operations a link, two for each pair of them along the tree.
   */
  private static final double MEAN_SQUARE_PAYS = 2000;

  private static final int WIDTH = 18;
  private static final int BLOCK = 6 * WIDTH;

  private final TreeMotion motion;
  private final TreeGeometry tree;
  private final LinkInertias inertias;
  private final NewtonEuler newtonEuler;
  private final VelocityDerivatives changes;
  private final MotionColumns columns;
  private final double[] residual;
  private final double[] noForces;
  private final double[] noWrench = {};

  /**
   * Where the links are at the derivatives, as in {@link TreeMotion}, which moves on: rotations,
   * positions and columns S.
   */
  private final double[] rotation;

  private final double[] position;
  private final double[] subspace;

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

  private final Factors ofMatrix;
  private final Factors ofInertia;
  private boolean inertiaFactored;
  private boolean inertiaRegular;

  /** Sweeps: 18 for each link, and 6. */
  private final double[] moved;

  private final double[] wrench;
  private final double[] unit;
  private final double[] work = new double[WIDTH];
  private final double[] triple = new double[3];
  private Optional<DenseLu> dense = Optional.empty();
  private boolean isDense;
  private long denseFactorizations;
  private int singular;
  private final ForceJacobian forces = new LocalForces();

  /**
   * Makes a workspace.
   *
   * @param motion swept by the caller, with accelerations, before each evaluation
   */
  public ArticulatedIteration(TreeMotion motion) {
    super(new StateCoordinates(motion.tree().mechanism()));
    this.motion = motion;
    tree = motion.tree();
    inertias = new LinkInertias(tree);
    newtonEuler = new NewtonEuler(motion, inertias);
    changes = new VelocityDerivatives(motion, inertias);
    columns = new MotionColumns(motion, newtonEuler);
    residual = new double[tree.velocityCount];
    noForces = new double[tree.velocityCount];
    int links = tree.linkCount;
    rotation = new double[9 * links];
    position = new double[3 * links];
    subspace = new double[6 * tree.velocityCount];
    own = new double[BLOCK * links];
    byParent = new double[BLOCK * links];
    onParent = new double[BLOCK * links];
    coupled = new boolean[links];
    int n = tree.velocityCount;
    placeColumn = new double[WIDTH * n];
    velocityColumn = new double[WIDTH * n];
    column = new double[WIDTH * n];
    placeForce = new double[6 * n];
    force = new double[6 * n];
    placeDirect = new double[3 * n];
    velocityDirect = new double[3 * n];
    direct = new double[3 * n];
    ofMatrix = new Factors();
    ofInertia = new Factors();
    moved = new double[WIDTH * links];
    wrench = new double[6 * links];
    unit = new double[tree.stateVelocityCount];
  }

  /** Returns whether elimination from link to link takes fewer operations than along the tree. */
  public static boolean pays(TreeGeometry tree) {
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
    return sum > MEAN_SQUARE_PAYS * tree.stateVelocityCount;
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
    System.arraycopy(motion.rotation, 0, rotation, 0, rotation.length);
    System.arraycopy(motion.position, 0, position, 0, position.length);
    System.arraycopy(motion.subspace, 0, subspace, 0, subspace.length);
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
      for (int k = first(link); k < end(link); k++) {
        formColumns(link, k);
      }
    }
    Arrays.fill(placeDirect, 0);
    Arrays.fill(velocityDirect, 0);
    inertiaFactored = false;
  }

  private int first(int link) {
    return tree.velocityAt[link];
  }

  private int end(int link) {
    return tree.driven[link]
        ? tree.velocityAt[link]
        : tree.velocityAt[link] + tree.kind[link].velocityCount();
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
        int k = first(link);
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
    double sum = 0;
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

  @Override
  public boolean factor(double step) {
    hGamma = step;
    combine(placeColumn, velocityColumn, WIDTH, column);
    combine(placeForce, noWrench, 6, force);
    combine(placeDirect, velocityDirect, 3, direct);
    for (int k = 0; k < tree.stateVelocityCount; k++) {
      for (int r = 0; r < 6; r++) {
        column[WIDTH * k + r] += subspace[6 * k + r];
      }
    }
    isDense = !ofMatrix.eliminate(column, force, direct);
    return !isDense || factorDense();
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
      double shrunk = shrunk(k);
      for (int at = height * k; at < height * (k + 1); at++) {
        turn(byPlace[at], byPlace[at + height], byPlace[at + 2 * height], v, k);
        for (int c = 0; c < 3; c++) {
          sum[at + c * height] +=
              square
                  * ((shrunk - 1) * byPlace[at + c * height] + 0.5 * hGamma * shrunk * triple[c]);
        }
      }
    }
  }

  /** Forms the matrix column by column and factors it with interchanges. */
  private boolean factorDense() {
    int n = unit.length;
    denseFactorizations++;
    if (dense.isEmpty()) {
      dense = Optional.of(new DenseLu(n));
    }
    double[] full = new double[n * n];
    double[] product = new double[n];
    for (int k = 0; k < n; k++) {
      unit[k] = 1;
      Arrays.fill(product, 0);
      addProduct(unit, column, force, direct, 1, product);
      unit[k] = 0;
      for (int i = 0; i < n; i++) {
        full[i * n + k] = product[i];
      }
    }
    int failed = dense.get().factor(full);
    singular = failed == LinearSolver.NONSINGULAR ? 0 : failed;
    return failed == LinearSolver.NONSINGULAR;
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
    return denseFactorizations;
  }

  @Override
  public void solveReduced(double[] b) {
    if (isDense) {
      dense.orElseThrow(() -> new IllegalStateException("no matrix has been factored")).solve(b);
    } else {
      ofMatrix.solve(b);
    }
  }

  @Override
  void addByPosition(double factor, double[] x, double[] sum) {
    addProduct(x, placeColumn, placeForce, placeDirect, factor, sum);
  }

  /** Adds factor · A x, for A as factored last. */
  void addMatrixProduct(double factor, double[] x, double[] sum) {
    addProduct(x, column, force, direct, factor, sum);
  }

  @Override
  boolean solveInertia(double[] b) {
    if (!inertiaFactored) {
      double[] still = new double[column.length];
      for (int k = 0; k < tree.stateVelocityCount; k++) {
        System.arraycopy(subspace, 6 * k, still, WIDTH * k, 6);
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
      carry(link, moved);
      for (int k = first(link); k < end(link); k++) {
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
    for (int link = tree.linkCount - 1; link >= 0; link--) {
      int first = first(link);
      for (int j = first; j < end(link); j++) {
        double row = dot6(subspace, 6 * j, wrench, 6 * link);
        for (int k = first; k < end(link); k++) {
          row += d[3 * k + j - first] * x[k];
        }
        sum[j] += factor * row;
      }
      for (int k = first; k < end(link); k++) {
        add(g, 6 * k, x[k], wrench, 6 * link);
      }
      int parent = tree.parent[link];
      if (parent != TreeGeometry.ROOT) {
        toParent(link, wrench, 6 * link);
        add(wrench, 6 * link, 1, wrench, 6 * parent);
        if (coupled[link]) {
          multiply(onParent, link, moved, WIDTH * link, work, 0);
          add(work, 0, 1, wrench, 6 * parent);
        }
      }
    }
  }

  /** Writes z of the parent, seen at the link in its axes; zero at the root. */
  private void carry(int link, double[] z) {
    int parent = tree.parent[link];
    int to = WIDTH * link;
    if (parent == TreeGeometry.ROOT) {
      Arrays.fill(z, to, to + WIDTH, 0);
      return;
    }
    for (int i = 0; i < WIDTH; i += 6) {
      int from = WIDTH * parent + i;
      applyTransposed(rotation, 9 * link, z, from, z, to + i);
      System.arraycopy(z, from + 3, triple, 0, 3);
      addCross(z, from, position, 3 * link, triple, 0);
      applyTransposed(rotation, 9 * link, triple, 0, z, to + i + 3);
    }
  }

  /** Refers a wrench to the parent of a link: f_p = R f, n_p = R n + p × f_p. */
  private void toParent(int link, double[] w, int at) {
    apply(rotation, 9 * link, w, at + 3, triple, 0);
    System.arraycopy(triple, 0, w, at + 3, 3);
    apply(rotation, 9 * link, w, at, triple, 0);
    System.arraycopy(triple, 0, w, at, 3);
    addCross(position, 3 * link, w, at + 3, w, at);
  }

  /** Writes the product of a link's 6 × 18 matrix. */
  private static void multiply(
      double[] matrix, int link, double[] z, int at, double[] out, int to) {
    int element = BLOCK * link;
    for (int r = 0; r < 6; r++) {
      double sum = 0;
      for (int c = 0; c < WIDTH; c++) {
        sum += matrix[element++] * z[at + c];
      }
      out[to + r] = sum;
    }
  }

  private static void add(double[] x, int at, double factor, double[] sum, int to) {
    for (int i = 0; i < 6; i++) {
      sum[to + i] += factor * x[at + i];
    }
  }

  private static double dot6(double[] a, int ia, double[] b, int ib) {
    double sum = 0;
    for (int i = 0; i < 6; i++) {
      sum += a[ia + i] * b[ib + i];
    }
    return sum;
  }

  /** The equations of the joints, solved one after the other from the leaves to the root. */
  private final class Factors {
    /** Z as eliminated. */
    private final double[] z = new double[WIDTH * tree.velocityCount];

    /** Sᵀ Pᴬ by the parent's motion, 18 for each velocity. */
    private final double[] row = new double[WIDTH * tree.velocityCount];

    /** Rows of (Sᵀ Pᴬ Z + D)⁻¹, three for each velocity. */
    private final double[] inverse = new double[3 * tree.velocityCount];

    /** What a change of the velocity exerts on the parent, 6 for each, in the parent's axes. */
    private final double[] push = new double[6 * tree.velocityCount];

    /** Pᴬ, 6 × 18 for each link. */
    private final double[] articulated = new double[BLOCK * tree.linkCount];

    private final double[] pivots = new double[9];
    private final double[] inverted = new double[9];
    private final double[] solution = new double[3];
    private final double[] lever = new double[18];
    private final double[] largest = new double[3];

    /** Eliminates; returns false if a pivot vanishes or digits are lost. */
    boolean eliminate(double[] columns, double[] g, double[] d) {
      System.arraycopy(columns, 0, z, 0, z.length);
      System.arraycopy(own, 0, articulated, 0, articulated.length);
      for (int link = tree.linkCount - 1; link >= 0; link--) {
        if (!eliminate(link, g, d)) {
          return false;
        }
      }
      return true;
    }

    private boolean eliminate(int link, double[] g, double[] d) {
      int first = first(link);
      int count = end(link) - first;
      int parent = tree.parent[link];
      for (int k = first; k < first + count; k++) {
        multiply(articulated, link, z, WIDTH * k, push, 6 * k);
        for (int j = 0; j < count; j++) {
          pivots[count * j + k - first] =
              dot6(subspace, 6 * (first + j), push, 6 * k) + d[3 * k + j];
        }
        add(g, 6 * k, 1, push, 6 * k);
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
      rowsToParent(articulated, link, articulated, link);
      if (coupled[link]) {
        for (int i = BLOCK * link; i < BLOCK * (link + 1); i++) {
          articulated[i] += byParent[i];
        }
      }
      for (int j = first; j < first + count; j++) {
        formRow(link, j);
      }
      columnsToParent(link);
      for (int k = first; k < first + count; k++) {
        toParent(link, push, 6 * k);
        if (coupled[link]) {
          multiply(onParent, link, z, WIDTH * k, work, 0);
          add(work, 0, 1, push, 6 * k);
        }
      }
      return subtract(link, first, count) && addToParent(link, parent);
    }

    /** Sᵀ Pᴬ. */
    private void formRow(int link, int j) {
      for (int c = 0; c < WIDTH; c++) {
        double sum = 0;
        for (int r = 0; r < 6; r++) {
          sum += subspace[6 * j + r] * articulated[BLOCK * link + WIDTH * r + c];
        }
        row[WIDTH * j + c] = sum;
      }
    }

    /** Rows that multiply z of the link become rows that multiply that of its parent. */
    private void rowsToParent(double[] from, int link, double[] to, int at) {
      if (from != to) {
        System.arraycopy(from, BLOCK * link, to, BLOCK * at, BLOCK);
      }
      for (int i = BLOCK * at; i < BLOCK * (at + 1); i += 6) {
        toParent(link, to, i);
      }
    }

    /** Wrenches on the link become wrenches on its parent. */
    private void columnsToParent(int link) {
      for (int c = 0; c < WIDTH; c++) {
        for (int r = 0; r < 6; r++) {
          work[r] = articulated[BLOCK * link + WIDTH * r + c];
        }
        toParent(link, work, 0);
        for (int r = 0; r < 6; r++) {
          articulated[BLOCK * link + WIDTH * r + c] = work[r];
        }
      }
      if (coupled[link]) {
        for (int r = 0; r < 6; r++) {
          System.arraycopy(onParent, BLOCK * link + WIDTH * r, work, 0, WIDTH);
          for (int c = 0; c < WIDTH; c += 6) {
            toParent(link, work, c);
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

    private boolean addToParent(int link, int parent) {
      for (int i = 0; i < BLOCK; i++) {
        articulated[BLOCK * parent + i] += articulated[BLOCK * link + i];
      }
      return true;
    }

    /**
     * Inverts up to three equations with interchanges of rows; returns whether they are regular.
     */
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
      for (int link = tree.linkCount - 1; link >= 0; link--) {
        int first = first(link);
        int count = end(link) - first;
        for (int j = 0; j < count; j++) {
          solution[j] = b[first + j] - dot6(subspace, 6 * (first + j), wrench, 6 * link);
        }
        for (int k = first; k < first + count; k++) {
          b[k] = ofSolution(k, count);
        }
        int parent = tree.parent[link];
        if (parent != TreeGeometry.ROOT) {
          toParent(link, wrench, 6 * link);
          add(wrench, 6 * link, 1, wrench, 6 * parent);
          for (int k = first; k < first + count; k++) {
            add(push, 6 * k, b[k], wrench, 6 * parent);
          }
        }
      }
      for (int link = 0; link < tree.linkCount; link++) {
        substitute(link, b);
      }
    }

    private void substitute(int link, double[] b) {
      int first = first(link);
      int count = end(link) - first;
      int parent = tree.parent[link];
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
      carry(link, moved);
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

  /** Takes derivatives of forces, whose sign is the opposite: F = M a + b − τ − Jᵀ w. */
  private final class LocalForces implements ForceJacobian {
    @Override
    public void wrenchByLink(int on, int by, double[] byPlace, double[] byVelocity) {
      if (on == by) {
        subtract(own, on, byPlace, byVelocity);
      } else if (tree.parent[on] == by) {
        coupled[on] = true;
        subtract(byParent, on, byPlace, byVelocity);
      } else if (tree.parent[by] == on) {
        coupled[by] = true;
        subtract(onParent, by, byPlace, byVelocity);
      } else {
        throw notLocal();
      }
    }

    private void subtract(double[] matrix, int link, double[] byPlace, double[] byVelocity) {
      for (int r = 0; r < 6; r++) {
        int at = BLOCK * link + WIDTH * r;
        for (int c = 0; c < 6; c++) {
          matrix[at + 6 + c] -= byVelocity[6 * r + c];
          matrix[at + 12 + c] -= byPlace[6 * r + c];
        }
      }
    }

    @Override
    public void wrenchByCoordinate(int on, int by, double[] byPlace, double[] byVelocity) {
      throw notLocal();
    }

    @Override
    public void forceByLink(int on, int by, double[] byPlace, double[] byVelocity) {
      throw notLocal();
    }

    @Override
    public void forceByCoordinate(int on, int by, double byPlace, double byVelocity) {
      if (on >= tree.stateVelocityCount || by >= tree.stateVelocityCount) {
        return;
      }
      int link = tree.linkOfVelocity[by];
      if (tree.linkOfVelocity[on] != link) {
        throw notLocal();
      }
      int row = on - tree.velocityAt[link];
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

    private IllegalStateException notLocal() {
      return new IllegalStateException("a force acts between links that are not neighbours");
    }
  }
}
