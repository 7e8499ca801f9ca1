package org.mechservice.solver.dynamics.tree;

/** The elements of a matrix over the velocities of the state, laid out by a {@link TreePattern}. */
public interface TreeElements {
  /** Returns the elements on the diagonal, by place. */
  double[] diagonal();

  /** Returns element (row, column) for each column of each row of the pattern. */
  double[] lower();

  /** Returns element (column, row) for each column of each row of the pattern. */
  double[] upper();
}
