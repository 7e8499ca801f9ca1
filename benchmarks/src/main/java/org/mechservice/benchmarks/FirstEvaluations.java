package org.mechservice.benchmarks;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneId;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.function.DoubleSupplier;
import java.util.stream.Collectors;
import org.apache.commons.math3.stat.StatUtils;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.compile.ModelCompiler;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.CompiledModel;
import org.mechservice.sim.model.GeneratedModel;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.solver.api.ModelSource;
import org.mechservice.solver.api.capability.ExplicitModel;

/**
 * Cost of the first evaluations in a fresh virtual machine, by generated code and from data, and
 * cost of generating and compiling the code. Every run is a process of its own.
 */
public final class FirstEvaluations {
  private static final List<String> SCENES = List.of("pend5", "pend5s", "driver41", "spatial200");
  private static final int[] COUNTS = {1, 100, 1_000, 3_000, 5_000, 10_000};
  private static final int RUNS = 5;
  private static final int COLD_RUNS = 15;
  private static final int WARM = 80;
  private static final double WARM_MILLIS = 20_000;

  private final List<String> page = new ArrayList<>();
  private final Path folder;

  private FirstEvaluations(Path folder) {
    this.folder = folder;
  }

  /**
   * Measures and writes a page; to be started in the folder of {@code mech}, from a JAR.
   *
   * @param args the page's file; in the processes that are started: what to do, and with what
   */
  public static void main(String[] args) throws IOException, ReflectiveOperationException {
    switch (args[0]) {
      case "evaluate" -> evaluate(args[1]);
      case "generate" -> System.out.println(bytes(MeasuredScenes.named(args[1])));
      case "generateWarm" -> generateWarm(args[1]);
      default -> {
        Path folder = Files.createTempDirectory("first-evaluations");
        FirstEvaluations all = new FirstEvaluations(folder);
        all.evaluations();
        all.generation();
        Files.write(Path.of(args[0]), all.page);
      }
    }
  }

  /** In a new process: loads a class and evaluates it, telling the time since its start. */
  private static void evaluate(String className) throws ReflectiveOperationException {
    long start = System.nanoTime();
    Object instance = Class.forName(className).getConstructor().newInstance();
    ExplicitModel model = (ExplicitModel) ModelSource.of(instance);
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
      times.append((System.nanoTime() - start) * 1e-6).append(' ');
    }
    System.out.println(times);
  }

  /** In a new process: generates and compiles again and again, by class bytes and by source. */
  private static void generateWarm(String scene) {
    MechmlModel model = MeasuredScenes.named(scene);
    double bytes = least(() -> bytes(model));
    double source = least(() -> source(model));
    System.out.println(bytes + " " + source);
  }

  private static double least(DoubleSupplier time) {
    double least = Double.POSITIVE_INFINITY;
    double all = 0;
    for (int i = 0; i < WARM && all < WARM_MILLIS; i++) {
      double one = time.getAsDouble();
      least = Math.min(least, one);
      all += one;
    }
    return least;
  }

  private static BuildOptions options(boolean compact) {
    return new BuildOptions("DTR", "auto", compact, Set.of(), MeasuredScenes.SETTINGS);
  }

  private static double bytes(MechmlModel model) {
    long start = System.nanoTime();
    BuildOptions options = options(false);
    ModelFactory.compile(model, options, ModelFactory.generate(model, options));
    return (System.nanoTime() - start) * 1e-6;
  }

  private static double source(MechmlModel model) {
    long start = System.nanoTime();
    GeneratedModel generated = ModelFactory.generate(model, options(false));
    ModelCompiler.compile(generated.sourceName(), generated.source(), Collections.emptySortedMap());
    return (System.nanoTime() - start) * 1e-6;
  }

  private void line(String format, Object... values) {
    page.add(values.length == 0 ? format : String.format(Locale.ROOT, format, values));
  }

  private void evaluations() throws IOException {
    line("# The first evaluations, and generation");
    line("");
    line(
        "Measured on %s by `FirstEvaluations` of [benchmarks](../../benchmarks/README.md): %s %s,"
            + " processors: %d, Java %s. Each run is a new process; the median of %d, ms.",
        LocalDate.now(ZoneId.systemDefault()),
        System.getProperty("os.name"),
        System.getProperty("os.arch"),
        Runtime.getRuntime().availableProcessors(),
        System.getProperty("java.version"),
        RUNS);
    line("");
    line("## From loading the class to so many evaluations of y' (DTR)");
    line("");
    String counts =
        Arrays.stream(COUNTS).mapToObj(Integer::toString).collect(Collectors.joining(" | "));
    line("| model | form | %s |", counts);
    line("|---|---|%s", "---:|".repeat(COUNTS.length));
    for (String scene : SCENES) {
      double[] generated = row(scene, "generated", false);
      double[] data = row(scene, "data", true);
      StringBuilder ratios = new StringBuilder();
      for (int i = 0; i < generated.length; i++) {
        ratios.append(String.format(Locale.ROOT, " %.2f |", generated[i] / data[i]));
      }
      line("| %s | generated / data |%s", scene, ratios);
    }
  }

  private double[] row(String scene, String form, boolean compact) throws IOException {
    BuildOptions options = options(compact);
    MechmlModel model = MeasuredScenes.named(scene);
    CompiledModel compiled =
        ModelFactory.compile(model, options, ModelFactory.generate(model, options));
    Path classes = Files.createTempDirectory(folder, scene);
    compiled.classFiles().forEach((name, bytes) -> write(classes, name, bytes));
    String path =
        classes + System.getProperty("path.separator") + System.getProperty("java.class.path");
    double[] times =
        medians(
            RUNS, List.of(), List.of("-cp", path), "evaluate", compiled.generated().className());
    line("| %s | %s | %s |", scene, form, numbers(times));
    return times;
  }

  private static void write(Path classes, String name, byte[] bytes) {
    Path file = classes.resolve(name.replace('.', '/') + ".class");
    try {
      Files.createDirectories(file.getParent());
      Files.write(file, bytes);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private void generation() throws IOException {
    line("");
    line("## Generation with compilation (DTR)");
    line("");
    line(
        "Cold: the first thing a process does; the median of %d processes on one processor, on two,"
            + " and on two as `mech` starts them, with its flags and an archive of loaded classes."
            + " Warm: the least of %d, or"
            + " of as many as %.0f s hold.",
        COLD_RUNS, WARM, WARM_MILLIS / 1000);
    line("");
    line(
        "| model | cold, one processor | cold, two | cold, as `mech` starts | class bytes, warm |"
            + " through source, warm |");
    line("|---|---:|---:|---:|---:|---:|");
    List<String> asMechStarts = asMechStarts();
    List<String> scenes = new ArrayList<>(SCENES);
    scenes.add("driver");
    for (String scene : scenes) {
      String[] generate = {"generate", scene};
      double[] warm = started(List.of("taskset", "-c", "0"), List.of(), "generateWarm", scene);
      line(
          "| %s | %s | %s | %s | %s |",
          scene,
          numbers(medians(COLD_RUNS, List.of("taskset", "-c", "0"), List.of(), generate)),
          numbers(medians(COLD_RUNS, List.of("taskset", "-c", "0,1"), List.of(), generate)),
          numbers(medians(COLD_RUNS, List.of("taskset", "-c", "0,1"), asMechStarts, generate)),
          numbers(warm));
    }
  }

  /** Makes an archive of what generation loads and returns the flags to start with it. */
  private List<String> asMechStarts() throws IOException {
    String script = Files.readString(Path.of("mech"));
    int flags = script.indexOf("swift='") + "swift='".length();
    List<String> swift =
        List.of(script.substring(flags, script.indexOf('\'', flags)).strip().split("\\s+", -1));
    Path classes = folder.resolve("classes");
    Path archive = folder.resolve("archive.jsa");
    List<String> train = new ArrayList<>(swift);
    train.add("-XX:DumpLoadedClassList=" + classes);
    started(List.of(), train, "generate", "driver");
    List<String> dump =
        List.of(
            "-Xshare:dump",
            "-Xlog:disable",
            "-XX:SharedClassListFile=" + classes,
            "-XX:SharedArchiveFile=" + archive);
    run(List.of(), dump);
    if (!Files.exists(archive)) {
      throw new IOException("no archive of classes: start this from benchmarks.jar");
    }
    List<String> all = new ArrayList<>(swift);
    all.add("-XX:SharedArchiveFile=" + archive);
    return all;
  }

  private static String numbers(double[] times) {
    return Arrays.stream(times)
        .mapToObj(time -> String.format(Locale.ROOT, "%.1f", time))
        .collect(Collectors.joining(" | "));
  }

  private static double[] medians(
      int count, List<String> launcher, List<String> flags, String... what) throws IOException {
    List<double[]> runs = new ArrayList<>();
    for (int run = 0; run < count; run++) {
      runs.add(started(launcher, flags, what));
    }
    double[] medians = new double[runs.get(0).length];
    for (int i = 0; i < medians.length; i++) {
      int column = i;
      medians[i] =
          StatUtils.percentile(runs.stream().mapToDouble(run -> run[column]).toArray(), 50);
    }
    return medians;
  }

  /** Starts this class in a process of its own and returns the numbers it tells. */
  private static double[] started(List<String> launcher, List<String> flags, String... what)
      throws IOException {
    List<String> all = new ArrayList<>(flags);
    all.add(FirstEvaluations.class.getName());
    all.addAll(List.of(what));
    String told = run(launcher, all);
    if (told.isBlank()) {
      throw new IOException(String.join(" ", what) + " told nothing");
    }
    return Arrays.stream(told.strip().split(" ", -1)).mapToDouble(Double::parseDouble).toArray();
  }

  private static String run(List<String> launcher, List<String> arguments) throws IOException {
    List<String> command = new ArrayList<>(launcher);
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    if (!arguments.contains("-cp")) {
      command.addAll(List.of("-cp", System.getProperty("java.class.path")));
    }
    command.addAll(arguments);
    Process process =
        new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.INHERIT).start();
    return new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
  }
}
