package org.mechservice.solver.ode;

import java.util.Arrays;
import java.util.function.IntFunction;
import java.util.stream.IntStream;

/**
 * A system that knows which components each equation has in it: ∂f_i/∂y_j, or in residual form
 * ∂F_i/∂y_j and ∂F_i/∂y'_j, vanish for the others. Implemented beside {@link OdeSystem} or {@link
 * ResidualSystem}.
 *
 * <p>Implicit methods then difference columns together that share no row, so that derivatives of a
 * ring of any length take three or four evaluations. From 100 unknowns on, equations are solved
 * with sparse factors in an order that keeps them sparse, unless most elements may differ from
 * zero, the problem forms its Jacobian itself, or it is a {@link BandedSystem}, too.
 *
 * <p>Of a large system, {@linkplain #byColumns columns} are to be given: pairs are asked for one by
 * one, which takes n² questions.
 */
public interface SparseSystem {
  /**
   * Returns whether an equation has a component or its derivative in it. Asked when a problem is
   * begun. For a {@link CompletedSystem} what counts is whether the component moves the equation
   * along completed states.
   *
   * @param equation i, from 0
   * @param component j, from 0
   */
  boolean couples(int equation, int component);

  /**
   * Returns all equations that have a component or its derivative in them, ascending.
   *
   * @param component j, from 0
   * @param dimension n, the number of equations
   */
  default int[] equations(int component, int dimension) {
    return IntStream.range(0, dimension).filter(i -> couples(i, component)).toArray();
  }

  /**
   * Returns a pattern that is known by columns.
   *
   * @param equations returns for a component j the equations i, in any order, that have it in them
   * @throws IllegalArgumentException when asked, if an equation is negative or not less than n
   */
  static SparseSystem byColumns(IntFunction<int[]> equations) {
    return new SparseSystem() {
      @Override
      public boolean couples(int equation, int component) {
        return Arrays.stream(equations.apply(component)).anyMatch(i -> i == equation);
      }

      @Override
      public int[] equations(int component, int dimension) {
        int[] found = Arrays.stream(equations.apply(component)).sorted().distinct().toArray();
        for (int i : found) {
          if (i < 0 || i >= dimension) {
            throw new IllegalArgumentException(
                "component "
                    + component
                    + " is said to be in equation "
                    + i
                    + "; equations are numbered from 0 to "
                    + (dimension - 1));
          }
        }
        return found;
      }
    };
  }
}
