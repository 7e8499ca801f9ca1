package org.mechservice.benchmarks;

import java.util.concurrent.TimeUnit;
import org.mechservice.mechml.MechmlModel;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;

/** Reading and checking a MechML file; microseconds. */
@State(Scope.Benchmark)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
public class ModelReading extends Measured {
  /** The scene that is read. */
  @Param({"pendulum", "driver"})
  public String scene = "";

  /** From bytes to a checked mechanism. */
  @Benchmark
  public MechmlModel reading() {
    return MeasuredScenes.named(scene);
  }
}
