package org.mechservice.benchmarks;

import org.openjdk.jmh.profile.GCProfiler;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.CommandLineOptionException;
import org.openjdk.jmh.runner.options.CommandLineOptions;
import org.openjdk.jmh.runner.options.OptionsBuilder;

/**
 * Runs the benchmarks; {@code java -jar benchmarks/target/benchmarks.jar}, with the options of JMH.
 */
public final class Benchmarks {
  private Benchmarks() {}

  /**
   * Measures all benchmarks, or those that the arguments name, in one process each, and the memory
   * they take.
   *
   * @param args options of JMH; they go before the ones set here
   */
  public static void main(String[] args) throws RunnerException, CommandLineOptionException {
    new Runner(
            new OptionsBuilder()
                .parent(new CommandLineOptions(args))
                .addProfiler(GCProfiler.class)
                .build())
        .run();
  }
}
