package org.mechservice.solver.linear;

/**
 * LU factors of a dense matrix many of whose rows hold, besides the diagonal, one element at most:
 * those of q' = v in I − hγ J, where they are every second, and those of unknowns that stand alone.
 * Such a row d x_i + a x_j = b_i is solved for x_i and put into the others, exactly as elimination
 * would; a quarter of the matrix is left to factor where it is half of the rows. Only rows with |a|
 * ≤ |d| are taken, so that no element of another row grows by more than the largest of that row;
 * the rest is factored with partial pivoting.
 *
 * <p>Rows are looked for in every matrix. Storage is allocated anew when their number changes.
 */
public final class CondensedLu implements LinearSolver {
  /**
   * Fewer rows stay where they are: such matrices cost little as a whole, and small problems keep
   * the bits, and so the steps, that dense factors give.
   */
  private static final int LEAST = 16;

  private static final int NONE = -1;

  private final int n;
  private final DenseLu whole;

  /** Rows kept and rows taken out, in ascending order, and how many. */
  private final int[] kept;

  private final int[] taken;
  private int keptCount;
  private int takenCount;

  /** Per index: its place among those kept; NONE if its row is taken out. */
  private final int[] placeOf;

  /** Whether an index has to stay, as a row taken out refers to it. */
  private final boolean[] referred;

  /** Per row taken out: the other unknown, or NONE; a / d; d. */
  private final int[] other;

  private final double[] ratio;
  private final double[] pivot;

  private boolean condensed;
  private DenseLu reduced = new DenseLu(0);

  /** The condensed matrix, row after row, and right-hand side. */
  private double[] small = {};

  private double[] right = {};

  /** Columns of the unknowns taken out in the rows kept, column after column. */
  private double[] columns = {};

  /**
   * @param dimension n, not negative
   * @throws IllegalArgumentException if it is negative
   */
  public CondensedLu(int dimension) {
    n = dimension;
    whole = new DenseLu(n);
    kept = new int[n];
    taken = new int[n];
    placeOf = new int[n];
    referred = new boolean[n];
    other = new int[n];
    ratio = new double[n];
    pivot = new double[n];
  }

  /**
   * Returns a solver that condenses matrices unless they are too small for that.
   *
   * @param dimension n, not negative
   */
  public static LinearSolver solverFor(int dimension) {
    return dimension < LEAST ? new DenseLu(dimension) : new CondensedLu(dimension);
  }

  @Override
  public MatrixLayout layout() {
    return whole.layout();
  }

  @Override
  public int factor(double[] matrix) {
    if (matrix.length != n * n) {
      return whole.factor(matrix);
    }
    condensed = takesEnough(matrix);
    if (!condensed) {
      return whole.factor(matrix);
    }
    if (right.length != keptCount) {
      reduced = new DenseLu(keptCount);
      small = new double[keptCount * keptCount];
      right = new double[keptCount];
      columns = new double[keptCount * takenCount];
    }
    condense(matrix);
    int singular = reduced.factor(small);
    return singular == NONSINGULAR ? NONSINGULAR : kept[singular];
  }

  /** Looks for rows to take out; returns whether they are worth it. */
  private boolean takesEnough(double[] matrix) {
    keptCount = 0;
    takenCount = 0;
    for (int i = 0; i < n; i++) {
      referred[i] = false;
      placeOf[i] = i;
    }
    for (int i = 0; i < n; i++) {
      if (!referred[i] && take(matrix, i)) {
        taken[takenCount] = i;
        placeOf[i] = NONE;
        takenCount++;
      }
    }
    for (int i = 0; i < n; i++) {
      if (placeOf[i] != NONE) {
        placeOf[i] = keptCount;
        kept[keptCount] = i;
        keptCount++;
      }
    }
    return takenCount >= LEAST;
  }

  /** Returns whether a row can be taken out; its elements are then noted. */
  private boolean take(double[] matrix, int i) {
    int row = i * n;
    int j = NONE;
    for (int k = 0; k < n; k++) {
      if (matrix[row + k] != 0 && k != i) {
        if (j != NONE) {
          return false;
        }
        j = k;
      }
    }
    double d = matrix[row + i];
    double a = j == NONE ? 0 : matrix[row + j];
    boolean usable = LuFactors.isPivot(d) && Math.abs(a) <= Math.abs(d);
    if (!usable || (j != NONE && placeOf[j] == NONE)) {
      return false;
    }
    if (j != NONE) {
      referred[j] = true;
    }
    other[takenCount] = j;
    ratio[takenCount] = a / d;
    pivot[takenCount] = d;
    return true;
  }

  private void condense(double[] matrix) {
    for (int r = 0; r < keptCount; r++) {
      int row = kept[r] * n;
      int into = r * keptCount;
      for (int c = 0; c < keptCount; c++) {
        small[into + c] = matrix[row + kept[c]];
      }
      for (int g = 0; g < takenCount; g++) {
        double element = matrix[row + taken[g]];
        columns[g * keptCount + r] = element;
        if (element != 0 && other[g] != NONE) {
          small[into + placeOf[other[g]]] -= element * ratio[g];
        }
      }
    }
  }

  @Override
  public void solve(double[] b) {
    if (!condensed) {
      whole.solve(b);
      return;
    }
    double[] x = right;
    for (int r = 0; r < keptCount; r++) {
      x[r] = b[kept[r]];
    }
    for (int g = 0; g < takenCount; g++) {
      double known = b[taken[g]] / pivot[g];
      b[taken[g]] = known;
      int column = g * keptCount;
      for (int r = 0; r < x.length; r++) {
        x[r] -= columns[column + r] * known;
      }
    }
    reduced.solve(x);
    for (int r = 0; r < keptCount; r++) {
      b[kept[r]] = x[r];
    }
    for (int g = 0; g < takenCount; g++) {
      if (other[g] != NONE) {
        b[taken[g]] -= ratio[g] * b[other[g]];
      }
    }
  }

  /** {@inheritDoc} It is that of the part that is left. */
  @Override
  public double reciprocalCondition() {
    return condensed ? reduced.reciprocalCondition() : whole.reciprocalCondition();
  }
}
