package org.mechservice.sim.fmu;

import java.io.IOException;

/**
 * A model as a WebAssembly module, which needs nothing around it: its equations, events and
 * integrator, and functions to set parameters and start values, to run it and to read its rows
 * ({@code mech_wasm.c}).
 */
public final class WebAssemblyModule {
  private WebAssemblyModule() {}

  /**
   * Compiles a module.
   *
   * @throws IllegalArgumentException if this machine has no compiler for WebAssembly; the message
   *     says which there are
   * @throws IOException if the compiler fails; the message has its words
   */
  public static byte[] of(FmuModel model) throws IOException {
    CCompiler compiler =
        CCompiler.forWebAssembly()
            .orElseThrow(
                () ->
                    new IllegalArgumentException(
                        "no compiler for WebAssembly: install clang with lld (both on the path as"
                            + " clang and wasm-ld), or zig (pip install ziglang)"));
    return compiler.compile(FmuSources.ofModule(model));
  }
}
