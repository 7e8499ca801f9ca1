package org.mechservice.sim.equations.derivatives;

import org.mechservice.solver.dynamics.tree.TreePattern;

/**
 * Output indices of the elements of M, ∂F/∂v and ∂F/∂q. Rows and columns are in {@link TreeOrder}.
 */
sealed interface ElementLayout {
  /** Returns the number of outputs of all elements. */
  int count();

  /** Returns the output index of an element of M; the row is at least the column. */
  int mass(int row, int column);

  /** Returns the output index of an element of ∂F/∂v. */
  int byVelocity(int row, int column);

  /** Returns the output index of an element of ∂F/∂q. */
  int byPosition(int row, int column);

  /**
   * The sparse layout of {@link org.mechservice.solver.dynamics.TreeStepModel}.
   *
   * @param pattern pattern of the elements that may differ from zero
   */
  record OfTree(TreePattern pattern) implements ElementLayout {
    @Override
    public int count() {
      return 3 * pattern.size() + 5 * pattern.elementCount();
    }

    @Override
    public int mass(int row, int column) {
      return row == column ? row : pattern.size() + pattern.find(row, column);
    }

    @Override
    public int byVelocity(int row, int column) {
      int n = pattern.size();
      int e = pattern.elementCount();
      if (row == column) {
        return n + e + row;
      }
      int element = pattern.find(Math.max(row, column), Math.min(row, column));
      return 2 * n + e + element + (row > column ? 0 : e);
    }

    @Override
    public int byPosition(int row, int column) {
      return byVelocity(row, column) + pattern.size() + 2 * pattern.elementCount();
    }
  }

  /**
   * The dense layout of {@link org.mechservice.solver.closure.equations.LoopTerms.OfDerivatives}.
   *
   * @param places order of the velocities
   */
  record Dense(TreeOrder places) implements ElementLayout {
    @Override
    public int count() {
      return 3 * places.size() * places.size();
    }

    @Override
    public int mass(int row, int column) {
      int i = places.get(row).velocity();
      int j = places.get(column).velocity();
      return places.size() * Math.max(i, j) + Math.min(i, j);
    }

    @Override
    public int byVelocity(int row, int column) {
      int n = places.size();
      return n * n + n * places.get(row).velocity() + places.get(column).velocity();
    }

    @Override
    public int byPosition(int row, int column) {
      return byVelocity(row, column) + places.size() * places.size();
    }
  }
}
