package org.mechservice.solver.closure.assembly;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Random;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.closure.equations.CoordinateUnits;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.closure.equations.LoopRounding;
import org.mechservice.solver.dynamics.SemiRecursive;
import org.mechservice.solver.kinematics.StateCoordinates;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.linear.Interruption;
import org.mechservice.solver.linear.SparseMatrix;

/**
 * The number of independent loop equations (docs/theory/loops.md#rank): the rank of J M^(−1/2) with
 * rows of unit length, at the assembled state and at three neighbouring assembled states, since the
 * rank drops in a singular position. The largest of these is used for the whole run. Predicted
 * states do not satisfy the loops, and J there seems to have a larger rank.
 *
 * <p>Runs once at set-up and allocates memory.
 */
public final class RankAnalysis {
  /**
   * Fraction of the sum of the sizes of its products below which a row consists of their rounding
   * errors, and is zero.
   */
  private static final double NOTHING = 1e-11;

  /**
   * Fraction of its size below which an equation does not change when every coordinate changes by
   * its unit: its row is zero. Scaled to unit length, such a row of misfits of the data would count
   * as an independent one.
   */
  private static final double UNMOVED = LoopRounding.MISFIT;

  /**
   * Distance of the neighbouring states from the assembled one, rad or lengths of the mechanism,
   * and their number.
   */
  private static final double NEARBY = 1e-3;

  private static final int NEIGHBOURS = 3;

  /**
   * Ratio of the smallest to the largest pivot below which independent coordinates are
   * ill-conditioned.
   */
  private static final double BAD_PIVOT = 1e-6;

  private final TreeMotion motion;
  private final LoopEquations loops;
  private final StateCoordinates coordinates;
  private final CoordinateUnits units;
  private final Assembly assembly;
  private final SemiRecursive open;
  private final boolean isSparse;
  private final int m;
  private final int n;
  private final int rankAtStart;
  private int rank;
  private int positionRank;
  private double smallestPivot = 1;
  private List<Integer> redundant = List.of();

  /**
   * Determines the rank.
   *
   * @param t time of the start, s
   * @param y state that closes the loops; not modified
   */
  public RankAnalysis(TreeGeometry tree, double t, double[] y) {
    this(tree, t, y, LoopEquations::isLargeToSetUp);
  }

  /**
   * As above, with matrices chosen by the caller. Both give the same rank, by different means: the
   * comparison proves each by the other.
   *
   * @param isLarge whether the rank comes from sparse elimination, not from singular values alone
   */
  public RankAnalysis(TreeGeometry tree, double t, double[] y, Predicate<LoopEquations> isLarge) {
    motion = new TreeMotion(tree);
    loops = new LoopEquations(tree);
    coordinates = new StateCoordinates(tree.mechanism());
    units = new CoordinateUnits(tree.mechanism(), loops.length());
    isSparse = isLarge.test(loops);
    assembly = new Assembly(tree, isLarge);
    open = new SemiRecursive(motion);
    m = loops.count();
    n = tree.stateVelocityCount;
    rankAtStart = judge(t, y);
    Random random = new Random(314159);
    for (int i = 0; i < NEIGHBOURS && m > 0; i++) {
      Interruption.check();
      double[] near = near(t, y, random);
      judge(t, near);
    }
  }

  private double[] near(double t, double[] y, Random random) {
    double[] near = y.clone();
    double[] move = new double[n];
    for (int j = 0; j < n; j++) {
      move[j] = (2 * random.nextDouble() - 1) * units.velocities[j];
    }
    coordinates.move(near, 0, move, 0, NEARBY);
    assembly.closeNear(t, near);
    return near;
  }

  /** Returns the rank at a state, and keeps it if it is larger than the one known. */
  private int judge(double t, double[] y) {
    motion.sweep(t, y);
    loops.place(motion, t);
    loops.differentiate(motion);
    IndependentRows rows;
    int ofPositions;
    if (isSparse) {
      SparseMatrix scaled = scaledInUnits();
      rows = new SparseIndependentRows(scaled, n);
      ofPositions = loops.isHolonomic() ? rows.rank() : positionRank(scaled);
    } else {
      double[] scaled = scaledByMass();
      rows = new DenseIndependentRows(scaled, m, n);
      ofPositions = loops.isHolonomic() ? rows.rank() : positionRank(scaled);
    }
    positionRank = Math.max(positionRank, ofPositions);
    if (rows.rank() >= rank) {
      rank = rows.rank();
      redundant = rows.redundant();
      smallestPivot = rows.smallestPivot();
    }
    return rows.rank();
  }

  private int positionRank(SparseMatrix scaled) {
    for (int row = 0; row < m; row++) {
      if (!loops.isHolonomic(row)) {
        Arrays.fill(scaled.value, scaled.start[row], scaled.start[row + 1], 0);
      }
    }
    return loops.holonomicCount() == 0 ? 0 : new SparseIndependentRows(scaled, n).rank();
  }

  private int positionRank(double[] scaled) {
    int count = loops.holonomicCount();
    double[] ofPositions = new double[count * n];
    int next = 0;
    for (int row = 0; row < m; row++) {
      if (loops.isHolonomic(row)) {
        System.arraycopy(scaled, row * n, ofPositions, n * next++, n);
      }
    }
    return count == 0 ? 0 : new DenseIndependentRows(ofPositions, count, n).rank();
  }

  /**
   * Returns J M^(−1/2) with rows of unit length; rows of rounding errors are zero. M is singular if
   * bodies get inertia only through loops; columns are then scaled by units.
   */
  private double[] scaledByMass() {
    SparseMatrix bounds = loops.bounds(motion);
    open.formMassMatrix();
    double[] dense = new double[n * n];
    open.massMatrix().toDense(dense);
    boolean regular = open.factorMassMatrix() == ExplicitModel.REGULAR;
    double[] scaled = new double[m * n];
    SparseMatrix jacobian = loops.jacobian;
    for (int row = 0; row < m; row++) {
      double size = 0;
      double bound = 0;
      double largest = 0;
      for (int e = jacobian.start[row]; e < jacobian.start[row + 1]; e++) {
        int j = jacobian.column[e];
        if (j < n) {
          double perMass = regular ? 1 / Math.sqrt(dense[j * n + j]) : units.velocities[j];
          double element = jacobian.value[e];
          scaled[row * n + j] = regular ? element : element * perMass;
          size = Math.hypot(size, element * perMass);
          largest = Math.max(largest, Math.abs(element) * units.velocities[j]);
          bound = Math.hypot(bound, bounds.value[e] * perMass);
        }
      }
      if (regular) {
        open.massMatrix().halfSolve(scaled, row * n);
      }
      boolean moves = largest > UNMOVED * loops.size(row);
      scaleToUnit(scaled, row, moves && size > NOTHING * bound);
    }
    return scaled;
  }

  private void scaleToUnit(double[] scaled, int row, boolean counts) {
    double length = 0;
    for (int j = 0; j < n; j++) {
      length = Math.hypot(length, scaled[row * n + j]);
    }
    for (int j = 0; j < n; j++) {
      scaled[row * n + j] = counts ? scaled[row * n + j] / length : 0;
    }
  }

  /** Returns J with columns in units and rows of unit length, or zero. */
  private SparseMatrix scaledInUnits() {
    SparseMatrix bounds = loops.bounds(motion);
    SparseMatrix scaled = loops.jacobian.sameShape();
    for (int row = 0; row < m; row++) {
      double length = 0;
      double bound = 0;
      double largest = 0;
      for (int e = scaled.start[row]; e < scaled.start[row + 1]; e++) {
        double unit = scaled.column[e] < n ? units.velocities[scaled.column[e]] : 0;
        scaled.value[e] = loops.jacobian.value[e] * unit;
        length = Math.hypot(length, scaled.value[e]);
        largest = Math.max(largest, Math.abs(scaled.value[e]));
        bound = Math.hypot(bound, bounds.value[e] * unit);
      }
      boolean counts = largest > UNMOVED * loops.size(row) && length > NOTHING * bound;
      for (int e = scaled.start[row]; e < scaled.start[row + 1]; e++) {
        scaled.value[e] = counts ? scaled.value[e] / length : 0;
      }
    }
    return scaled;
  }

  /** Returns the number of independent equations. */
  public int rank() {
    return rank;
  }

  /** Returns the number of independent equations among those that restrict positions. */
  public int positionRank() {
    return positionRank;
  }

  /** Returns the rows of the redundant equations. */
  public List<Integer> redundant() {
    return redundant;
  }

  /** Returns whether the rank at the start is lower than at neighbouring states. */
  public boolean startsSingular() {
    return rankAtStart < rank;
  }

  /**
   * Returns the reason against independent coordinates, if there is one: the rank is lower at the
   * start than near it, or the best choice has a pivot far below the largest.
   */
  public Optional<String> againstProjection() {
    if (startsSingular()) {
      return Optional.of("the loops start in a singular position");
    }
    String part = String.format(Locale.ROOT, "%.1e", smallestPivot);
    return smallestPivot < BAD_PIVOT
        ? Optional.of("the smallest pivot of the loops is " + part + " of the largest")
        : Optional.empty();
  }

  /** Returns the findings for the user: redundant equations, a singular start. */
  public List<LoopFinding> findings(double t) {
    List<LoopFinding> findings = new ArrayList<>();
    if (!redundant.isEmpty()) {
      findings.add(
          new LoopFinding(LoopFinding.Kind.REDUNDANT, names(redundant), redundant.size(), "1", t));
    }
    if (startsSingular()) {
      List<Integer> all = IntStream.range(0, m).boxed().toList();
      findings.add(
          new LoopFinding(LoopFinding.Kind.SINGULAR_START, names(all), rank - rankAtStart, "1", t));
    }
    return findings;
  }

  private String names(List<Integer> rows) {
    return rows.stream().map(loops::name).collect(Collectors.joining(", "));
  }
}
