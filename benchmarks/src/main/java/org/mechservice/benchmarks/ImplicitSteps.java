package org.mechservice.benchmarks;

import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.LinearisedModel;
import org.mechservice.solver.linear.DenseLu;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;

/**
 * Cost of implicit steps of generated code besides evaluations: Jacobian and factorisation along
 * the tree in RR-JF, and by differences of y' and in a dense matrix, as DTR and DSR have them.
 */
@State(Scope.Benchmark)
public class ImplicitSteps extends Measured {
  private static final double H_GAMMA = 1e-3;

  /** Relative size of a difference. */
  private static final double STEP = 1e-7;

  /** The scene that is evaluated. */
  @Param({"pendulum", "driver"})
  public String scene = "";

  private @Nullable LinearisedModel along;
  private @Nullable ExplicitModel rates;
  private @Nullable DenseLu dense;
  private double[] y = {};
  private double[] yDot = {};
  private double[] moved = {};
  private double[] jacobian = {};
  private double[] matrix = {};

  /** Generates, writes and loads the classes, and forms what the factorisations start from. */
  @Setup
  public void prepare() {
    LinearisedModel linearised =
        (LinearisedModel) MeasuredScenes.generated(MeasuredScenes.named(scene), "RR-JF");
    ExplicitModel explicit =
        (ExplicitModel) MeasuredScenes.generated(MeasuredScenes.named(scene), "DTR");
    int n = explicit.description().stateCount();
    y = new double[n];
    yDot = new double[n];
    moved = new double[n];
    jacobian = new double[n * n];
    matrix = new double[n * n];
    explicit.initialState(y);
    explicit.derivative(0, y, yDot);
    along = linearised;
    rates = explicit;
    dense = new DenseLu(n);
    jacobianAlongTheTree();
    jacobianByDifferences();
    for (int i = 0; i < n * n; i++) {
      matrix[i] = (i % (n + 1) == 0 ? 1 : 0) - H_GAMMA * jacobian[i];
    }
  }

  /** M and the derivatives of the residual. */
  @Benchmark
  public boolean jacobianAlongTheTree() {
    return Objects.requireNonNull(along).linearise(0, y, yDot);
  }

  /** The factors of the iteration matrix that the last Jacobian gives. */
  @Benchmark
  public boolean factorsAlongTheTree() {
    return Objects.requireNonNull(along).factor(H_GAMMA);
  }

  /** ∂f/∂y, one evaluation of y' by DTR for each state. */
  @Benchmark
  public double[] jacobianByDifferences() {
    ExplicitModel model = Objects.requireNonNull(rates);
    int n = y.length;
    for (int column = 0; column < n; column++) {
      double kept = y[column];
      double step = STEP * (1 + Math.abs(kept));
      y[column] = kept + step;
      model.derivative(0, y, moved);
      y[column] = kept;
      for (int row = 0; row < n; row++) {
        jacobian[row * n + column] = (moved[row] - yDot[row]) / step;
      }
    }
    return jacobian;
  }

  /** The factors of 1 − hγ ∂f/∂y as a dense matrix. */
  @Benchmark
  public int factorsOfDenseMatrix() {
    return Objects.requireNonNull(dense).factor(matrix);
  }
}
