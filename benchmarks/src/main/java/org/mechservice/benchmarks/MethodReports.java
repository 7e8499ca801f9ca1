package org.mechservice.benchmarks;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.mechservice.benchmarks.paper.PaperReport;
import org.mechservice.benchmarks.study.MethodStudy;
import org.mechservice.benchmarks.study.StudyContext;
import org.mechservice.benchmarks.suite.EqualErrorRatios;
import org.mechservice.benchmarks.suite.SuiteReport;
import org.mechservice.client.MechConnection;
import org.mechservice.guard.UserCodePolicy;
import org.mechservice.report.ProgressLine;
import org.mechservice.report.stability.ExtremeCase;
import org.mechservice.server.MechServerProcess;
import org.mechservice.server.ServerSettings;
import org.mechservice.sim.host.HostOptions;

/**
 * Writes the pages that are evidence about the methods: the integrator suite with its peers, the
 * paper's tables, and the studies of stability. Models are built by a server that this process
 * starts for itself.
 */
public final class MethodReports {
  private static final String USAGE =
      """
      usage: java -cp benchmarks.jar org.mechservice.benchmarks.MethodReports COMMAND DIR [OPTION...]
        suite DIR [--quick]        the integrators alone, on problems with verified solutions
        ratios DIR                 ode15s and ode15sR beside CVODE and IDA at equal errors
        paper DIR EXAMPLES         the paper's tables, on the scenes of folder EXAMPLES
        study DIR NAME [--quick] [CASE...]
                                   one study (STUDIES) or all;
                                   study service runs the named cases only
      """;

  private static final String ALL = "all";

  private static final String QUICK = "--quick";

  private MethodReports() {}

  /**
   * Measures, writes pages and prints their files; exit status 2 means bad usage.
   *
   * @param args command, folder of the pages, and what the command takes besides
   * @throws IOException if a page cannot be written
   */
  public static void main(String[] args) throws IOException {
    // The libraries log nothing here; SLF4J would say so.
    System.setProperty("slf4j.internal.verbosity", "ERROR");
    List<String> words = new ArrayList<>(Arrays.asList(args));
    boolean quick = words.remove(QUICK);
    PrintWriter err = new PrintWriter(System.err, true, StandardCharsets.UTF_8);
    try (ProgressLine line = new ProgressLine(err)) {
      if (!new MethodReports().run(words, quick, line)) {
        System.err.print(USAGE.replace("STUDIES", String.join(", ", namesOfStudies())));
        System.exit(2);
      }
    }
    // The ORB leaves threads behind.
    System.exit(0);
  }

  /** Runs a command; returns false if it is not one. */
  private boolean run(List<String> words, boolean quick, ProgressLine line) throws IOException {
    if (words.size() < 2) {
      return false;
    }
    Path folder = Path.of(words.get(1));
    List<String> rest = words.subList(2, words.size());
    switch (words.get(0)) {
      case "suite" -> System.out.println(new SuiteReport(quick, line).write(folder));
      case "ratios" -> System.out.println(new EqualErrorRatios(line).write(folder));
      case "paper" -> {
        if (rest.size() != 1) {
          return false;
        }
        try (EmbeddedService service = new EmbeddedService()) {
          Path examples = Path.of(rest.get(0));
          System.out.println(
              new PaperReport(service.connection()::openSession, examples, line).write(folder));
        }
      }
      case "study" -> {
        return !rest.isEmpty() && study(folder, rest, quick, line);
      }
      default -> {
        return false;
      }
    }
    return true;
  }

  private static boolean study(Path folder, List<String> words, boolean quick, ProgressLine line)
      throws IOException {
    String wanted = words.get(0);
    List<String> cases = words.subList(1, words.size());
    List<ExtremeCase> suite =
        ExtremeCase.suite().stream()
            .filter(one -> cases.isEmpty() || cases.contains(one.name()))
            .toList();
    boolean known = wanted.equals(ALL) || namesOfStudies().contains(wanted);
    if (!known || (!cases.isEmpty() && suite.size() < cases.size())) {
      return false;
    }
    try (EmbeddedService service = new EmbeddedService()) {
      StudyContext context =
          new StudyContext(service.connection()::openSession, quick, suite, line);
      for (MethodStudy study : MethodStudy.all(context)) {
        if (wanted.equals(ALL) || wanted.equals(study.name())) {
          System.out.println(study.write(folder, context));
        }
      }
    }
    return true;
  }

  private static List<String> namesOfStudies() {
    StudyContext none =
        new StudyContext(
            () -> {
              throw new IllegalStateException("no study is run here");
            },
            true,
            List.of(),
            (what, done, left) -> {});
    return MethodStudy.all(none).stream().map(MethodStudy::name).toList();
  }

  /** A server within this process, on a free port of the loopback address, and its client. */
  private static final class EmbeddedService implements AutoCloseable {
    private final MechServerProcess server =
        MechServerProcess.start(
            new ServerSettings(
                "127.0.0.1",
                0,
                new HostOptions("embedded", 1).withUserCode(UserCodePolicy.UNCONFINED)));
    private final MechConnection connection = MechConnection.openOwn(server.url());

    MechConnection connection() {
      return connection;
    }

    @Override
    public void close() {
      connection.close();
      server.close();
    }
  }
}
