package org.mechservice.library.proof;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.ByteBuffer;
import java.nio.DoubleBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.mechservice.guard.UserCode;
import org.mechservice.library.MechModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.api.program.RunFailedException;
import org.mechservice.solver.api.program.Trajectory;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunSettings;

/**
 * The bits of all example scenes, run with every formulation, integrator and closure that fits,
 * before and after a change.
 *
 * <ul>
 *   <li>{@code ExampleDigests FOLDER FILE} runs the scenes of a folder and writes a line for each
 *       run: its name, the SHA-256 of its rows, the tolerance of each column, and some of its rows.
 *       {@code ExampleDigests FOLDER FILE BEFORE} ends each scene where the other file ends it.
 *   <li>{@code ExampleDigests FOLDER FILE BEFORE AFTER PART} runs again, with a part of their
 *       tolerances, the runs that differ in two such files. A tenth of them shows how far the
 *       tolerances determine a result; 0.999 of them shows what other steps of the same size do to
 *       it.
 *   <li>{@code ExampleDigests BEFORE AFTER} compares two files and prints the runs that differ,
 *       with the largest difference of a value of their last row in tolerances: the relative one
 *       times the largest value of the column, and the absolute one. {@code ExampleDigests BEFORE
 *       AFTER FINER} prints beside it what is different with a tenth of the tolerances.
 * </ul>
 *
 * <p>All runs of a scene end at one time, so that their rows can be compared: its own settings take
 * it there in at most {@value #STEPS} steps, fewer of more than {@value #JOINTS} joints, and the
 * distance of its rows is a power of two times smaller or greater, so that it is the same after a
 * change of last bits. A run of {@value #TIMES} times as many steps is given up. Of scenes of more
 * than {@value #DIFFERENCES} joints the runs that need Jacobians by differences are left out.
 */
final class ExampleDigests {
  private static final int STEPS = 1000;
  private static final int JOINTS = 10;
  private static final int TIMES = 20;

  /** Joints above which a Jacobian by differences takes minutes. */
  private static final int DIFFERENCES = 200;

  private static final List<String> FORMULATIONS = List.of("", "DTR", "DSR", "RR", "RR-JF");
  private static final List<String> INTEGRATORS = List.of("", "ode113", "DE", "ode15s", "ode15sR");
  private static final List<String> CLOSURES = List.of("", "projection", "penalty");

  /** Reads a model; the classes of the examples are our own. */
  private static MechModel read(Path file) throws IOException, MechmlException {
    return MechModel.read(file, UserCode.in(file.resolveSibling("").toAbsolutePath()).unconfined());
  }

  /** One run: what its line says. */
  private record Run(String digest, List<Double> tolerances, List<List<Double>> rows) {
    static final Run MISSING = new Run("missing", List.of(), List.of());

    static Run of(String line) {
      String[] words = line.split("\t", -1);
      List<List<Double>> rows = new ArrayList<>();
      for (int i = 3; i < words.length; i++) {
        rows.add(numbers(words[i]));
      }
      return new Run(words[1], words.length > 2 ? numbers(words[2]) : List.of(), rows);
    }

    private static List<Double> numbers(String words) {
      return Stream.of(words.split(" ", -1)).skip(1).map(Double::valueOf).toList();
    }

    List<Double> last() {
      return rows.get(rows.size() - 1);
    }
  }

  private ExampleDigests() {}

  public static void main(String[] arguments) throws Exception {
    Path first = Path.of(arguments[0]);
    Path second = Path.of(arguments[1]);
    if (!Files.isDirectory(first)) {
      Map<String, Run> others = arguments.length > 2 ? lines(Path.of(arguments[2])) : Map.of();
      compare(lines(first), lines(second), others);
      return;
    }
    Map<String, Run> before = arguments.length > 2 ? lines(Path.of(arguments[2])) : Map.of();
    try (PrintStream out = new PrintStream(second.toFile(), StandardCharsets.UTF_8)) {
      if (arguments.length > 3) {
        Map<String, Run> after = lines(Path.of(arguments[3]));
        before.forEach(
            (name, run) -> {
              if (differ(run, after.getOrDefault(name, Run.MISSING)) && !run.rows().isEmpty()) {
                out.println(
                    name
                        + "\t"
                        + again(first, name, run.last().get(0), Double.parseDouble(arguments[4])));
                out.flush();
              }
            });
        return;
      }
      for (Path file : scenes(first)) {
        runs(first, file, before, out);
      }
    }
  }

  private static List<Path> scenes(Path folder) throws IOException {
    try (Stream<Path> files = Files.walk(folder)) {
      return files
          .filter(file -> file.toString().endsWith(".xml") && !file.toString().contains("target"))
          .sorted()
          .toList();
    }
  }

  private static void runs(Path folder, Path file, Map<String, Run> before, PrintStream out) {
    MechModel model;
    try {
      model = read(file);
    } catch (IOException | MechmlException | IllegalArgumentException e) {
      out.println(folder.relativize(file) + "\tno model");
      return;
    }
    Run known = before.getOrDefault(folder.relativize(file) + " file file file", Run.MISSING);
    MechModel ending = model.until(known.rows().isEmpty() ? end(model) : known.last().get(0));
    boolean large = model.content().mechanism().joints().size() > DIFFERENCES;
    boolean loops = !model.content().mechanism().closures().isEmpty();
    for (String closure : loops ? CLOSURES : List.of("")) {
      for (String formulation : FORMULATIONS) {
        for (String integrator : INTEGRATORS) {
          boolean differences = formulation.startsWith("D") && integrator.startsWith("ode15");
          if (formulation.isEmpty() != integrator.isEmpty() || (large && differences)) {
            continue;
          }
          String name =
              Stream.of(folder.relativize(file).toString(), formulation, integrator, closure)
                  .map(word -> word.isEmpty() ? "file" : word)
                  .collect(Collectors.joining(" "));
          out.println(name + "\t" + result(ending, formulation, integrator, closure));
          out.flush();
        }
      }
    }
  }

  /** Returns the time at which all runs of a scene end, s. */
  private static double end(MechModel model) {
    RunSettings run = model.content().settings().run();
    FirstSteps control = new FirstSteps(model, 1);
    try {
      model.simulate(control);
    } catch (RunFailedException | IllegalArgumentException e) {
      // what its own settings cannot run is run to where they came
    }
    double reached = control.time() - run.tStart();
    if (!(reached > 0) || control.time() >= run.tEnd()) {
      return run.tEnd();
    }
    double ends = run.tStep();
    while (ends > reached) {
      ends /= 2;
    }
    while (2 * ends <= reached) {
      ends *= 2;
    }
    return run.tStart() + ends;
  }

  private static String again(Path folder, String name, double end, double part) {
    String[] words = name.split(" ", -1);
    for (int i = 1; i < words.length; i++) {
      words[i] = words[i].equals("file") ? "" : words[i];
    }
    try {
      MechModel model = read(folder.resolve(words[0]));
      RunSettings run = model.content().settings().run();
      MechModel changed =
          model
              .until(end)
              .tolerances(
                  part * run.relativeTolerance(),
                  part * run.absoluteTolerance(),
                  part * run.angleTolerance(),
                  part * run.velocityTolerance(),
                  part * run.angularVelocityTolerance());
      return result(changed, words[1], words[2], words[3]);
    } catch (IOException | MechmlException e) {
      throw new IllegalStateException(name + " could be read before", e);
    }
  }

  private static String result(
      MechModel model, String formulation, String integrator, String closure) {
    RunSettings run = model.content().settings().run();
    try {
      MechModel chosen = formulation.isEmpty() ? model : model.formulation(formulation);
      chosen = integrator.isEmpty() ? chosen : chosen.integrator(integrator);
      chosen = closure.isEmpty() ? chosen : chosen.closure(closure);
      return line(chosen.simulate(new FirstSteps(model, TIMES)), run);
    } catch (RunFailedException e) {
      return e.rows().map(rows -> line(rows, run)).orElse("ended early");
    } catch (IllegalArgumentException e) {
      return "does not fit";
    }
  }

  private static final class FirstSteps extends RunControl {
    private final long most;

    FirstSteps(MechModel model, int times) {
      int joints = model.content().mechanism().joints().size();
      most = (long) times * STEPS * JOINTS / Math.max(JOINTS, joints);
    }

    @Override
    public boolean proceed(double time, double stepSize, int order, long steps) {
      return super.proceed(time, stepSize, order, steps) && steps < most;
    }
  }

  /**
   * Returns the hash of a run's rows, the tolerances of the columns, and those rows whose numbers
   * are powers of two, and the last.
   */
  private static String line(Trajectory trajectory, RunSettings run) {
    DoubleBuffer values = trajectory.values();
    ByteBuffer bytes = ByteBuffer.allocate(Double.BYTES * values.remaining());
    bytes.asDoubleBuffer().put(values.duplicate());
    StringBuilder line = new StringBuilder();
    try {
      byte[] digest = MessageDigest.getInstance("SHA-256").digest(bytes.array());
      line.append(HexFormat.of().formatHex(digest));
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java machine has SHA-256", e);
    }
    double[] sizes = new double[trajectory.columns().size()];
    for (int i = 0; i < values.remaining(); i++) {
      int column = i % sizes.length;
      sizes[column] = Math.max(sizes[column], Math.abs(values.get(i)));
    }
    line.append("\ttolerances");
    for (int i = 0; i < sizes.length; i++) {
      double absolute = run.absoluteTolerance(trajectory.columns().get(i).unit());
      line.append(" ").append(run.relativeTolerance() * sizes[i] + absolute);
    }
    for (int i = 0; i < trajectory.rows(); i++) {
      if (Integer.bitCount(i) < 2 || i == trajectory.rows() - 1) {
        double[] row = new double[sizes.length];
        values.get(i * row.length, row);
        line.append("\t").append(i);
        DoubleStream.of(row).forEach(value -> line.append(" ").append(value));
      }
    }
    return line.toString();
  }

  private static Map<String, Run> lines(Path file) throws IOException {
    Map<String, Run> lines = new LinkedHashMap<>();
    for (String line : Files.readAllLines(file)) {
      lines.put(line.substring(0, line.indexOf('\t')), Run.of(line));
    }
    return lines;
  }

  private static boolean differ(Run before, Run after) {
    return !before.digest().equals(after.digest());
  }

  private static void compare(
      Map<String, Run> before, Map<String, Run> after, Map<String, Run> others) {
    long different = 0;
    long runs = 0;
    for (Map.Entry<String, Run> entry : before.entrySet()) {
      String name = entry.getKey();
      Run one = entry.getValue();
      runs += one.digest().equals("does not fit") ? 0 : 1;
      if (differ(one, after.getOrDefault(name, Run.MISSING))) {
        different++;
        String beside = others.containsKey(name) ? ", with other tolerances " : "";
        System.out.println(
            name
                + ": "
                + difference(one, after.getOrDefault(name, Run.MISSING))
                + (beside.isEmpty()
                    ? ""
                    : beside + difference(one, others.getOrDefault(name, Run.MISSING))));
      }
    }
    System.out.printf("%d of %d runs differ%n", different, runs);
  }

  private static String difference(Run before, Run after) {
    if (before.rows().isEmpty() || after.rows().isEmpty()) {
      return before.digest() + " -> " + after.digest();
    }
    List<Double> one = before.last();
    List<Double> other = after.last();
    if (one.size() != other.size() || !one.get(0).equals(other.get(0))) {
      return "ends at another time, " + one.get(0) + " -> " + other.get(0);
    }
    double largest = 0;
    for (int i = 0; i < one.size(); i++) {
      largest = Math.max(largest, Math.abs(one.get(i) - other.get(i)) / before.tolerances().get(i));
    }
    return String.format(Locale.ROOT, "%.1e", largest);
  }
}
