package org.mechservice.benchmarks;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.mechservice.library.MechModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.sim.compile.ReusedCode;
import org.mechservice.solver.api.ModelSource;
import org.mechservice.solver.api.TunableParameter;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.simulation.RuntimeSolver;
import org.mechservice.study.PointModel;
import org.mechservice.study.run.Study;
import org.mechservice.study.run.StudyPart;
import org.mechservice.study.run.StudyPlan;
import org.mechservice.study.run.StudyReader;

/**
 * Cost of the engine of a study beside the runs of its points: parts of a study in one thread, with
 * journal and table, against a bare loop over the generated model at the same points, which throws
 * the rows away. Both are measured in turns as processor time of the process, which has the
 * compiler's and the collector's in it; after a warm-up the median of the ratios counts.
 *
 * <p>Models with settled values are made by the bare loop as the study makes them; what that costs
 * is told apart.
 */
public final class StudyOverhead {
  private static final int ROUNDS = 9;
  private static final int WARM_UP = 3;

  private final StudyPlan plan;
  private final MechModel model;
  private final ReusedCode code = new ReusedCode();
  private long modelTime;

  private StudyOverhead(StudyPlan plan) {
    this.plan = plan;
    this.model = plan.model().model();
  }

  /**
   * Measures studies.
   *
   * @param arguments study files
   */
  public static void main(String[] arguments)
      throws IOException, MechmlException, InterruptedException {
    for (String file : arguments) {
      new StudyOverhead(StudyReader.read(Path.of(file))).measure(file);
    }
  }

  private void measure(String name) throws IOException, MechmlException, InterruptedException {
    int points = plan.model().tunable().size() == plan.factors().size() ? 8192 : 2048;
    double[] ratios = new double[ROUNDS];
    double[] bare = new double[ROUNDS];
    double[] making = new double[ROUNDS];
    for (int round = -WARM_UP; round < ROUNDS; round++) {
      int at = Math.max(round, 0);
      modelTime = 0;
      long begun = processorTime();
      loop(points);
      long between = processorTime();
      study(points, round + WARM_UP + 1);
      long ended = processorTime();
      bare[at] = (between - begun) * 1e-3 / points;
      making[at] = modelTime * 1e-3 / points;
      ratios[at] = (double) (ended - between) / (between - begun);
    }
    System.out.printf(
        Locale.ROOT,
        "%s: bare %.1f us a run, of which %.1f make its model; study %.3f of the bare loop (%.3f to"
            + " %.3f)%n",
        name,
        median(bare),
        median(making),
        median(ratios),
        Arrays.stream(ratios).min().orElseThrow(),
        Arrays.stream(ratios).max().orElseThrow());
  }

  private void study(int points, int part) throws IOException, InterruptedException {
    Path folder = Files.createTempDirectory("overhead");
    Path table = folder.resolve("table.csv");
    StudyPart some = StudyPart.parse(part + "/" + Math.max(1, plan.points() / points));
    new Study(plan, some, plan.model()).run(table, 1, (done, before, all) -> {});
    Files.delete(table);
    Files.delete(folder.resolve("table.study.json"));
    Files.delete(folder);
  }

  private void loop(int points) throws IOException, MechmlException {
    PointModel study = plan.model();
    RuntimeSolver solver = new RuntimeSolver();
    Nowhere nowhere = new Nowhere();
    ModelSource source = model.instances();
    RunRequest request = model.request();
    List<TunableParameter> inputs = source.parameters();
    for (int point = 0; point < points; point++) {
      double[] at = plan.design().point(point);
      Map<String, Double> settled = new HashMap<>();
      double[] values = new double[inputs.size()];
      for (int j = 0; j < at.length; j++) {
        String factor = plan.factors().get(j);
        if (!study.tunable().contains(factor)) {
          settled.put(factor, at[j]);
        }
        for (int i = 0; i < values.length; i++) {
          values[i] = inputs.get(i).name().equals(factor) ? at[j] : values[i];
        }
      }
      if (!settled.isEmpty()) {
        long begun = threadTime();
        MechModel made = model.set(settled);
        source = made.instances(code);
        request = made.request();
        modelTime += threadTime() - begun;
      }
      solver.run(source.model(values), request, nowhere, new RunControl());
    }
  }

  private static long threadTime() {
    return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
  }

  private static long processorTime() {
    return ((com.sun.management.OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean())
        .getProcessCpuTime();
  }

  private static double median(double[] values) {
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    return sorted[sorted.length / 2];
  }

  /** Takes rows and forgets them. */
  private static final class Nowhere implements ResultSink {
    @Override
    public void begin(List<Variable> columns) {
      // nothing is kept
    }

    @Override
    public void row(double[] row) {
      // nothing is kept
    }
  }
}
