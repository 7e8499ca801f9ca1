package org.mechservice.solver.closure.model;

import java.util.Arrays;
import java.util.Optional;
import org.mechservice.solver.linear.SparseElimination;
import org.mechservice.solver.linear.SparseLu;
import org.mechservice.solver.linear.SparseMatrix;

/**
 * A partition chosen by sparse elimination: pivots are large relative to the remaining elements of
 * their rows and cause little fill-in. Choosing allocates memory; evaluations do not.
 */
final class SparsePartition extends Partition {
  /**
   * Part of its size at the last comparison that the smallest pivot may lose before the choice is
   * compared with others again, which costs many times an evaluation in a net of loops.
   */
  private static final double UNCHANGED = 0.7;

  /** Part of the largest size so far below which the choice is compared at every state. */
  private static final double FAR_FROM_SINGULAR = 0.1;

  private final SparseElimination elimination;
  private final SparseMatrix scaled;
  private SparseLu factors;

  /** Index of each equation among the kept ones, and of each unknown among the dependent ones. */
  private final int[] keptPlace;

  private final int[] dependentPlace;
  private final double[] work;

  /** Factorisation whose order of pivots the factors use, if any. */
  private Optional<SparseLu> orderedBy = Optional.empty();

  /** Smallest pivot of the best choice in the last matrix examined, as far as it was compared. */
  private double best;

  /** Smallest pivot of the present choice when it was last compared with others. */
  private double compared;

  private double largest;
  private int found;

  SparsePartition(SparseMatrix pattern, int unknowns, int rank) {
    super(pattern.rows(), unknowns, rank);
    elimination = new SparseElimination(m, n);
    scaled = pattern.sameShape();
    factors = new SparseLu(elimination, 0, n);
    keptPlace = new int[m];
    dependentPlace = new int[n];
    work = new double[rank];
  }

  @Override
  void copyChoice(Partition other) {
    super.copyChoice(other);
    SparsePartition sparse = (SparsePartition) other;
    if (orderedBy.isEmpty() || orderedBy.get() != sparse.factors) {
      orderedBy = Optional.of(sparse.factors);
      factors = sparse.factors.sameOrder();
      findPlaces();
    }
  }

  /**
   * {@inheritDoc} The choice is written in the order of the pivots, because the last bits of
   * solutions depend on it.
   */
  @Override
  void save(double[] state, int at) {
    for (int k = 0; k < factors.size(); k++) {
      state[at + k] = factors.row(k);
      state[at + rank + k] = factors.column(k);
    }
    state[at + 2 * rank] = compared;
    state[at + 2 * rank + 1] = largest;
  }

  @Override
  int stateLength() {
    return super.stateLength() + 2;
  }

  @Override
  void restore(double[] state, int at) {
    super.restore(state, at);
    compared = state[at + 2 * rank];
    largest = state[at + 2 * rank + 1];
    int[] rows = new int[rank];
    int[] columns = new int[rank];
    Arrays.setAll(rows, k -> (int) state[at + k]);
    Arrays.setAll(columns, k -> (int) state[at + rank + k]);
    SparseElimination again = new SparseElimination(m, n);
    again.repeat(scaled, rows, columns);
    orderedBy = Optional.empty();
    factors = new SparseLu(again, rank, n);
    findPlaces();
  }

  @Override
  boolean choose(SparseMatrix a) {
    boolean done = chooseBetter(a, 0);
    compared = best;
    largest = best;
    return done;
  }

  /**
   * {@inheritDoc} A choice whose pivots have kept their size is not compared with others: its
   * smallest pivot then stands for that of the best.
   */
  @Override
  boolean renew(SparseMatrix a, double better) {
    double pivot = smallestPivot(a);
    if (pivot >= UNCHANGED * compared && compared >= FAR_FROM_SINGULAR * largest) {
      formScaled(a);
      best = pivot;
      return false;
    }
    boolean other = chooseBetter(a, better * pivot);
    compared = other ? best : pivot;
    largest = Math.max(largest, best);
    return other;
  }

  @Override
  boolean chooseBetter(SparseMatrix a, double bound) {
    formScaled(a);
    eliminate(scaled);
    if (!(bestPivot() > bound)) {
      return false;
    }
    int[] rows = new int[rank];
    int[] columns = new int[rank];
    Arrays.setAll(rows, elimination::row);
    Arrays.setAll(columns, elimination::column);
    take(rows, columns);
    orderedBy = Optional.empty();
    factors = new SparseLu(elimination, rank, n);
    findPlaces();
    return true;
  }

  private void eliminate(SparseMatrix matrix) {
    found = elimination.eliminate(matrix, rank, 0);
    best = found < rank ? 0 : elimination.smallestPivot();
  }

  private void formScaled(SparseMatrix a) {
    for (int i = 0; i < m; i++) {
      for (int e = a.start[i]; e < a.start[i + 1]; e++) {
        int j = a.column[e];
        scaled.value[e] = j < n ? rowScale[i] * a.value[e] * columnScale[j] : 0;
      }
    }
  }

  private void findPlaces() {
    for (int k = 0; k < rank; k++) {
      keptPlace[kept[k]] = k;
      dependentPlace[dependent[k]] = k;
    }
  }

  @Override
  int scaledLength() {
    return scaled.value.length;
  }

  @Override
  double[] scaled() {
    return scaled.value;
  }

  @Override
  double bestPivot(double[] elements) {
    SparseMatrix looked = scaled.sameShape();
    System.arraycopy(elements, 0, looked.value, 0, looked.value.length);
    eliminate(looked);
    return bestPivot();
  }

  @Override
  double bestPivot() {
    return best;
  }

  @Override
  int weakestRow() {
    return found == 0 ? 0 : elimination.row(found < rank ? found : elimination.weakest());
  }

  @Override
  double smallestPivot(SparseMatrix a) {
    return factor(a) ? factors.smallestPivot() : 0;
  }

  @Override
  boolean factor(SparseMatrix a) {
    return factors.factor(a, rowScale, columnScale);
  }

  @Override
  int orientation() {
    return factors.signOfDeterminant();
  }

  @Override
  void solve(double[] b) {
    for (int k = 0; k < rank; k++) {
      work[k] = b[keptPlace[factors.row(k)]];
    }
    factors.solve(work);
    for (int k = 0; k < rank; k++) {
      b[dependentPlace[factors.column(k)]] = work[k];
    }
  }

  @Override
  void solveTransposed(double[] b) {
    for (int k = 0; k < rank; k++) {
      work[k] = b[dependentPlace[factors.column(k)]];
    }
    factors.solveTransposed(work);
    for (int k = 0; k < rank; k++) {
      b[keptPlace[factors.row(k)]] = work[k];
    }
  }
}
