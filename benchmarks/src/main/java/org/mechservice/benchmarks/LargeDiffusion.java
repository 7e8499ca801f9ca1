package org.mechservice.benchmarks;

import java.io.BufferedOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.stream.IntStream;
import org.mechservice.solver.ode.solve.Ode;
import org.mechservice.solver.ode.solve.OdeMethod;
import org.mechservice.solver.ode.solve.OdeOptions;
import org.mechservice.solver.ode.solve.OdeProblem;
import org.mechservice.solver.ode.solve.OdeSolution;

/**
 * Diffusion with reaction on a square plate with cold edges, u_t = 0.1 (u_xx + u_yy) + u (1 - u),
 * by ode15s with differenced sparse Jacobians; {@code benchmarks/peers/diffusion.py} runs it beside
 * CVODE.
 */
public final class LargeDiffusion {
  private static final double DIFFUSIVITY = 0.1;
  private static final double END = 0.5;

  private LargeDiffusion() {}

  /**
   * Runs once from a cold start; prints seconds of the clock, seconds of the processor,
   * evaluations, steps and factorisations.
   *
   * @param args points along an edge, tolerance, file for the state at the end: doubles, big-endian
   */
  public static void main(String[] args) throws IOException {
    int m = Integer.parseInt(args[0]);
    double tolerance = Double.parseDouble(args[1]);
    OdeOptions options =
        OdeOptions.standard()
            .rtol(tolerance)
            .atol(tolerance)
            .method(OdeMethod.ODE15S)
            .keepSteps(false);
    long begin = System.nanoTime();
    OdeSolution solution = Ode.solve(plate(m), 0, bump(m), END, options);
    double seconds = 1e-9 * (System.nanoTime() - begin);
    double processor =
        1e-9 * ProcessHandle.current().info().totalCpuDuration().orElseThrow().toNanos();
    System.out.printf(
        Locale.ROOT,
        "%.3f %.3f %d %d %d%n",
        seconds,
        processor,
        solution.statistics().evaluations(),
        solution.statistics().steps(),
        solution.statistics().factorisations());
    try (DataOutputStream out =
        new DataOutputStream(new BufferedOutputStream(Files.newOutputStream(Path.of(args[2]))))) {
      for (double u : solution.endState()) {
        out.writeDouble(u);
      }
    }
  }

  private static OdeProblem plate(int m) {
    double rate = DIFFUSIVITY * (m + 1) * (m + 1);
    return Ode.system(
            m * m,
            (t, u, uDot) -> {
              for (int k = 0; k < m * m; k++) {
                double flow =
                    (k < m ? 0 : u[k - m])
                        + (k >= m * m - m ? 0 : u[k + m])
                        + (k % m == 0 ? 0 : u[k - 1])
                        + (k % m == m - 1 ? 0 : u[k + 1])
                        - 4 * u[k];
                uDot[k] = rate * flow + u[k] * (1 - u[k]);
              }
            })
        .withPatternByColumns(
            k ->
                IntStream.of(k - m, k - 1, k, k + 1, k + m)
                    .filter(i -> i >= 0 && i < m * m && (i % m == k % m || i / m == k / m))
                    .toArray());
  }

  private static double[] bump(int m) {
    return IntStream.range(0, m * m)
        .mapToDouble(k -> 16 * hump(k % m, m) * hump(Math.floorDiv(k, m), m))
        .toArray();
  }

  private static double hump(int point, int m) {
    double x = (point + 1.0) / (m + 1);
    return x * (1 - x);
  }
}
