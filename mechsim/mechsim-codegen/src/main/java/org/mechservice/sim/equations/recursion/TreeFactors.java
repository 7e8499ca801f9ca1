package org.mechservice.sim.equations.recursion;

import java.util.List;
import java.util.function.IntFunction;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;

/**
 * Factors M = LᵀDL of a matrix with elements only between each row and its ancestors. Elimination
 * from the leaves inwards causes no fill-in (Featherstone 2008, §6.5).
 */
public final class TreeFactors {
  /** Checks a pivot. */
  public interface Check {
    /** Returns whether the pivot of a row is always zero. */
    boolean vanishes(int row, Scalar pivot);
  }

  private final Program program;
  private final Scalar[][] elements;
  private final List<List<Integer>> ancestors;
  private final IntFunction<String> labels;

  /**
   * @param elements lower triangle of M; overwritten with L below and D on the diagonal
   * @param ancestors ancestors of each row, the nearest first
   * @param labels names of rows
   */
  public TreeFactors(
      Program program,
      Scalar[][] elements,
      List<List<Integer>> ancestors,
      IntFunction<String> labels) {
    this.program = program;
    this.elements = elements;
    this.ancestors = ancestors;
    this.labels = labels;
  }

  /** Factors; returns whether every pivot can be other than zero. */
  public boolean factor(Check check) {
    for (int k = elements.length - 1; k >= 0; k--) {
      String label = labels.apply(k);
      program.section("Factors: row " + label + ".\nL = M / D, M -= L' D L", label);
      Scalar pivot = program.named("D_" + label, elements[k][k]);
      if (check.vanishes(k, pivot)) {
        return false;
      }
      eliminate(k, pivot, label);
    }
    return true;
  }

  private void eliminate(int k, Scalar pivot, String label) {
    List<Integer> way = ancestors.get(k);
    Scalar reciprocal = program.named("one_over_D_" + label, pivot.expressions().one().over(pivot));
    for (int a = 0; a < way.size(); a++) {
      int i = way.get(a);
      Scalar factor =
          program.named("L_" + label + "_" + labels.apply(i), elements[k][i].times(reciprocal));
      for (int j : way.subList(a, way.size())) {
        elements[i][j] = elements[i][j].minus(factor.times(elements[k][j]));
      }
      elements[k][i] = factor;
    }
    elements[k][k] = reciprocal;
  }

  /** Returns M⁻¹ b. */
  public Scalar[] solve(Scalar[] b) {
    Scalar[] x = b.clone();
    for (int k = x.length - 1; k >= 0; k--) {
      program.section("Solution, inwards: row " + labels.apply(k) + ".", labels.apply(k));
      for (int i : ancestors.get(k)) {
        x[i] = x[i].minus(elements[k][i].times(x[k]));
      }
      x[k] = program.named("u_over_D_" + labels.apply(k), x[k].times(elements[k][k]));
    }
    for (int k = 0; k < x.length; k++) {
      program.section("Solution, outwards: row " + labels.apply(k) + ".", labels.apply(k));
      for (int i : ancestors.get(k)) {
        x[k] = x[k].minus(elements[k][i].times(x[i]));
      }
      program.named("qdd_" + labels.apply(k), x[k]);
    }
    return x;
  }
}
