package org.mechservice.sim.build;

import org.mechservice.mechml.MechmlModel;

/**
 * The way from a mechanism to code: generate, compile, pack. Thread-safe; every step is a pure
 * function of its arguments.
 */
public final class ModelFactory {
  private ModelFactory() {}

  /**
   * Writes the model class of a mechanism, specialised to it.
   *
   * @throws IllegalArgumentException if the formulation does not fit the scene; the message says
   *     why and which one does
   */
  public static GeneratedModel generate(MechmlModel model, BuildOptions options) {
    throw new UnsupportedOperationException();
  }

  /** Compiles a generated model in memory. */
  public static CompiledModel compile(
      MechmlModel model, BuildOptions options, GeneratedModel generated) {
    throw new UnsupportedOperationException();
  }

  /** Packs the model's own classes, description and manifest; it runs with {@link #runtimeJar}. */
  public static PackedJar modelJar(CompiledModel model, String mechmlSha256) {
    throw new UnsupportedOperationException();
  }

  /** Packs the model with just the solver classes it reaches; starts with {@code java -jar}. */
  public static PackedJar standaloneJar(CompiledModel model, String mechmlSha256) {
    throw new UnsupportedOperationException();
  }

  /** Returns the solver, packed once per process. */
  public static PackedJar runtimeJar() {
    throw new UnsupportedOperationException();
  }
}
