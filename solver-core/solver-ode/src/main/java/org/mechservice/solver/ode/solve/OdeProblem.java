package org.mechservice.solver.ode.solve;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.IntFunction;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import org.mechservice.solver.linear.BlockLayout;
import org.mechservice.solver.ode.BlockSystem;
import org.mechservice.solver.ode.JacobianSystem;
import org.mechservice.solver.ode.OdeSystem;
import org.mechservice.solver.ode.SparseSystem;
import org.mechservice.solver.ode.newton.ProductColumns;

/**
 * An explicit problem y' = f(t, y), composed of f and of what is known about it. Made by {@link
 * Ode#system}; immutable, each {@code with} method returns another problem.
 *
 * <pre>{@code
 * OdeProblem heat = Ode.system(n, f).withBand(1, 1).withBreakpoints(0.5);
 * OdeProblem counted = heat.withFunction(g -> (t, y, yDot) -> { count++; g.evaluate(t, y, yDot); });
 * }</pre>
 *
 * <p>A part that is given replaces one of the same kind. What each method uses: every method the
 * breakpoints, and the parts of {@link #with}; {@code ODE15S}, {@code ODE15SR} and {@code AUTO}
 * also band, blocks, pattern and Jacobian. {@code ODE113} and {@code DE} solve no equations and
 * never ask for those four, which are aids and do not change the solution.
 */
public final class OdeProblem implements OdeSystem {
  /** A component is moved by this part of its size, or of one, to see which equations it is in. */
  private static final double MOVE = 1e-3;

  /** The second state to look at is another by up to this part of each component. */
  private static final double APART = 1e-2;

  private static final long SEED = 1;

  private final int dimension;
  private final OdeFunction function;
  private final PartsOfProblem parts;

  OdeProblem(int dimension, OdeFunction function, PartsOfProblem parts) {
    if (dimension < 0) {
      throw new IllegalArgumentException(
          "the number of unknowns is " + dimension + "; it must not be negative");
    }
    this.dimension = dimension;
    this.function = function;
    this.parts = parts;
  }

  /** The Jacobian of f, as a lambda. */
  @FunctionalInterface
  public interface Jacobian {
    /**
     * Evaluates ∂f/∂y.
     *
     * @param fy ∂f_i/∂y_j at i n + j; with a band (l, u) at i (l + u + 1) + j − i + l, with blocks
     *     where {@link BlockLayout} has it. All zero when handed in: elements that are zero need
     *     not be written
     */
    void evaluate(double t, double[] y, double[] fy);
  }

  /** The product of the Jacobian of f with a vector, as a lambda. */
  @FunctionalInterface
  public interface JacobianProduct {
    /**
     * Evaluates ∂f/∂y v.
     *
     * @param v length n; not to be modified
     * @param product length n; every component is to be written
     */
    void evaluate(double t, double[] y, double[] v, double[] product);
  }

  /** Returns the problem with an analytic Jacobian, in place of differences and of a product. */
  public OdeProblem withJacobian(Jacobian jacobian) {
    return with(JacobianSystem.class, new WithJacobian(this, jacobian));
  }

  /**
   * Returns the problem with a Jacobian that is known by its product with vectors, as automatic
   * differentiation gives it, in place of differences and of an analytic Jacobian. The matrix is
   * formed from as many products as differences would take evaluations: n, or with a band l + u +
   * 1, or with blocks their size, or with a pattern the number of groups of columns that share no
   * row. Equations are solved with the matrix, not by a Krylov method.
   */
  public OdeProblem withJacobianProduct(JacobianProduct product) {
    return new OdeProblem(dimension, function, parts.with(JacobianProduct.class, product));
  }

  /**
   * Returns the problem with a band: ∂f_i/∂y_j vanishes unless −l ≤ j − i ≤ u.
   *
   * @param lower l, diagonals below the main one, from 0 to n − 1
   * @param upper u, diagonals above the main one, from 0 to n − 1
   * @throws IllegalArgumentException if one of them is out of range
   */
  public OdeProblem withBand(int lower, int upper) {
    return new OdeProblem(dimension, function, parts.withBand(dimension, lower, upper));
  }

  /**
   * Returns the problem with components in blocks that do not couple, or only so weakly that
   * Newton's iteration may leave it out: those of a system side by side with its sensitivities.
   *
   * @param size components of a block, at least 1; the last block has what is left
   * @throws IllegalArgumentException if it is less than 1
   */
  public OdeProblem withBlocks(int size) {
    BlockLayout layout = new BlockLayout(dimension, size);
    return with(BlockSystem.class, layout::size);
  }

  /**
   * Returns the problem with a pattern: {@code (i, j) -> true} where f_i depends on y_j.
   *
   * @param pattern asked for all pairs when a problem is begun; for many unknowns, {@linkplain
   *     #withPatternByColumns columns} are quicker
   */
  public OdeProblem withPattern(SparseSystem pattern) {
    return with(SparseSystem.class, pattern);
  }

  /**
   * Returns the problem with a pattern that is given by columns.
   *
   * @param equations returns for a component j the equations i, in any order, that depend on y_j
   */
  public OdeProblem withPatternByColumns(IntFunction<int[]> equations) {
    return withPattern(SparseSystem.byColumns(equations));
  }

  /**
   * Returns the problem with the pattern that f shows near a state: each component is moved by a
   * thousandth there and at a second state close by, in 2 n + 2 evaluations. A coupling that
   * vanishes at both, such as that of a switch that is off, is not seen; the solution stays right
   * as to its tolerance, but steps may become short.
   *
   * @param y a state at which all terms of f count; not modified
   * @throws IllegalArgumentException if its length is not n or f is not finite there
   */
  public OdeProblem withProbedPattern(double t, double[] y) {
    OdeSolution.requireLength("y", y, dimension);
    return withPattern(couplingsNear(function, t, y));
  }

  /** Returns the problem with the places at which f jumps: no step evaluates f across them. */
  public OdeProblem withBreakpoints(double... places) {
    return new OdeProblem(dimension, function, parts.withBreakpoints(places));
  }

  /**
   * Returns the problem with a part of any kind that stands beside {@link OdeSystem}, such as
   * {@code ProjectedSystem.class}, {@code ErrorWeightGroups.class} or {@code SavedSystem.class}.
   *
   * @throws IllegalArgumentException if no integrator asks for such a part
   */
  public <T> OdeProblem with(Class<T> kind, T part) {
    PartsOfProblem.requireKind(kind, List.of(JacobianSystem.class));
    boolean replaces = kind == JacobianSystem.class;
    PartsOfProblem others = replaces ? parts.without(JacobianProduct.class) : parts;
    return new OdeProblem(dimension, function, others.with(kind, part));
  }

  /** Returns the problem with another function around f; all parts are kept. */
  public OdeProblem withFunction(UnaryOperator<OdeFunction> wrapper) {
    return new OdeProblem(dimension, wrapper.apply(function), parts);
  }

  /**
   * Returns the problem M y' = f(t, y).
   *
   * @throws IllegalArgumentException if the matrix has another number of rows
   */
  public MassProblem withMass(MassMatrix mass) {
    return new MassProblem(this, mass);
  }

  @Override
  public int dimension() {
    return dimension;
  }

  @Override
  public void derivative(double t, double[] y, double[] yDot) {
    function.evaluate(t, y, yDot);
  }

  @Override
  public <T> Optional<T> part(Class<T> kind) {
    Optional<JacobianProduct> product =
        kind == JacobianSystem.class ? parts.part(JacobianProduct.class) : Optional.empty();
    return product.isPresent()
        ? Optional.of(kind.cast(new WithJacobian(this, formed(product.get()))))
        : parts.part(kind);
  }

  /**
   * Forms the Jacobian from products with vectors; the result is a workspace of one integration.
   */
  private Jacobian formed(JacobianProduct product) {
    ProductColumns columns = new ProductColumns(this, PartsOfProblem.layout(this, dimension));
    return (t, y, fy) -> {
      for (int group = 0; group < columns.groupCount(); group++) {
        product.evaluate(t, y, columns.direction(group), columns.product);
        columns.store(group, fy);
      }
    };
  }

  /** A system together with its Jacobian. */
  record WithJacobian(OdeSystem system, Jacobian known) implements JacobianSystem {
    @Override
    public int dimension() {
      return system.dimension();
    }

    @Override
    public void derivative(double t, double[] y, double[] yDot) {
      system.derivative(t, y, yDot);
    }

    @Override
    public void jacobian(double t, double[] y, double[] fy) {
      known.evaluate(t, y, fy);
    }
  }

  /**
   * Returns the couplings seen near a state, from 2 n + 2 evaluations.
   *
   * @throws IllegalArgumentException if f is not finite there
   */
  private static SparseSystem couplingsNear(OdeFunction function, double t, double[] y) {
    int n = y.length;
    double[] other = y.clone();
    Random random = new Random(SEED);
    for (int j = 0; j < n; j++) {
      other[j] += APART * random.nextDouble() * Math.max(1, Math.abs(y[j]));
    }
    double[][] points = {y.clone(), other};
    double[][] values = {valueAt(function, t, points[0]), valueAt(function, t, points[1])};
    int[][] rows = new int[n][];
    for (int j = 0; j < n; j++) {
      boolean[] coupled = new boolean[n];
      for (int point = 0; point < points.length; point++) {
        double own = points[point][j];
        points[point][j] += MOVE * Math.max(1, Math.abs(own));
        double[] moved = new double[n];
        function.evaluate(t, points[point], moved);
        points[point][j] = own;
        for (int i = 0; i < n; i++) {
          coupled[i] |= moved[i] != values[point][i];
        }
      }
      rows[j] = IntStream.range(0, n).filter(i -> coupled[i]).toArray();
    }
    return SparseSystem.byColumns(j -> rows[j]);
  }

  private static double[] valueAt(OdeFunction function, double t, double[] y) {
    double[] value = new double[y.length];
    function.evaluate(t, y, value);
    for (int i = 0; i < value.length; i++) {
      if (!Double.isFinite(value[i])) {
        throw new IllegalArgumentException(
            "f["
                + i
                + "] is "
                + value[i]
                + " near the state at which the pattern is to be found;"
                + " give another state, or the pattern");
      }
    }
    return value;
  }
}
