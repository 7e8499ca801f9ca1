package org.mechservice.benchmarks.peer;

import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.mechservice.benchmarks.Measured;
import org.mechservice.benchmarks.MeasuredScenes;
import org.mechservice.solver.dynamics.TreeStepModel;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;

/** Derivatives of inverse dynamics, of the models that other programs are measured with. */
@State(Scope.Thread)
public class PeerJacobians extends Measured {
  /** The scene that is evaluated. */
  @Param({"pend5", "pend5s", "driver41"})
  public String scene = "";

  private @Nullable TreeStepModel model;
  private double[] y = {};
  private double[] yDot = {};
  private double[] values = {};
  private double move = 1e-9;

  /** Generates and loads. */
  @Setup
  public void prepare() {
    TreeStepModel made =
        (TreeStepModel) MeasuredScenes.generated(MeasuredScenes.named(scene), "RR-JF");
    int states = made.description().stateCount();
    y = new double[states];
    yDot = new double[states];
    values = new double[2 * states * states];
    made.initialState(y);
    made.derivative(0, y, yDot);
    model = made;
  }

  /** M and the derivatives by v and q, at another position in every call. */
  @Benchmark
  public double[] derivatives() {
    y[0] += move;
    move = -move;
    Objects.requireNonNull(model).derivatives(0, y, yDot, values);
    return values;
  }
}
