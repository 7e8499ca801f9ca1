package org.mechservice.solver.standalone;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelSource;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.api.TunableParameter;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.simulation.Simulation;
import org.mechservice.solver.text.JsonText;
import org.mechservice.solver.text.ReportText;
import org.mechservice.solver.text.ResultFile;

/** The command line of {@code java -jar model.jar}: one run of one model. */
public final class Standalone {
  private static final int DONE = 0;
  private static final int SIMULATION_FAILED = 1;
  private static final int BAD_USAGE = 2;

  private final ModelSource source;
  private final Solver solver;
  private final Set<ColumnGroup> built;
  private final Set<ColumnGroup> shown;
  private final PrintStream out;
  private final PrintStream err;

  /**
   * @param built labels of the column groups the model was built with, separated by commas
   * @param shown labels of those put out where nothing else is asked for
   */
  Standalone(
      ModelSource source,
      Solver solver,
      String built,
      String shown,
      PrintStream out,
      PrintStream err) {
    this.source = source;
    this.solver = solver;
    this.built = ColumnGroup.of(built);
    this.shown = ColumnGroup.of(shown);
    this.out = out;
    this.err = err;
  }

  /**
   * Runs a model with the options of its command line, printing to the standard streams.
   *
   * @param source creates the model
   * @param solver runs it
   * @param built labels of the column groups the model was built with, separated by commas
   * @param shown labels of those put out where nothing else is asked for
   * @param args command line; {@code --help} lists the options
   * @return exit status: 0 done, 1 the simulation failed (rows up to the failure are kept), 2 bad
   *     usage
   */
  public static int run(
      ModelSource source, Solver solver, String built, String shown, String[] args) {
    return new Standalone(source, solver, built, shown, System.out, System.err).run(args);
  }

  int run(String[] args) {
    try {
      Model model = source.model();
      StandaloneOptions options =
          StandaloneOptions.parse(args, model.description().defaults(), built, shown);
      if (options.help()) {
        out.print(model.description().name() + "\n" + StandaloneOptions.HELP + parameters());
        return DONE;
      } else if (!options.parameters().isEmpty()) {
        model = source.model(options.parameters());
      }
      Simulation.requireColumns(model, options.request().columns(), built);
      return options.out().isEmpty() ? runWithoutFile(model, options) : runIntoFile(model, options);
    } catch (OptionException | IllegalArgumentException | IOException e) {
      err.println(e.getMessage());
      return BAD_USAGE;
    }
  }

  /** Lists the parameters for {@code --set}. */
  private String parameters() {
    StringBuilder list = new StringBuilder();
    for (TunableParameter parameter : source.parameters()) {
      list.append(list.isEmpty() ? "Tunable parameters:\n" : "");
      list.append("  ").append(parameter.name()).append('=').append(parameter.value());
      list.append(parameter.unit().equals("1") ? "" : " " + parameter.unit()).append('\n');
    }
    return list.toString();
  }

  private int runWithoutFile(Model model, StandaloneOptions options) throws IOException {
    ResultSink nowhere =
        new ResultSink() {
          @Override
          public void begin(List<Variable> columns) {}

          @Override
          public void row(double[] values) {}
        };
    RunReport report = solver.run(model, options.request(), nowhere, new RunControl());
    return printReport(options, report, new LinkedHashMap<>(report.asMap()));
  }

  private int runIntoFile(Model model, StandaloneOptions options) throws IOException {
    try (ResultFile file = new ResultFile(Path.of(options.out()))) {
      RunReport report = solver.run(model, options.request(), file, new RunControl());
      Map<String, Object> facts = new LinkedHashMap<>(report.asMap());
      facts.put("resultsSha256", file.keep());
      return printReport(options, report, facts);
    }
  }

  private int printReport(StandaloneOptions options, RunReport report, Map<String, Object> facts) {
    if (!options.parameters().isEmpty()) {
      facts.put("parameters", options.parameters().toString());
    }
    if (options.json()) {
      out.println(JsonText.write(facts));
    } else if (!options.quiet()) {
      out.print(ReportText.format(facts));
    }
    if (report.outcome() instanceof Outcome.Failed failed) {
      String kept =
          options.out().isEmpty() ? "" : " Rows up to there are in " + options.out() + ".";
      err.println(failed.failure().message() + kept);
      return SIMULATION_FAILED;
    }
    return DONE;
  }
}
