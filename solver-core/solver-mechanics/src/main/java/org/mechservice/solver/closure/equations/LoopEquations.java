package org.mechservice.solver.closure.equations;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import org.mechservice.solver.force.applied.Couplings;
import org.mechservice.solver.force.applied.ForceJacobian;
import org.mechservice.solver.kinematics.CountedPositions;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.kinematics.pair.RelativeMotion;
import org.mechservice.solver.linear.SparseMatrix;
import org.mechservice.solver.mechanism.Parameter;
import org.mechservice.solver.mechanism.closure.CoordinateClosure;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.KnifeEdgeClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.closure.PointOnLineClosure;
import org.mechservice.solver.mechanism.closure.PointOnPlaneClosure;
import org.mechservice.solver.mechanism.closure.RollingClosure;

/**
 * The equations of all closures of a mechanism: Φ(q, t) = 0, Φ' = J v + Φ_t = 0, Φ'' = J v' + γ =
 * 0. Workspace of one thread; nothing allocates after construction.
 *
 * <p>Non-holonomic equations ({@link #isHolonomic}) have only Φ' = J v = 0; their Φ is zero.
 *
 * <p>Displacements are in m and tilts in rad, with gradients of size one. Residuals of different
 * equations are compared relative to the {@link #size} of what each measures.
 */
public final class LoopEquations {
  /** Most equations with which a step is eliminated from link to link. */
  public static final int FEW = 20;

  /**
   * Number of velocities from which matrices are sparse. Measured on rows of four-bars and on
   * rings, a run with dense matrices against one with sparse ones: 22 ms against 8 at 40
   * velocities, 49 against 17 at 81 and 102 against 10 at 100 in a process that is warm; 0.60 s
   * against 0.44 at 40 in a new one, where both take as long at 10 to 20 velocities.
   */
  public static final int LARGE = 40;

  /**
   * Number of equations squared times velocities from which set-up uses sparse matrices. One set of
   * singular values costs about ten times as many operations, and closing the start takes about a
   * hundred sets if many equations are redundant: a net of 10 x 10 bodies took 100 s.
   */
  private static final double LARGE_TO_SET_UP = 5e4;

  private final TreeGeometry tree;
  private final List<ClosureRows> closures = new ArrayList<>();
  private final ClosureRows[] closureOfRow;
  private final int[] rowInClosure;
  private final boolean[] holonomic;
  private final int holonomicCount;
  private final double[] parameters;
  private final double length;

  /** Unwrapped angles of cut joints in couplings. */
  public final CountedPositions counted = new CountedPositions();

  /** Φ, m or rad. */
  public final double[] value;

  /** Φ' = J v + Φ_t. */
  public final double[] rate;

  /** Φ'' for the last swept accelerations; γ if these are zero. */
  public final double[] acceleration;

  /**
   * J by the extended velocities: the state's first, then those of driven joints. An equation
   * depends only on the joints between its bodies and their common ancestor.
   */
  public final SparseMatrix jacobian;

  /** Whether J follows from the poses of the links alone. */
  private final boolean byPoses;

  /** The motion and its placement at which J was evaluated last. */
  private Object differentiatedIn = this;

  private long differentiatedAt;
  private boolean far;

  /** Dense row; zero between calls. */
  private final double[] wholeRow;

  /** Prepares the equations of a tree's mechanism, with parameters at their values in the file. */
  public LoopEquations(TreeGeometry tree) {
    this(tree, false);
  }

  /**
   * @param start whether to add equations for start values of cut joints
   */
  public LoopEquations(TreeGeometry tree, boolean start) {
    this.tree = tree;
    parameters = tree.mechanism().parameters().stream().mapToDouble(Parameter::value).toArray();
    length = LengthScale.of(tree);
    for (LoopClosure closure : tree.mechanism().closures()) {
      closures.add(rows(closure));
    }
    if (start) {
      addStarts();
    }
    int count = closures.stream().mapToInt(ClosureRows::count).sum();
    closureOfRow = new ClosureRows[count];
    rowInClosure = new int[count];
    int row = 0;
    for (ClosureRows rows : closures) {
      for (int i = 0; i < rows.count(); i++) {
        closureOfRow[row] = rows;
        rowInClosure[row++] = i;
      }
    }
    holonomic = new boolean[count];
    int positions = 0;
    for (int i = 0; i < count; i++) {
      holonomic[i] = closureOfRow[i].isHolonomic(rowInClosure[i]);
      positions += holonomic[i] ? 1 : 0;
    }
    holonomicCount = positions;
    value = new double[count];
    rate = new double[count];
    acceleration = new double[count];
    jacobian = SparseMatrix.of(pattern(), tree.velocityCount);
    wholeRow = new double[tree.velocityCount];
    byPoses = closures.stream().allMatch(PairRows.class::isInstance);
  }

  private int[][] pattern() {
    int[][] pattern = new int[closureOfRow.length][];
    for (int row = 0; row < pattern.length; row++) {
      RowSupport support = support(row);
      BitSet columns = new BitSet();
      for (int velocity : support.velocities()) {
        columns.set(velocity);
      }
      for (int link : support.ways()) {
        if (tree.kind[link].velocityCount() > 0) {
          int at = tree.velocityAt[link];
          columns.set(at, at + tree.kind[link].velocityCount());
        }
      }
      pattern[row] = columns.stream().toArray();
    }
    return pattern;
  }

  /** Returns the links and velocities that an equation depends on. */
  public RowSupport support(int row) {
    BitSet ways = new BitSet();
    BitSet loaded = new BitSet();
    BitSet velocities = new BitSet();
    closureOfRow[row].addSupport(ways, loaded, velocities);
    return new RowSupport(ways, loaded, velocities);
  }

  private ClosureRows rows(LoopClosure closure) {
    if (closure instanceof JointClosure joint) {
      return PairRows.of(joint, tree, parameters, length);
    } else if (closure instanceof DistanceClosure distance) {
      return PairRows.of(distance, tree, length);
    } else if (closure instanceof PointOnPlaneClosure plane) {
      return PairRows.of(plane, tree, length);
    } else if (closure instanceof PointOnLineClosure line) {
      return PairRows.of(line, tree, length);
    } else if (closure instanceof RollingClosure rolling) {
      return PairRows.of(rolling, tree, length);
    } else if (closure instanceof KnifeEdgeClosure edge) {
      return PairRows.of(edge, tree, length);
    }
    return new CouplingRows((CoordinateClosure) closure, tree, parameters, length, counted);
  }

  private void addStarts() {
    for (LoopClosure closure : tree.mechanism().closures()) {
      if (closure instanceof JointClosure joint && joint.keepsStart()) {
        closures.add(PairRows.ofStart(joint, tree, length));
      }
    }
  }

  /** Returns the number of equations. */
  public int count() {
    return closureOfRow.length;
  }

  /**
   * Returns whether an equation restricts positions. If not, it restricts velocities alone, such as
   * those of a rolling wheel.
   */
  public boolean isHolonomic(int row) {
    return holonomic[row];
  }

  /** Returns the number of equations that restrict positions. */
  public int holonomicCount() {
    return holonomicCount;
  }

  /** Returns whether all equations restrict positions. */
  public boolean isHolonomic() {
    return holonomicCount == holonomic.length;
  }

  /** Returns whether the mechanism is large enough for sparse matrices. */
  public boolean isLarge() {
    return tree.stateVelocityCount > LARGE;
  }

  /** Returns whether set-up finds rank and start with sparse matrices. */
  public boolean isLargeToSetUp() {
    double equations = count();
    return isLarge() || equations * equations * tree.stateVelocityCount > LARGE_TO_SET_UP;
  }

  /** Returns the closure an equation belongs to. */
  public LoopClosure closure(int row) {
    return closureOfRow[row].closure();
  }

  /**
   * Returns the direction that an equation constrains, for messages, such as {@code displacement
   * along (0, 0, 1)}.
   */
  public String label(int row) {
    return closureOfRow[row].label(rowInClosure[row]);
  }

  /** Returns the size of what an equation measures: a length of the mechanism in m, or 1 rad. */
  public double size(int row) {
    return closureOfRow[row].size(rowInClosure[row]);
  }

  /** Returns closure and label of an equation, for messages. */
  public String name(int row) {
    return "constraint \"" + closure(row).name() + "\" (" + label(row) + ")";
  }

  /** Returns whether an equation measures a displacement, so that places enter it as they are. */
  public boolean isLength(int row) {
    return !closureOfRow[row].unit(rowInClosure[row]).equals("rad");
  }

  /** Returns the SI unit of an equation's residual. */
  public String unit(int row) {
    return closureOfRow[row].unit(rowInClosure[row]);
  }

  /** Returns the length scale of the mechanism, m. */
  public double length() {
    return length;
  }

  /** Returns the values of the parameters, which may be changed. */
  public double[] parameters() {
    return parameters;
  }

  /** Evaluates Φ for the poses of the last sweep. */
  public void place(TreeMotion motion, double t) {
    far = false;
    for (int i = 0; i < closures.size(); i++) {
      closures.get(i).place(motion, t);
    }
    takeValues();
  }

  /**
   * As {@link #place}, with values of Φ and J that are finite in every position and lead to one
   * that closes the loops; both equal those of {@link #place} to first order where the loops are
   * closed. Velocities and accelerations must not be evaluated after it.
   */
  public void placeFar(TreeMotion motion, double t) {
    far = true;
    for (int i = 0; i < closures.size(); i++) {
      closures.get(i).placeFar(motion, t);
    }
    takeValues();
  }

  private void takeValues() {
    for (int row = 0; row < closureOfRow.length; row++) {
      value[row] = closureOfRow[row].value(rowInClosure[row]);
    }
  }

  /** Evaluates J after {@link #place}. */
  public void differentiate(TreeMotion motion) {
    if (!far && differentiatedIn == motion && differentiatedAt == motion.placement()) {
      return;
    }
    differentiatedIn = byPoses && !far ? motion : this;
    differentiatedAt = motion.placement();
    for (int row = 0; row < closureOfRow.length; row++) {
      closureOfRow[row].addJacobian(motion, rowInClosure[row], wholeRow, 0);
      takeWholeRow(row, jacobian);
    }
  }

  private void takeWholeRow(int row, SparseMatrix matrix) {
    for (int e = matrix.start[row]; e < matrix.start[row + 1]; e++) {
      matrix.value[e] = wholeRow[matrix.column[e]];
      wholeRow[matrix.column[e]] = 0;
    }
  }

  /** Evaluates Φ' for the velocities of the last sweep, after {@link #place}. */
  public void move(TreeMotion motion, double t) {
    for (int i = 0; i < closures.size(); i++) {
      closures.get(i).move(motion, t);
    }
    for (int row = 0; row < closureOfRow.length; row++) {
      rate[row] = closureOfRow[row].rate(rowInClosure[row]);
    }
  }

  /**
   * Returns a matrix for the columns of J that belong to the state.
   *
   * @param columns number of velocities of the state
   * @param holds whether a row with one element follows for each column
   */
  public SparseMatrix stateRows(int columns, boolean holds) {
    int[][] pattern = new int[count() + (holds ? columns : 0)][];
    for (int row = 0; row < pattern.length; row++) {
      pattern[row] =
          row < count()
              ? Arrays.stream(jacobian.column, jacobian.start[row], jacobian.start[row + 1])
                  .filter(column -> column < columns)
                  .toArray()
              : new int[] {row - count()};
    }
    return SparseMatrix.of(pattern, columns);
  }

  /**
   * Writes the columns of J that belong to the state, with rows divided by their sizes.
   *
   * @param rows of {@link #stateRows}; those of the equations are overwritten
   */
  public void scaledRows(SparseMatrix rows) {
    for (int row = 0; row < closureOfRow.length; row++) {
      double perSize = 1 / size(row);
      int from = jacobian.start[row] - rows.start[row];
      for (int e = rows.start[row]; e < rows.start[row + 1]; e++) {
        rows.value[e] = perSize * jacobian.value[from + e];
      }
    }
  }

  /**
   * Copies Φ, Φ' and J from the terms of generated code.
   *
   * @param terms laid out as in {@link LoopTerms}; not modified
   * @param velocities number of velocities of the state
   */
  public void take(double[] terms, int velocities) {
    differentiatedIn = this;
    int m = count();
    System.arraycopy(terms, 0, value, 0, m);
    System.arraycopy(terms, m, rate, 0, m);
    for (int row = 0; row < m; row++) {
      int at = LoopTerms.jacobianAt(m) + row * velocities;
      jacobian.setRow(row, terms, at);
      closureOfRow[row].measure(terms[LoopTerms.sizeAt(m, velocities) + row]);
    }
  }

  /**
   * Copies Φ, Φ' and J from the terms of generated code for large mechanisms.
   *
   * @param terms laid out as in {@link LoopTerms.Recursive}; not modified
   */
  public void takeRecursive(double[] terms) {
    differentiatedIn = this;
    int m = count();
    System.arraycopy(terms, 0, value, 0, m);
    System.arraycopy(terms, m, rate, 0, m);
    System.arraycopy(
        terms, LoopTerms.Recursive.elementAt(m), jacobian.value, 0, jacobian.value.length);
  }

  /** Evaluates γ for the accelerations of the last sweep, after {@link #move}. */
  public void accelerate(TreeMotion motion, double t) {
    for (int i = 0; i < closures.size(); i++) {
      closures.get(i).accelerate(motion, t);
    }
    for (int row = 0; row < closureOfRow.length; row++) {
      acceleration[row] = closureOfRow[row].acceleration(rowInClosure[row]);
    }
  }

  /**
   * Returns bounds of the elements of J, after {@link #place}: a row far below them consists of
   * rounding errors.
   *
   * @return of the pattern of {@link #jacobian}
   */
  public SparseMatrix bounds(TreeMotion motion) {
    SparseMatrix bounds = jacobian.sameShape();
    for (int row = 0; row < closureOfRow.length; row++) {
      closureOfRow[row].addBounds(motion, rowInClosure[row], wholeRow, 0);
      takeWholeRow(row, bounds);
    }
    return bounds;
  }

  /**
   * Adds the forces Jᵀ λ as wrenches and joint forces.
   *
   * @param multipliers λ, one per equation, N or N·m; not modified
   * @param factor what they are multiplied by
   * @param wrench [moment; force], 6 per link, in link axes at the reference points; added to
   * @param tau one number per extended velocity; added to
   */
  public void addForces(double[] multipliers, double factor, double[] wrench, double[] tau) {
    for (int row = 0; row < closureOfRow.length; row++) {
      addForces(row, factor * multipliers[row], wrench, tau);
    }
  }

  /**
   * Adds the forces of one equation's multiplier, as {@link #addForces(double[], double, double[],
   * double[])}.
   */
  public void addForces(int row, double multiplier, double[] wrench, double[] tau) {
    if (multiplier != 0) {
      closureOfRow[row].addForces(rowInClosure[row], multiplier, wrench, tau);
    }
  }

  /** Returns the two bodies between which an equation acts, if it acts on nothing else. */
  public Optional<RelativeMotion> pair(int row) {
    return closureOfRow[row].pair();
  }

  /**
   * Writes the wrenches of a unit multiplier of an equation on the two bodies of {@link #pair},
   * after {@link #place}.
   *
   * @param onA [moment; force] in link axes at the reference point; overwritten
   * @param onB likewise
   */
  public void wrenches(int row, double[] onA, double[] onB) {
    closureOfRow[row].wrenches(rowInClosure[row], onA, onB);
  }

  /**
   * Adds the derivatives of the forces factor · Jᵀ λ by poses of links and by coordinates, after
   * {@link #place}.
   *
   * @param multipliers λ, one per equation, N or N·m; not modified
   */
  public void linearise(double[] multipliers, double factor, ForceJacobian sink) {
    int row = 0;
    for (int i = 0; i < closures.size(); i++) {
      closures.get(i).linearise(multipliers, row, factor, sink);
      row += closures.get(i).count();
    }
  }

  /** Adds the pairs of links that {@link #linearise} couples, some more than once. */
  public void couplings(Couplings couplings) {
    closures.forEach(rows -> rows.couplings(couplings));
  }

  /** Returns whether all couplings are between links next to each other, or with the root. */
  public boolean isLocal() {
    return closures.stream().allMatch(rows -> rows.isLocal(tree));
  }

  /** Records an accepted step: angles of cut joints are unwrapped from here. */
  public void accepted() {
    for (int i = 0; i < closures.size(); i++) {
      closures.get(i).accepted();
    }
  }

  /**
   * Returns the largest |Φ| relative to its size at the last {@link #place}; NaN if any Φ is NaN.
   */
  public double largestResidual() {
    int worst = worst(value);
    return worst < 0 ? 0 : Math.abs(value[worst]) / size(worst);
  }

  /** Returns the equation with the largest |Φ| relative to its size, or −1 if there is none. */
  public int worst() {
    return worst(value);
  }

  /**
   * Returns the row with the largest number relative to its size, the first NaN if there is one, or
   * −1.
   */
  public int worst(double[] residual) {
    int worst = -1;
    double largest = -1;
    for (int row = 0; row < residual.length; row++) {
      double part = Math.abs(residual[row]) / size(row);
      if (Double.isNaN(part)) {
        return row;
      }
      if (part > largest) {
        largest = part;
        worst = row;
      }
    }
    return worst;
  }
}
