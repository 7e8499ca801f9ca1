package org.mechservice.benchmarks.peer;

import org.mechservice.benchmarks.LinkChain;
import org.mechservice.benchmarks.Measured;
import org.mechservice.benchmarks.MeasuredScenes;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;

/** Forward dynamics of the models that other programs are measured with, see {@code peers}. */
@State(Scope.Thread)
public class PeerEvaluations extends Measured {
  /** The scene that is evaluated. */
  @Param({"pend5", "pend5s", "driver41", "spatial200", "driver", "fourbar"})
  public String scene = "";

  private ExplicitModel model = new DataDrivenModel(LinkChain.of(1), MeasuredScenes.SETTINGS);
  private double[] y = {};
  private double[] yDot = {};
  private double move = 1e-9;

  /** Generates and loads. */
  @Setup
  public void prepare() {
    MechmlModel named = MeasuredScenes.named(scene);
    model = (ExplicitModel) MeasuredScenes.generated(named, MeasuredScenes.forwardDynamics(named));
    y = new double[model.description().stateCount()];
    yDot = new double[y.length];
    model.initialState(y);
  }

  /** y' at another position in every call. */
  @Benchmark
  public double[] derivative() {
    y[0] += move;
    move = -move;
    model.derivative(0, y, yDot);
    return yDot;
  }
}
