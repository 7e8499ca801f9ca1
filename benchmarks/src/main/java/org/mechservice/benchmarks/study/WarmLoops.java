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
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelSource;
import org.mechservice.solver.api.program.RowMemory;
import org.mechservice.solver.api.program.Trajectory;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.simulation.RuntimeSolver;

/**
 * Measures mechanisms with loops in a process that has run them before, as a study or an
 * optimisation does: processor time of the thread, medians. Called by benchmarks/peers/loops.py.
 */
public final class WarmLoops {
  /** Processor time that warms a model up before its first tolerance, s. */
  private static final double FIRST_WARM_UP = 3;

  /** Processor time that warms up before its other tolerances, s. */
  private static final double WARM_UP = 1;

  /** Processor time that is measured, s. */
  private static final double MEASURED = 0.5;

  private static final int LEAST_RUNS = 3;

  private WarmLoops() {}

  /**
   * Prints a line for each file and tolerance: s of the set-up from the file to an instance that
   * can run, s of a run, and the value of a column at the end.
   *
   * @param args the column's name, relative tolerances with commas between, and MechML files;
   *     absolute tolerances are a hundredth
   */
  public static void main(String[] args) throws IOException, MechmlException {
    for (int i = 2; i < args.length; i++) {
      double warmUp = FIRST_WARM_UP;
      for (String tolerance : args[1].split(",", -1)) {
        measure(Path.of(args[i]), args[0], Double.parseDouble(tolerance), warmUp);
        warmUp = WARM_UP;
      }
    }
  }

  private static void measure(Path file, String column, double relative, double warmUp)
      throws IOException, MechmlException {
    MechModel model = read(file, relative);
    ModelSource source = model.instances();
    RuntimeSolver solver = new RuntimeSolver();
    List<Double> instances = new ArrayList<>();
    List<Double> runs = new ArrayList<>();
    double end = 0;
    for (double first = seconds(), now = first;
        now - first < warmUp + MEASURED || runs.size() < LEAST_RUNS; ) {
      if (now - first < warmUp) {
        instances.clear();
        runs.clear();
      }
      Model instance = source.model();
      double made = seconds();
      RowMemory rows = new RowMemory();
      RunReport report = solver.run(instance, model.request(), rows, new RunControl());
      double ended = seconds();
      double[] values = new Trajectory(rows, report).column(column);
      end = values[values.length - 1];
      instances.add(made - now);
      runs.add(ended - made);
      now = seconds();
    }
    List<Double> readings = new ArrayList<>();
    for (double first = seconds(), now = first;
        now - first < MEASURED || readings.size() < LEAST_RUNS; ) {
      read(file, relative).instances();
      double then = seconds();
      readings.add(then - now);
      now = then;
    }
    System.out.println(
        String.format(
            Locale.ROOT,
            "%.6f %.6f %.17g",
            median(readings) + median(instances),
            median(runs),
            end));
  }

  private static MechModel read(Path file, double relative) throws IOException, MechmlException {
    return MechModel.read(file).tolerances(relative, relative / 100);
  }

  private static double median(List<Double> times) {
    return Quantiles.median(times.stream().mapToDouble(Double::doubleValue).toArray());
  }

  private static double seconds() {
    return 1e-9 * ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
  }
}
