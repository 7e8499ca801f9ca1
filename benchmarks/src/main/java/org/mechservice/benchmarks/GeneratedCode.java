package org.mechservice.benchmarks;

import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ResidualModel;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;

/** One evaluation of the code generated for a scene, in each formulation. */
@State(Scope.Benchmark)
public class GeneratedCode extends Measured {
  /** The scene that is evaluated. */
  @Param({"pendulum", "driver"})
  public String scene = "";

  /** In which formulation. */
  @Param({"DTR", "DSR", "RR", "RR-JF"})
  public String formulation = "";

  private @Nullable ExplicitModel rates;
  private @Nullable ResidualModel residuals;
  private double[] y = {};
  private double[] yDot = {};
  private double[] values = {};

  /** Generates, writes and loads the class. */
  @Setup
  public void prepare() {
    ExplicitModel made =
        (ExplicitModel) MeasuredScenes.generated(MeasuredScenes.named(scene), formulation);
    y = new double[made.description().stateCount()];
    yDot = new double[y.length];
    values = new double[y.length];
    made.initialState(y);
    made.derivative(0, y, yDot);
    rates = made;
    residuals = formulation.startsWith("RR") ? (ResidualModel) made : null;
  }

  /** Evaluates y' in DTR and DSR, the residual in RR and RR-JF. */
  @Benchmark
  public double[] evaluation() {
    if (residuals == null) {
      Objects.requireNonNull(rates).derivative(0, y, values);
    } else {
      residuals.residual(0, y, yDot, values);
    }
    return values;
  }
}
