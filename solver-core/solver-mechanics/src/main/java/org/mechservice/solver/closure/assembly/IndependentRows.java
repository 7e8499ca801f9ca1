package org.mechservice.solver.closure.assembly;

import java.util.List;
import org.mechservice.solver.closure.equations.LoopRounding;

/** The rank of a matrix, and its redundant rows. */
interface IndependentRows {
  /** Ratio of neighbouring singular values that marks the rank. */
  double GAP = 1e4;

  /** Fraction of the largest singular value that all values beyond the gap are below. */
  double NEGLIGIBLE = LoopRounding.MISFIT;

  /** Returns the number of independent rows. */
  int rank();

  /** Returns the redundant rows, ascending. */
  List<Integer> redundant();

  /** Returns the smallest pivot of the independent rows over the largest. */
  double smallestPivot();
}
