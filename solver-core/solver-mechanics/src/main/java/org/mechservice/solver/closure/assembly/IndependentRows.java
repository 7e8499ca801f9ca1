package org.mechservice.solver.closure.assembly;

import java.util.List;

/** How many rows of a matrix are independent, and which follow from the others. */
interface IndependentRows {
  /** Ratio of neighbouring singular values that separates rows from repetitions. */
  double GAP = 1e4;

  /** What lies beyond the gap is smaller than this part of the largest. */
  double NEGLIGIBLE = 1e-8;

  /** Returns how many rows are independent. */
  int rank();

  /** Returns the rows that follow from the others, ascending. */
  List<Integer> redundant();

  /** Returns the smallest pivot of the independent rows over the largest. */
  double smallestPivot();
}
