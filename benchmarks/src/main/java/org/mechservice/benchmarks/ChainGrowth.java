package org.mechservice.benchmarks;

import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.mechservice.solver.mechanism.Mechanism;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;

/**
 * y' of chains, and of trees with oblique axes, by articulated bodies: the time must grow as the
 * number of links does.
 */
@State(Scope.Benchmark)
public class ChainGrowth extends Measured {
  /** Length of the chain. */
  @Param({"10", "30", "100", "300", "1000"})
  public int links;

  /** Whether the links form a chain, or a tree of turning and sliding joints with oblique axes. */
  @Param({"chain", "tree"})
  public String shape = "";

  private ExplicitModel model = new DataDrivenModel(LinkChain.of(1), MeasuredScenes.SETTINGS);
  private double[] y = {};
  private double[] yDot = {};

  /** Builds the chain. */
  @Setup
  public void prepare() {
    Mechanism mechanism = shape.equals("tree") ? LinkChain.tree(links) : LinkChain.of(links);
    model = new DataDrivenModel(mechanism, MeasuredScenes.SETTINGS);
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
