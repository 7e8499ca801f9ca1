package org.mechservice.solver.ode.solve;

import java.util.Arrays;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import org.mechservice.solver.linear.BandLayout;
import org.mechservice.solver.linear.LinearSolver;
import org.mechservice.solver.linear.MatrixLayout;
import org.mechservice.solver.ode.BandedSystem;
import org.mechservice.solver.ode.BlockSystem;
import org.mechservice.solver.ode.JacobianSystem;
import org.mechservice.solver.ode.LinearisedSystem;
import org.mechservice.solver.ode.OdeSystem;
import org.mechservice.solver.ode.ResidualJacobianSystem;
import org.mechservice.solver.ode.ResidualSystem;
import org.mechservice.solver.ode.SparseSystem;

/**
 * A problem M y' = f(t, y) with a constant matrix M, made by {@link OdeProblem#withMass}.
 *
 * <p>{@code ODE113} and {@code DE} integrate y' = M⁻¹ f(t, y), with M factored once; they refuse a
 * singular M. {@code ODE15S} and {@code ODE15SR} integrate the residual form M y' − f(t, y) = 0, in
 * which bands, patterns and Jacobians of f are used together with those of M and M may be singular:
 * a component whose column of M is zero is algebraic, and y0 is corrected there. {@code AUTO}
 * switches between both kinds if M is diagonal and regular, and takes the residual form otherwise.
 */
public final class MassProblem {
  private final OdeProblem problem;
  private final MassMatrix mass;

  MassProblem(OdeProblem problem, MassMatrix mass) {
    if (mass.dimension() != problem.dimension()) {
      throw new IllegalArgumentException(
          "the mass matrix has "
              + mass.dimension()
              + " rows; it must have "
              + problem.dimension()
              + ", one for each unknown");
    }
    this.problem = problem;
    this.mass = mass;
  }

  /** Returns the number of unknowns. */
  public int dimension() {
    return mass.dimension();
  }

  /** Returns the problem with another function around f; all parts and M are kept. */
  public MassProblem withFunction(UnaryOperator<OdeFunction> wrapper) {
    return new MassProblem(problem.withFunction(wrapper), mass);
  }

  /** Returns whether the explicit form has the structure of f. */
  boolean explicitKeepsStructure() {
    return mass.isDiagonal() && mass.factored().isPresent();
  }

  /**
   * Returns y' = M⁻¹ f(t, y), a workspace for one thread. Its band, pattern and Jacobian are those
   * of f if M is diagonal, else unknown.
   *
   * @throws IllegalArgumentException if M is singular
   */
  public OdeSystem explicit() {
    LinearSolver solver =
        mass.factored()
            .orElseThrow(
                () ->
                    new IllegalArgumentException(
                        "the mass matrix is singular, so that M y' = f(t, y) cannot be solved for"
                            + " y'; use OdeMethod.ODE15SR or AUTO"));
    return new ExplicitForm(problem, mass, solver);
  }

  /** Returns M y' − f(t, y) = 0, a workspace for one thread. */
  public ResidualSystem residual() {
    return new ResidualForm(problem, mass);
  }

  /** Returns y' at a state as far as M determines it: 0 where it does not. */
  double[] slope(double t, double[] y) {
    double[] slope = new double[y.length];
    problem.derivative(t, y, slope);
    Optional<LinearSolver> solver = mass.factored();
    if (solver.isPresent()) {
      solver.get().solve(slope);
      return slope;
    }
    for (int i = 0; i < slope.length; i++) {
      double pivot = mass.element(i, i);
      slope[i] = mass.isDiagonal() && pivot != 0 ? slope[i] / pivot : 0;
    }
    return slope;
  }

  /** y' = M⁻¹ f(t, y). */
  private static final class ExplicitForm implements OdeSystem {
    private final OdeProblem problem;
    private final MassMatrix mass;
    private final LinearSolver solver;

    ExplicitForm(OdeProblem problem, MassMatrix mass, LinearSolver solver) {
      this.problem = problem;
      this.mass = mass;
      this.solver = solver;
    }

    @Override
    public int dimension() {
      return problem.dimension();
    }

    @Override
    public void derivative(double t, double[] y, double[] yDot) {
      problem.derivative(t, y, yDot);
      solver.solve(yDot);
    }

    @Override
    public <T> Optional<T> part(Class<T> kind) {
      if (kind == JacobianSystem.class) {
        return mass.isDiagonal() ? scaled().map(kind::cast) : Optional.empty();
      }
      boolean structure =
          kind == BandedSystem.class || kind == BlockSystem.class || kind == SparseSystem.class;
      return structure && !mass.isDiagonal() ? Optional.empty() : problem.part(kind);
    }

    /** The Jacobian of f with its rows divided by the elements of M. */
    private Optional<JacobianSystem> scaled() {
      return problem
          .part(JacobianSystem.class)
          .map(known -> new OdeProblem.WithJacobian(this, scaled(known)));
    }

    private OdeProblem.Jacobian scaled(JacobianSystem known) {
      MatrixLayout layout = layoutOf(problem);
      return (t, y, fy) -> {
        known.jacobian(t, y, fy);
        for (int j = 0; j < layout.dimension(); j++) {
          for (int i = layout.firstRow(j); i <= layout.lastRow(j); i = layout.nextRow(i, j)) {
            fy[layout.index(i, j)] /= mass.element(i, i);
          }
        }
      };
    }
  }

  private static MatrixLayout layoutOf(OdeProblem problem) {
    return PartsOfProblem.layout(problem, problem.dimension());
  }

  /** M y' − f(t, y) = 0. */
  private static final class ResidualForm implements ResidualSystem {
    private final OdeProblem problem;
    private final MassMatrix mass;
    private final double[] f;

    ResidualForm(OdeProblem problem, MassMatrix mass) {
      this.problem = problem;
      this.mass = mass;
      f = new double[problem.dimension()];
    }

    @Override
    public int dimension() {
      return f.length;
    }

    @Override
    public void residual(double t, double[] y, double[] yDot, double[] residual) {
      problem.derivative(t, y, f);
      for (int i = 0; i < f.length; i++) {
        residual[i] = -f[i];
      }
      mass.addProduct(yDot, residual);
    }

    @Override
    public Component component(int index) {
      return mass.columnIsZero(index) ? Component.ALGEBRAIC : Component.DIFFERENTIAL;
    }

    @Override
    public <T> Optional<T> part(Class<T> kind) {
      if (kind == BandedSystem.class) {
        return band().map(kind::cast);
      }
      if (kind == SparseSystem.class) {
        return problem.part(SparseSystem.class).map(this::pattern).map(kind::cast);
      }
      if (kind == ResidualJacobianSystem.class) {
        return problem
            .part(JacobianSystem.class)
            .map(known -> kind.cast(new DaeProblem.WithJacobians(this, derivatives(known))));
      }
      boolean ofExplicitForm = kind == LinearisedSystem.class || kind == BlockSystem.class;
      return ofExplicitForm ? Optional.empty() : problem.part(kind);
    }

    private Optional<BandedSystem> band() {
      return mass.layout() instanceof BandLayout own
          ? problem.part(BandedSystem.class).map(ofFunction -> new Union(ofFunction, own))
          : Optional.empty();
    }

    private SparseSystem pattern(SparseSystem ofFunction) {
      MatrixLayout ofMass = mass.layout();
      return SparseSystem.byColumns(
          j -> {
            IntStream both = Arrays.stream(ofFunction.equations(j, f.length));
            IntStream own =
                IntStream.rangeClosed(ofMass.firstRow(j), ofMass.lastRow(j))
                    .filter(i -> mass.element(i, j) != 0);
            return IntStream.concat(both, own).toArray();
          });
    }

    /** ∂F/∂y = −∂f/∂y and ∂F/∂y' = M. */
    private DaeProblem.Jacobians derivatives(JacobianSystem known) {
      MatrixLayout layout = PartsOfProblem.layout(this, f.length);
      MatrixLayout ofFunction = layoutOf(problem);
      MatrixLayout ofMass = mass.layout();
      double[] jacobian = new double[ofFunction.length()];
      return (t, y, yDot, fy, fyDot) -> {
        Arrays.fill(jacobian, 0);
        known.jacobian(t, y, jacobian);
        for (int j = 0; j < f.length; j++) {
          for (int i = ofFunction.firstRow(j);
              i <= ofFunction.lastRow(j);
              i = ofFunction.nextRow(i, j)) {
            fy[layout.index(i, j)] = -jacobian[ofFunction.index(i, j)];
          }
          for (int i = ofMass.firstRow(j); i <= ofMass.lastRow(j); i = ofMass.nextRow(i, j)) {
            fyDot[layout.index(i, j)] = mass.element(i, j);
          }
        }
      };
    }
  }

  /** The band that holds both ∂f/∂y and M. */
  private record Union(BandedSystem ofFunction, BandLayout ofMass) implements BandedSystem {
    @Override
    public int lowerBandwidth() {
      return Math.max(ofFunction.lowerBandwidth(), ofMass.lower());
    }

    @Override
    public int upperBandwidth() {
      return Math.max(ofFunction.upperBandwidth(), ofMass.upper());
    }
  }
}
