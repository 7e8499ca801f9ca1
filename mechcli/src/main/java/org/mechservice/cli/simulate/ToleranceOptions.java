package org.mechservice.cli.simulate;

import java.util.Optional;
import org.mechservice.client.SimulationOptions;
import picocli.CommandLine.Option;

/** Tolerances, interval and steps of a run. */
public final class ToleranceOptions {
  @Option(
      names = "--rtol",
      paramLabel = "R",
      description = "Relative tolerance (default: the file's).")
  private Optional<Double> relativeTolerance = Optional.empty();

  @Option(
      names = "--atol",
      paramLabel = "A",
      description =
          "Absolute tolerance, SI: one, or four A;B;C;D for positions, angles, velocities, angular"
              + " velocities (default: the file's).")
  private Optional<String> absoluteTolerance = Optional.empty();

  @Option(
      names = "--accuracy",
      paramLabel = "standard|strict",
      hideParamSyntax = true,
      description =
          "Accuracy: standard, or strict, which makes errors smaller at the same tolerances"
              + " (default: the file's).")
  private Optional<String> accuracy = Optional.empty();

  @Option(
      names = "--t-end",
      paramLabel = "T",
      description = "End of the run, s (default: the file's).")
  private Optional<Double> endTime = Optional.empty();

  @Option(
      names = "--t-step",
      paramLabel = "H",
      description = "Distance of the rows, s (default: the file's).")
  private Optional<Double> outputStep = Optional.empty();

  /** Returns the distance of the rows, s; empty if it is left to the file. */
  Optional<Double> outputStep() {
    return outputStep;
  }

  /** Returns the options given with these added. */
  public SimulationOptions addTo(SimulationOptions options) {
    SimulationOptions all = relativeTolerance.map(options::relativeTolerance).orElse(options);
    all = absoluteTolerance.map(all::absoluteTolerances).orElse(all);
    all = accuracy.map(all::accuracy).orElse(all);
    all = endTime.map(all::endTime).orElse(all);
    return outputStep.map(all::outputStep).orElse(all);
  }
}
