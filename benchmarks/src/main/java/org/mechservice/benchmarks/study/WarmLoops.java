package org.mechservice.benchmarks.study;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.mechservice.library.MechModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.report.measure.Quantiles;
import org.mechservice.solver.api.program.Trajectory;

/**
 * What mechanisms with loops cost in a process that has run them before, as in a study or an
 * optimisation: processor time of the thread, medians. Called by benchmarks/peers/loops.py.
 */
public final class WarmLoops {
  /** Processor time that warms up, s. */
  private static final double WARM_UP = 1;

  /** Processor time that is measured, s. */
  private static final double MEASURED = 0.5;

  private static final int LEAST_RUNS = 3;

  private WarmLoops() {}

  /**
   * Prints a line for each file and tolerance: s of the set-up from the file to a compiled model, s
   * of a run that begins with closing the loops at the start, evaluations, and the value of a
   * column at the end.
   *
   * @param args the column's name, relative tolerances with commas between, and MechML files;
   *     absolute tolerances are a hundredth
   */
  public static void main(String[] args) throws IOException, MechmlException {
    for (int i = 2; i < args.length; i++) {
      for (String tolerance : args[1].split(",")) {
        double relative = Double.parseDouble(tolerance);
        measure(Path.of(args[i]), args[0], relative);
      }
    }
  }

  private static void measure(Path file, String column, double relative)
      throws IOException, MechmlException {
    MechModel model = read(file, relative);
    Trajectory last = model.simulate();
    for (double spent = 0; spent < WARM_UP; ) {
      double begun = seconds();
      last = model.simulate();
      spent += seconds() - begun;
    }
    double[] run = times(model::simulate);
    double[] values = last.column(column);
    System.out.println(
        String.format(
            Locale.ROOT,
            "%.6f %.6f %d %.17g",
            Quantiles.median(times(() -> read(file, relative))),
            Quantiles.median(run),
            last.report().evaluations(),
            values[values.length - 1]));
  }

  /** Reads a model, and generates and compiles its code. */
  private static MechModel read(Path file, double relative) throws IOException, MechmlException {
    MechModel model = MechModel.read(file).tolerances(relative, relative / 100);
    model.instances();
    return model;
  }

  /** What is timed. */
  private interface Timed {
    void call() throws IOException, MechmlException;
  }

  private static double[] times(Timed timed) throws IOException, MechmlException {
    List<Double> times = new ArrayList<>();
    double begun = seconds();
    double now = begun;
    while (now - begun < MEASURED || times.size() < LEAST_RUNS) {
      timed.call();
      double then = seconds();
      times.add(then - now);
      now = then;
    }
    return times.stream().mapToDouble(Double::doubleValue).toArray();
  }

  private static double seconds() {
    return 1e-9 * ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
  }
}
