package org.mechservice.benchmarks;

import com.sun.management.ThreadMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneId;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import org.openjdk.jmh.results.Result;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.CommandLineOptionException;
import org.openjdk.jmh.runner.options.CommandLineOptions;
import org.openjdk.jmh.runner.options.OptionsBuilder;

/** Measures evaluations and writes docs/reports/evaluation-cost.md. */
public final class EvaluationCost {
  private static final List<String> SCENES = List.of("pendulum", "driver", "chain200");

  /** Calls before bytes are counted, and counted calls. */
  private static final int WARM = 50;

  private static final int COUNTED = 200;

  /** Links from which on a chain's time is compared with its length: caches aside. */
  private static final int LONG = 100;

  private final StringBuilder page = new StringBuilder();

  private EvaluationCost() {}

  /**
   * Measures and writes.
   *
   * @param args the page's file, then options of JMH
   */
  public static void main(String[] args)
      throws RunnerException, CommandLineOptionException, IOException {
    String[] options = Arrays.copyOfRange(args, 1, args.length);
    Collection<RunResult> results =
        new Runner(
                new OptionsBuilder()
                    .parent(new CommandLineOptions(options))
                    .include("\\." + Evaluations.class.getSimpleName())
                    .include(GeneratedCode.class.getSimpleName())
                    .include(ChainGrowth.class.getSimpleName())
                    .build())
            .run();
    Files.writeString(Path.of(args[0]), new EvaluationCost().page(results));
  }

  private String page(Collection<RunResult> results) {
    line("# What one evaluation costs");
    line("");
    line(
        "Measured on %s with JMH by the second command of [benchmarks](../../benchmarks/README.md):"
            + " %s %s, processors: %d, Java %s; warm, each figure in a process of its own, one"
            + " thread. Times depend on the machine and on what else it does. Bytes are what %d"
            + " calls have allocated, as the JVM counts them for the thread, over their number.",
        LocalDate.now(ZoneId.systemDefault()),
        System.getProperty("os.name"),
        System.getProperty("os.arch"),
        Runtime.getRuntime().availableProcessors(),
        System.getProperty("java.version"),
        COUNTED);
    line("");
    line("## Formulations");
    line("");
    line(
        "Driven by data: DTR and DSR give y', RR the residual; of RR-JF `jacobian` is the analytic"
            + " Jacobian, `factorisation` its factors, `iteration` one residual and one solution."
            + " `generated` is the same evaluation by the code generated for the scene.");
    line("");
    line("| scene | what | ns | +- | bytes |");
    line("|---|---|---|---|---|");
    List<RunResult> ordered = new ArrayList<>(results);
    ordered.sort(Comparator.comparing(result -> result.getParams().getBenchmark()));
    for (String scene : SCENES) {
      Map<String, Double> bytes = bytes(scene);
      for (RunResult result : ordered) {
        if (scene.equals(result.getParams().getParam("scene"))) {
          double allocated = bytes.getOrDefault(what(result), Double.NaN);
          line("| %s | %s | %s | %.1f |", scene, what(result), times(result), allocated);
        }
      }
    }
    growth(ordered);
    return page.toString();
  }

  private void growth(List<RunResult> ordered) {
    line("");
    line("## Growth with length");
    line("");
    line("y' by DTR, driven by data, of a chain of links:");
    line("");
    line("| links | ns | +- | ns per link |");
    line("|---|---|---|---|");
    List<RunResult> chains =
        ordered.stream()
            .filter(result -> result.getParams().getBenchmark().contains("ChainGrowth"))
            .sorted(Comparator.comparingInt(EvaluationCost::links))
            .toList();
    for (RunResult chain : chains) {
      double time = chain.getPrimaryResult().getScore();
      line("| %d | %s | %.1f |", links(chain), times(chain), time / links(chain));
    }
    List<RunResult> longer = chains.stream().filter(chain -> links(chain) >= LONG).toList();
    if (longer.size() > 1) {
      RunResult first = longer.get(0);
      RunResult last = longer.get(longer.size() - 1);
      double exponent =
          StrictMath.log(last.getPrimaryResult().getScore() / first.getPrimaryResult().getScore())
              / StrictMath.log((double) links(last) / links(first));
      line("");
      line(
          "From %d to %d links the time grows as length to the power %.2f.",
          links(first), links(last), exponent);
    }
  }

  private static int links(RunResult chain) {
    return Integer.parseInt(chain.getParams().getParam("links"));
  }

  private static String what(RunResult result) {
    String name = result.getParams().getBenchmark();
    return name.contains("GeneratedCode")
        ? "generated " + result.getParams().getParam("formulation")
        : name.substring(name.lastIndexOf('.') + 1);
  }

  private static String times(RunResult result) {
    Result<?> time = result.getPrimaryResult();
    return String.format(Locale.ROOT, "%.0f | %.0f", time.getScore(), time.getScoreError());
  }

  /** Returns the bytes that a call allocates, by name of the call. */
  private static Map<String, Double> bytes(String scene) {
    Evaluations evaluations = new Evaluations();
    evaluations.scene = scene;
    evaluations.prepare();
    Map<String, Double> bytes = new TreeMap<>();
    bytes.put("dtr", allocated(evaluations::dtr));
    bytes.put("dsr", allocated(evaluations::dsr));
    bytes.put("rr", allocated(evaluations::rr));
    bytes.put("jacobian", allocated(evaluations::jacobian));
    bytes.put("factorisation", allocated(evaluations::factorisation));
    bytes.put("iteration", allocated(evaluations::iteration));
    if (!scene.startsWith("chain")) {
      for (String formulation : List.of("DTR", "DSR", "RR", "RR-JF")) {
        GeneratedCode generated = new GeneratedCode();
        generated.scene = scene;
        generated.formulation = formulation;
        generated.prepare();
        bytes.put("generated " + formulation, allocated(generated::evaluation));
      }
    }
    return bytes;
  }

  private static double allocated(Runnable call) {
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    repeat(call, WARM);
    long before = threads.getCurrentThreadAllocatedBytes();
    repeat(call, COUNTED);
    return (double) (threads.getCurrentThreadAllocatedBytes() - before) / COUNTED;
  }

  private static void repeat(Runnable call, int times) {
    for (int i = 0; i < times; i++) {
      call.run();
    }
  }

  private void line(String format, Object... values) {
    page.append(values.length == 0 ? format : String.format(Locale.ROOT, format, values))
        .append('\n');
  }
}
