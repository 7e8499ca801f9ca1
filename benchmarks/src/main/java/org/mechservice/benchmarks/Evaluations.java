package org.mechservice.benchmarks;

import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.mechservice.solver.dynamics.LinearisedResidualModel;
import org.mechservice.solver.dynamics.RecursiveResidualModel;
import org.mechservice.solver.dynamics.SemiRecursiveModel;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Mechanism;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;

/** One evaluation of the equations of motion in each formulation, driven by data. */
@State(Scope.Benchmark)
public class Evaluations extends Measured {
  private static final double H_GAMMA = 1e-3;

  /** The scene that is evaluated. */
  @Param({"pendulum", "driver", "chain200"})
  public String scene = "";

  private ExplicitModel articulated = articulated(LinkChain.of(1));
  private ExplicitModel semiRecursive = articulated;
  private LinearisedResidualModel linearised = MeasuredScenes.linearised(LinkChain.of(1));
  private RecursiveResidualModel residual = linearised;
  private double[] y = {};
  private double[] yDot = {};
  private double[] values = {};

  /** Prepares the models. */
  @Setup
  public void prepare() {
    Mechanism mechanism = MeasuredScenes.named(scene).mechanism();
    articulated = articulated(mechanism);
    semiRecursive =
        new SemiRecursiveModel(mechanism, MeasuredScenes.SETTINGS, UserForceSource.NONE);
    residual = new RecursiveResidualModel(mechanism, MeasuredScenes.SETTINGS, UserForceSource.NONE);
    linearised = MeasuredScenes.linearised(mechanism);
    y = new double[articulated.description().stateCount()];
    yDot = new double[y.length];
    values = new double[y.length];
    articulated.initialState(y);
    articulated.derivative(0, y, yDot);
    linearised.linearise(0, y, yDot);
    linearised.factor(H_GAMMA);
  }

  private static ExplicitModel articulated(Mechanism mechanism) {
    return new DataDrivenModel(mechanism, MeasuredScenes.SETTINGS);
  }

  /** y' by articulated bodies. */
  @Benchmark
  public double[] dtr() {
    articulated.derivative(0, y, values);
    return values;
  }

  /** y' by composite inertias. */
  @Benchmark
  public double[] dsr() {
    semiRecursive.derivative(0, y, values);
    return values;
  }

  /** The recursive residual. */
  @Benchmark
  public double[] rr() {
    residual.residual(0, y, yDot, values);
    return values;
  }

  /** The Jacobian of the residual. */
  @Benchmark
  public boolean jacobian() {
    return linearised.linearise(0, y, yDot);
  }

  /** The factors of the iteration matrix made of the last Jacobian. */
  @Benchmark
  public boolean factorisation() {
    return linearised.factor(H_GAMMA);
  }

  /** One iteration of an implicit step: the residual, and a solution with the factors. */
  @Benchmark
  public double[] iteration() {
    linearised.residual(0, y, yDot, values);
    linearised.solve(values);
    return values;
  }
}
