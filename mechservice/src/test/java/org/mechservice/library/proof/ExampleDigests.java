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
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.mechservice.library.MechModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.api.program.RunFailedException;
import org.mechservice.solver.api.program.Trajectory;
import org.mechservice.solver.api.run.RunControl;

/**
 * The bits of all example scenes, run with every formulation, integrator and closure that fits,
 * before and after a change.
 *
 * <p>{@code ExampleDigests FOLDER FILE} runs the scenes of a folder, each for at most {@value
 * #STEPS} steps, fewer of more than {@value #JOINTS} joints, and writes a line for each run: its
 * name, the SHA-256 of its rows, and the values of its last row. {@code ExampleDigests BEFORE
 * AFTER} compares two such files and prints the runs that differ, with the largest difference of a
 * value relative to the largest of the row.
 */
final class ExampleDigests {
  private static final int STEPS = 1000;
  private static final int JOINTS = 10;

  private static final List<String> FORMULATIONS = List.of("", "DTR", "DSR", "RR", "RR-JF");
  private static final List<String> INTEGRATORS = List.of("", "ode113", "DE", "ode15s", "ode15sR");
  private static final List<String> CLOSURES = List.of("", "projection", "penalty");

  private ExampleDigests() {}

  public static void main(String[] arguments) throws Exception {
    Path first = Path.of(arguments[0]);
    Path second = Path.of(arguments[1]);
    if (Files.isDirectory(first)) {
      try (PrintStream out = new PrintStream(second.toFile(), StandardCharsets.UTF_8)) {
        for (Path file : scenes(first)) {
          runs(first, file, out);
        }
      }
    } else {
      compare(lines(first), lines(second));
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

  private static void runs(Path folder, Path file, PrintStream out) {
    MechModel model;
    try {
      model = MechModel.read(file);
    } catch (IOException | MechmlException | IllegalArgumentException e) {
      out.println(folder.relativize(file) + "\tno model");
      return;
    }
    boolean loops = !model.content().mechanism().closures().isEmpty();
    for (String closure : loops ? CLOSURES : List.of("")) {
      for (String formulation : FORMULATIONS) {
        for (String integrator : INTEGRATORS) {
          if (formulation.isEmpty() != integrator.isEmpty()) {
            continue;
          }
          String name =
              Stream.of(folder.relativize(file).toString(), formulation, integrator, closure)
                  .map(word -> word.isEmpty() ? "file" : word)
                  .collect(Collectors.joining(" "));
          out.println(name + "\t" + result(model, formulation, integrator, closure));
          out.flush();
        }
      }
    }
  }

  private static String result(
      MechModel model, String formulation, String integrator, String closure) {
    try {
      MechModel chosen = formulation.isEmpty() ? model : model.formulation(formulation);
      chosen = integrator.isEmpty() ? chosen : chosen.integrator(integrator);
      chosen = closure.isEmpty() ? chosen : chosen.closure(closure);
      return digest(chosen.simulate(new FirstSteps(model.content().mechanism().joints().size())));
    } catch (RunFailedException e) {
      return e.rows().map(rows -> "ended early " + digest(rows)).orElse("ended early");
    } catch (IllegalArgumentException e) {
      return "does not fit";
    }
  }

  private static final class FirstSteps extends RunControl {
    private final long most;

    FirstSteps(int joints) {
      most = STEPS * (long) JOINTS / Math.max(JOINTS, joints);
    }

    @Override
    public boolean proceed(double time, double stepSize, int order, long steps) {
      return steps < most && super.proceed(time, stepSize, order, steps);
    }
  }

  private static String digest(Trajectory trajectory) {
    DoubleBuffer values = trajectory.values();
    ByteBuffer bytes = ByteBuffer.allocate(Double.BYTES * values.remaining());
    bytes.asDoubleBuffer().put(values.duplicate());
    int width = trajectory.columns().size() + 1;
    int last = values.remaining() - width;
    String row =
        IntStream.range(Math.max(0, last), values.remaining())
            .mapToObj(i -> Double.toString(values.get(i)))
            .collect(Collectors.joining(" "));
    try {
      byte[] digest = MessageDigest.getInstance("SHA-256").digest(bytes.array());
      return HexFormat.of().formatHex(digest) + " " + row;
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java machine has SHA-256", e);
    }
  }

  private static Map<String, String> lines(Path file) throws IOException {
    Map<String, String> lines = new LinkedHashMap<>();
    for (String line : Files.readAllLines(file)) {
      lines.put(line.substring(0, line.indexOf('\t')), line.substring(line.indexOf('\t') + 1));
    }
    return lines;
  }

  private static void compare(Map<String, String> before, Map<String, String> after) {
    List<String> different = new ArrayList<>();
    before.forEach(
        (name, result) -> {
          String now = after.getOrDefault(name, "missing");
          if (!now.equals(result)) {
            different.add(name);
            System.out.println(name + ": " + difference(result, now));
          }
        });
    long runs = before.values().stream().filter(line -> !line.equals("does not fit")).count();
    System.out.printf("%d of %d runs differ%n", different.size(), runs);
  }

  private static String difference(String before, String after) {
    Optional<double[]> one = row(before);
    Optional<double[]> other = row(after);
    if (one.isEmpty() || other.isEmpty() || one.get().length != other.get().length) {
      return start(before) + " -> " + start(after);
    }
    if (one.get()[0] != other.get()[0]) {
      return "ends at another time";
    }
    double size = 0;
    double largest = 0;
    for (int i = 0; i < one.get().length; i++) {
      size = Math.max(size, Math.abs(one.get()[i]));
      largest = Math.max(largest, Math.abs(one.get()[i] - other.get()[i]));
    }
    return "%.1e".formatted(largest == 0 ? 0 : largest / size);
  }

  private static String start(String result) {
    return result.substring(0, Math.min(24, result.length()));
  }

  private static Optional<double[]> row(String result) {
    String[] words = result.split(" ", -1);
    return words[0].length() == 64
        ? Optional.of(Stream.of(words).skip(1).mapToDouble(Double::parseDouble).toArray())
        : Optional.empty();
  }
}
