package org.mechservice.benchmarks;

import org.mechservice.solver.api.ExplicitModel;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;

/** One evaluation of y' by the code generated for a scene. */
@State(Scope.Benchmark)
public class GeneratedCode extends Measured {
  /** What is evaluated. */
  @Param({"pendulum", "driver"})
  public String scene = "";

  private ExplicitModel model = new DataDrivenModel(LinkChain.of(1), Scenes.SETTINGS);
  private double[] y = {};
  private double[] yDot = {};

  /** Generates, compiles and loads. */
  @Setup
  public void prepare() {
    model = (ExplicitModel) Scenes.generated(Scenes.named(scene));
    y = new double[model.description().stateCount()];
    yDot = new double[y.length];
    model.initialState(y);
  }

  /** Evaluates y'. */
  @Benchmark
  public double[] derivative() {
    model.derivative(0, y, yDot);
    return yDot;
  }
}
