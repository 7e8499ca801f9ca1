package org.mechservice.solver.dynamics.derivative;

import static org.mechservice.solver.dynamics.derivative.PlacedLinks.WIDTH;
import static org.mechservice.solver.dynamics.derivative.PlacedLinks.turn;
import static org.mechservice.solver.spatial.Blocks.dot;

import java.util.Arrays;
import java.util.Optional;
import org.mechservice.solver.kinematics.LinkKind;
import org.mechservice.solver.kinematics.StateCoordinates;
import org.mechservice.solver.kinematics.TreeGeometry;

/**
 * The equations of an implicit step of a tree, eliminated from link to link: O(n), where the matrix
 * of a chain has n² elements. Workspace of one thread.
 *
 * <p>The matrix A = M + hγ C + hγ² K is never formed. In the motions of links of {@link
 * LinkJacobian}, whose symbols these are, its columns are
 *
 * <pre>
 * Z = [S + hγ (ψ' + S') + hγ² ψ''; hγ S + hγ² ψ'; hγ² S],     G = hγ² S ×* f
 * </pre>
 *
 * <p>and D likewise; those of balls are turned as in {@link StepReduction}. As in the
 * articulated-body algorithm (Featherstone 2008, ch. 7), w_i = Pᴬ z_p + p once the links beyond are
 * eliminated, with a 6 × 18 matrix Pᴬ in the place of the articulated inertia: x_i follows from n_i
 * equations and is put into the others ({@link LinkElimination}).
 *
 * <p>Where a pivot vanishes, or numbers are subtracted that are a thousand times larger than what
 * they are subtracted from, and where forces or loops couple links that are not neighbours, the
 * equations are factored as {@linkplain LinkSystem one sparse system} with interchanges.
 */
public final class ArticulatedIteration extends StepReduction {
  /**
   * Mean square of the velocities on the way to the root above which elimination from link to link
   * pays. It takes some 2000 operations a link, two for each pair of them along the tree.
   */
  private static final double MEAN_SQUARE_PAYS = 2000;

  /** The same for one sparse system, which takes some times as many. */
  private static final double FAR_COUPLINGS_PAY = 10000;

  private final LinkJacobian jacobian;
  private final TreeGeometry tree;

  /** Columns of A. */
  private final LinkColumns matrix;

  private final LinkElimination ofMatrix;
  private final LinkElimination ofInertia;
  private boolean inertiaFactored;
  private boolean inertiaRegular;

  private final LoopWrenches rows;
  private final double[] noGap = {};

  /**
   * The equations as one system: for far couplings and loops, or where elimination loses digits.
   */
  private Optional<LinkSystem> system = Optional.empty();

  private boolean isOneSystem;
  private long interchanges;
  private int singular;

  /** Mass of what is on a link and its moment of inertia about the link, two for each. */
  private final double[] carried;

  private final double[] triple = new double[3];

  /** Makes a workspace for derivatives that are evaluated elsewhere. */
  public ArticulatedIteration(LinkJacobian jacobian) {
    this(jacobian, LoopWrenches.NONE);
  }

  /**
   * Makes a workspace for equations with loops.
   *
   * @param jacobian evaluated elsewhere
   * @param rows of loops for {@link #factorWithRows}, written by the caller at each linearisation
   */
  public ArticulatedIteration(LinkJacobian jacobian, LoopWrenches rows) {
    super(new StateCoordinates(jacobian.tree.mechanism()));
    this.jacobian = jacobian;
    this.rows = rows;
    tree = jacobian.tree;
    matrix = new LinkColumns(tree.velocityCount);
    ofMatrix = new LinkElimination(jacobian);
    ofInertia = new LinkElimination(jacobian);
    carried = new double[2 * tree.linkCount];
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

  @Override
  public void setState(double[] y) {
    super.setState(y);
    inertiaFactored = false;
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
    isOneSystem = jacobian.far.count() > 0 || !ofMatrix.eliminate(matrix);
    if (!isOneSystem) {
      return true;
    }
    if (jacobian.far.count() == 0) {
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
      system = Optional.of(new LinkSystem(jacobian, rows));
    }
    singular = system.get().factor(matrix, step, penalties);
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
    double[] second = jacobian.inertias.second;
    double[] byVelocity = jacobian.velocityColumns.force;
    double[] byPlace = jacobian.placeColumns.force;
    double[] position = jacobian.links.position;
    double largest = Double.MIN_NORMAL;
    Arrays.fill(carried, 0);
    for (int link = tree.linkCount - 1; link >= 0; link--) {
      double straight = carried[2 * link] + tree.mass[link];
      double trace = second[9 * link] + second[9 * link + 4] + second[9 * link + 8];
      double turned = carried[2 * link + 1] + trace;
      for (int k = jacobian.links.first(link); k < jacobian.links.end(link); k++) {
        int own = 3 * k + k - jacobian.links.first(link);
        double joint =
            tree.armature[k]
                + step * Math.abs(byVelocity[own])
                + step * step * Math.abs(byPlace[own]);
        double moved = tree.kind[link] == LinkKind.SLIDE ? straight : turned;
        largest = Math.max(largest, (moved + joint) * units[k] * units[k]);
      }
      int parent = tree.parent[link];
      if (parent != TreeGeometry.ROOT) {
        double arm = Math.sqrt(dot(position, 3 * link, position, 3 * link));
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
    LinkColumns byPlace = jacobian.placeColumns;
    LinkColumns byVelocity = jacobian.velocityColumns;
    combine(byPlace.motion, byVelocity.motion, WIDTH, matrix.motion);
    combine(byPlace.wrench, byVelocity.wrench, 6, matrix.wrench);
    combine(byPlace.force, byVelocity.force, 3, matrix.force);
    jacobian.addArmature(matrix.force);
    for (int k = 0; k < tree.stateVelocityCount; k++) {
      for (int r = 0; r < 6; r++) {
        matrix.motion[WIDTH * k + r] += jacobian.links.subspace[6 * k + r];
      }
    }
    combine(jacobian.far.wrenchBy);
    combine(jacobian.far.forceBy);
  }

  /** Writes hγ by velocity + hγ² by place for columns of far couplings, turned for balls. */
  private void combine(FarBlocks.Columns columns) {
    double square = hGamma * hGamma;
    for (int i = 0; i < columns.combined.length; i++) {
      columns.combined[i] = square * columns.place[i] + hGamma * columns.velocity[i];
    }
    for (int pair = 0; pair < jacobian.far.count(); pair++) {
      int by = jacobian.far.by[pair];
      if (tree.kind[by] == LinkKind.BALL && !tree.driven[by]) {
        int k = jacobian.links.first(by);
        addTurnedColumns(columns.place, columns.combined, columns.height, columns.at(pair, 0), k);
      }
    }
  }

  /** Writes hγ by velocity + hγ² by place, turned for balls. */
  private void combine(double[] byPlace, double[] byVelocity, int height, double[] sum) {
    double square = hGamma * hGamma;
    for (int i = 0; i < sum.length; i++) {
      sum[i] = square * byPlace[i] + hGamma * byVelocity[i];
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
      turn(byPlace[at], byPlace[at + height], byPlace[at + 2 * height], v, k, triple);
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
    jacobian.addProduct(jacobian.placeColumns, x, factor, sum);
  }

  /** Adds factor · A x, for A as factored last. */
  public void addMatrixProduct(double factor, double[] x, double[] sum) {
    jacobian.addProduct(matrix, x, factor, sum);
  }

  @Override
  boolean solveInertia(double[] b) {
    if (!inertiaFactored) {
      LinkColumns still = new LinkColumns(tree.velocityCount);
      for (int k = 0; k < tree.stateVelocityCount; k++) {
        System.arraycopy(jacobian.links.subspace, 6 * k, still.motion, WIDTH * k, 6);
      }
      jacobian.addArmature(still.force);
      inertiaRegular = ofInertia.eliminate(still);
      inertiaFactored = true;
    }
    if (inertiaRegular) {
      ofInertia.solve(b);
    }
    return inertiaRegular;
  }
}
