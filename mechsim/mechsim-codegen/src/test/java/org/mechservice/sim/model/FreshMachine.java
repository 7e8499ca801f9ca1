package org.mechservice.sim.model;

import com.sun.management.OperatingSystemMXBean;
import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import org.mechservice.solver.api.ModelSource;
import org.mechservice.solver.api.capability.ExplicitModel;

/** Evaluates a model in a virtual machine that has done nothing else. */
public final class FreshMachine {
  private static final int[] COUNTS = {1_000, 10_000};

  private FreshMachine() {}

  /**
   * Returns the processor time of the first 1 000 and 10 000 evaluations with loading the model,
   * ms, that of compilers included: what one core takes.
   *
   * @param folder is filled with the model's classes
   */
  public static double[] firstEvaluations(CompiledModel model, Path folder) throws IOException {
    for (Map.Entry<String, byte[]> file : model.classFiles().entrySet()) {
      Path path = folder.resolve(file.getKey().replace('.', '/') + ".class");
      Files.createDirectories(path.resolveSibling("."));
      Files.write(path, file.getValue());
    }
    String classPath = folder + File.pathSeparator + System.getProperty("java.class.path");
    Process process =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:+UseSerialGC",
                "-cp",
                classPath,
                FreshMachine.class.getName(),
                model.generated().className())
            .redirectErrorStream(true)
            .start();
    try (BufferedReader output = process.inputReader(StandardCharsets.US_ASCII)) {
      String[] times = output.readLine().split(" ", -1);
      return new double[] {Double.parseDouble(times[0]), Double.parseDouble(times[1])};
    }
  }

  /**
   * In the new machine: loads a model and evaluates it.
   *
   * @param args its class
   */
  public static void main(String[] args) throws ReflectiveOperationException {
    OperatingSystemMXBean machine =
        (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
    long start = machine.getProcessCpuTime();
    Object instance = Class.forName(args[0]).getConstructor().newInstance();
    ExplicitModel model = (ExplicitModel) ModelSource.from(instance).model();
    double[] y = new double[model.description().stateCount()];
    double[] yDot = new double[y.length];
    model.initialState(y);
    StringBuilder times = new StringBuilder();
    int done = 0;
    for (int count : COUNTS) {
      for (; done < count; done++) {
        y[0] += 1e-9;
        model.derivative(0, y, yDot);
      }
      double millis = (machine.getProcessCpuTime() - start) * 1e-6;
      times.append(String.format(Locale.ROOT, "%.0f ", millis));
    }
    System.out.println(times.toString().strip());
  }
}
