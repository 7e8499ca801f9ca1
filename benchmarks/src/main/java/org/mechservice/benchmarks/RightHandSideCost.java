package org.mechservice.benchmarks;

import org.mechservice.solver.ode.suite.SuiteProblem;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;

/** One evaluation of the right-hand side of a problem of {@link StepOverhead}. */
@State(Scope.Benchmark)
public class RightHandSideCost extends Measured {
  /** Name of a problem of the suite. */
  @Param({"VanDerPol", "EulerRigidBody", "Kepler", "Hires"})
  public String problem = "";

  private SuiteProblem equations = SuiteProblem.named("VanDerPol");
  private double[] y = {};
  private double[] yDot = {};

  /** Prepares an evaluation. */
  @Setup
  public void prepare() {
    equations = SuiteProblem.named(problem);
    y = equations.reference().atCheckpoint().clone();
    yDot = new double[y.length];
  }

  /** Evaluates f. */
  @Benchmark
  public double[] evaluate() {
    equations.derivative(0, y, yDot);
    return yDot;
  }
}
