package org.mechservice.benchmarks;

import java.util.Objects;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.GeneratedModel;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.solver.api.Model;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;

/** The way from a mechanism to a model at work, in each formulation; microseconds. */
@State(Scope.Benchmark)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
public class ModelBuilding extends Measured {
  /** The scene that is built. */
  @Param({"pendulum", "driver"})
  public String scene = "";

  /** In which formulation. */
  @Param({"DTR", "DSR", "RR", "RR-JF"})
  public String formulation = "";

  private @Nullable MechmlModel model;
  private @Nullable BuildOptions options;
  private @Nullable GeneratedModel generated;

  /** Reads the scene and generates its code once. */
  @Setup
  public void prepare() {
    model = MeasuredScenes.named(scene);
    options = MeasuredScenes.options(formulation);
    generated = generation();
  }

  /** Derives the equations and plans their code. */
  @Benchmark
  public GeneratedModel generation() {
    return ModelFactory.generate(Objects.requireNonNull(model), Objects.requireNonNull(options));
  }

  /** Writes the class files, loads them and makes a model. */
  @Benchmark
  public Model compilation() {
    return ModelFactory.compile(
            Objects.requireNonNull(model),
            Objects.requireNonNull(options),
            Objects.requireNonNull(generated))
        .newInstance();
  }
}
