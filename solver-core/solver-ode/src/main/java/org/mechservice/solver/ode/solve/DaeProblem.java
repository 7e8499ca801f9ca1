package org.mechservice.solver.ode.solve;

import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.mechservice.solver.ode.LinearisedSystem;
import org.mechservice.solver.ode.ResidualJacobianSystem;
import org.mechservice.solver.ode.ResidualSystem;
import org.mechservice.solver.ode.SparseSystem;
import org.mechservice.solver.ode.newton.ProductColumns;

/**
 * A problem in residual form, F(t, y, y') = 0 of index at most 1, composed of F and of what is
 * known about it. Made by {@link Dae#system}; immutable, each {@code with} method returns another
 * problem. Integrated by {@code ODE15SR}, which uses every part.
 */
public final class DaeProblem implements ResidualSystem {
  private final int dimension;
  private final DaeFunction function;
  private final PartsOfProblem parts;
  private final BitSet algebraic;
  private final boolean massMatrixMoves;

  DaeProblem(
      int dimension,
      DaeFunction function,
      PartsOfProblem parts,
      BitSet algebraic,
      boolean massMatrixMoves) {
    if (dimension < 0) {
      throw new IllegalArgumentException(
          "the number of unknowns is " + dimension + "; it must not be negative");
    }
    this.dimension = dimension;
    this.function = function;
    this.parts = parts;
    this.algebraic = algebraic;
    this.massMatrixMoves = massMatrixMoves;
  }

  /** Wraps a system with all its parts. */
  static DaeProblem of(ResidualSystem system) {
    BitSet algebraic = new BitSet();
    for (int i = 0; i < system.dimension(); i++) {
      algebraic.set(i, system.component(i) == Component.ALGEBRAIC);
    }
    return new DaeProblem(
        system.dimension(),
        system::residual,
        PartsOfProblem.of(system),
        algebraic,
        system.massMatrixMoves());
  }

  /** The derivatives of F, as a lambda. */
  @FunctionalInterface
  public interface Jacobians {
    /**
     * Evaluates ∂F/∂y and ∂F/∂y'.
     *
     * @param fy ∂F_i/∂y_j at i n + j; with a band (l, u) at i (l + u + 1) + j − i + l. All zero
     *     when handed in: elements that are zero need not be written
     * @param fyDot ∂F_i/∂y'_j, in the same way
     */
    void evaluate(double t, double[] y, double[] yDot, double[] fy, double[] fyDot);
  }

  /** The product of the derivatives of F with vectors, as a lambda. */
  @FunctionalInterface
  public interface JacobianProduct {
    /**
     * Evaluates ∂F/∂y v + ∂F/∂y' w.
     *
     * @param v length n; not to be modified
     * @param w length n; not to be modified
     * @param product length n; every component is to be written
     */
    void evaluate(double t, double[] y, double[] yDot, double[] v, double[] w, double[] product);
  }

  /**
   * Returns the problem with components declared algebraic: their derivatives do not appear in F,
   * they are in no error test, and y0 is corrected there. One whose derivative does appear is
   * refused when the problem is solved, at the start or, if its coefficient is zero there, behind
   * the first step, with analytic derivatives when they are next formed.
   *
   * @throws IllegalArgumentException if there is no such component
   */
  public DaeProblem withAlgebraic(int... components) {
    BitSet more = (BitSet) algebraic.clone();
    for (int component : components) {
      if (component < 0 || component >= dimension) {
        throw new IllegalArgumentException(
            "component "
                + component
                + " is declared algebraic; components are numbered from 0 to "
                + (dimension - 1));
      }
      more.set(component);
    }
    return new DaeProblem(dimension, function, parts, more, massMatrixMoves);
  }

  /** Returns the problem with analytic derivatives, in place of differences and of a product. */
  public DaeProblem withJacobians(Jacobians jacobians) {
    return with(ResidualJacobianSystem.class, new WithJacobians(this, jacobians));
  }

  /**
   * Returns the problem with derivatives known by their product with vectors, in place of
   * differences and of analytic ones. Each matrix is formed from n products, or with a band l + u +
   * 1, or with a pattern the number of groups of columns that share no row.
   */
  public DaeProblem withJacobianProduct(JacobianProduct product) {
    return with(parts.with(JacobianProduct.class, product));
  }

  /**
   * Returns the problem with a band: ∂F_i/∂y_j and ∂F_i/∂y'_j vanish unless −l ≤ j − i ≤ u.
   *
   * @throws IllegalArgumentException if l or u is not from 0 to n − 1
   */
  public DaeProblem withBand(int lower, int upper) {
    return with(parts.withBand(dimension, lower, upper));
  }

  /** Returns the problem with a pattern: {@code (i, j) -> true} where F_i contains y_j or y'_j. */
  public DaeProblem withPattern(SparseSystem pattern) {
    return with(parts.withPattern(pattern));
  }

  /** Returns the problem with the places at which F jumps: no step evaluates F across them. */
  public DaeProblem withBreakpoints(double... places) {
    return with(parts.withBreakpoints(places));
  }

  /**
   * Returns the problem with a part of any kind that stands beside {@link ResidualSystem}, such as
   * {@code ProjectedSystem.class}, {@code LinearisedSystem.class} or {@code SavedSystem.class}.
   *
   * @throws IllegalArgumentException if no integrator asks for such a part
   */
  public <T> DaeProblem with(Class<T> kind, T part) {
    PartsOfProblem.requireKind(kind, List.of(ResidualJacobianSystem.class, LinearisedSystem.class));
    boolean replaces = kind == ResidualJacobianSystem.class;
    PartsOfProblem others = replaces ? parts.without(JacobianProduct.class) : parts;
    return with(others.with(kind, part));
  }

  /**
   * Returns the problem with ∂F/∂y' declared to change with the state, as in M(y) y' = f(t, y). The
   * iteration then judges how far the matrix has moved away from its factors, which saves
   * derivatives and rejected steps; the solution is the same within its tolerances.
   */
  public DaeProblem withMovingMassMatrix() {
    return new DaeProblem(dimension, function, parts, algebraic, true);
  }

  /** Returns the problem with another function around F; all parts are kept. */
  public DaeProblem withFunction(UnaryOperator<DaeFunction> wrapper) {
    return new DaeProblem(dimension, wrapper.apply(function), parts, algebraic, massMatrixMoves);
  }

  private DaeProblem with(PartsOfProblem others) {
    return new DaeProblem(dimension, function, others, algebraic, massMatrixMoves);
  }

  @Override
  public int dimension() {
    return dimension;
  }

  @Override
  public void residual(double t, double[] y, double[] yDot, double[] residual) {
    function.evaluate(t, y, yDot, residual);
  }

  @Override
  public Component component(int index) {
    return algebraic.get(index) ? Component.ALGEBRAIC : Component.DIFFERENTIAL;
  }

  @Override
  public boolean massMatrixMoves() {
    return massMatrixMoves;
  }

  @Override
  public <T> Optional<T> part(Class<T> kind) {
    Optional<JacobianProduct> product =
        kind == ResidualJacobianSystem.class ? parts.part(JacobianProduct.class) : Optional.empty();
    return product.isPresent()
        ? Optional.of(kind.cast(new WithJacobians(this, formed(product.get()))))
        : parts.part(kind);
  }

  /** Forms the derivatives from products with vectors; the result is for one integration. */
  private Jacobians formed(JacobianProduct product) {
    ProductColumns columns = new ProductColumns(this, PartsOfProblem.layout(this, dimension));
    return (t, y, yDot, fy, fyDot) -> {
      for (int group = 0; group < columns.groupCount(); group++) {
        double[] v = columns.direction(group);
        product.evaluate(t, y, yDot, v, columns.zero, columns.product);
        columns.store(group, fy);
        product.evaluate(t, y, yDot, columns.zero, v, columns.product);
        columns.store(group, fyDot);
      }
    };
  }

  /** A system together with its derivatives. */
  record WithJacobians(ResidualSystem system, Jacobians known) implements ResidualJacobianSystem {
    @Override
    public int dimension() {
      return system.dimension();
    }

    @Override
    public void residual(double t, double[] y, double[] yDot, double[] residual) {
      system.residual(t, y, yDot, residual);
    }

    @Override
    public void jacobians(double t, double[] y, double[] yDot, double[] fy, double[] fyDot) {
      known.evaluate(t, y, yDot, fy, fyDot);
    }
  }
}
