package org.mechservice.cli.optimise;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.io.PrintWriter;
import java.math.BigDecimal;
import java.math.MathContext;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.cli.shell.MechVersion;
import org.mechservice.cli.shell.OutputFile;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.library.MechModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.text.ShortestDecimal;
import org.mechservice.study.optimise.Aim;
import org.mechservice.study.optimise.DesignProblem;
import org.mechservice.study.optimise.DesignVariable;
import org.mechservice.study.optimise.Front;
import org.mechservice.study.optimise.Method;
import org.mechservice.study.optimise.ModelDesign;
import org.mechservice.study.optimise.Optimiser;
import org.mechservice.study.optimise.OptimiserSettings;
import org.mechservice.study.optimise.Optimum;
import org.mechservice.study.optimise.PointFailedException;
import org.mechservice.study.optimise.Trial;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code mech optimise}: the parameters for which a model does best. */
@Command(
    name = "optimise",
    description = {
      "Finds the values of parameters for which an objective is least and constraints hold.",
      "Formulas say what is taken of outputs: last(x), at(x,2.5), min(x), max(x), mean(x), rms(x),"
          + " integral(x), crossing(x,0); around these, formulas as in model files, with its"
          + " parameters.",
      "Two objectives make a Pareto front: points at which neither can become better unless the"
          + " other gets worse."
    },
    footer = {
      "mech optimise model.xml --minimise 'rms(acceleration)' --by k=2000:20000 c=50:3000",
      "mech optimise model.xml --minimise 'rms(acceleration)' --by k=2000:20000 --subject-to"
          + " 'max(travel) <= 0.025' --starts 4",
      "mech optimise model.xml --minimise 'rms(acceleration)' --minimise 'max(travel)' --by"
          + " k=2000:20000 c=50:3000 --front 9 --report front.html"
    },
    mixinStandardHelpOptions = true,
    versionProvider = MechVersion.class)
public final class OptimiseCommand implements Callable<Integer> {
  private static final Gson JSON =
      new GsonBuilder().setPrettyPrinting().disableHtmlEscaping().serializeNulls().create();

  private static final int SHOWN_DIGITS = 7;

  /** Points of a front, where the user says nothing. */
  private static final int FRONT = 11;

  @Mixin private VariableOptions design = new VariableOptions();

  @Option(
      names = "--minimise",
      paramLabel = "FORMULA",
      description = "What is to be least; given twice, or beside --maximise: two objectives.")
  private List<String> minimise = List.of();

  @Option(names = "--maximise", paramLabel = "FORMULA", description = "What is to be largest.")
  private List<String> maximise = List.of();

  @Option(
      names = "--front",
      paramLabel = "N",
      description = "Points of the front of two objectives (default: 11).")
  private @Nullable Integer front;

  @Option(
      names = "--residual",
      paramLabel = "FORMULA",
      description =
          "Formulas, or equations A = B, whose sum of squares is to be least (instead of"
              + " --minimise).")
  private List<String> residuals = List.of();

  @Option(
      names = "--subject-to",
      paramLabel = "CONSTRAINT",
      description = "Constraints that must hold, such as 'max(x) <= 0.1' or 'last(y) = 0'.")
  private List<String> constraints = List.of();

  @Option(
      names = "--method",
      paramLabel = "METHOD",
      defaultValue = "auto",
      description =
          "auto: lm for residuals, sqp with constraints, else bobyqa; lm: Levenberg-Marquardt; sqp:"
              + " sequential quadratic programming; bobyqa: Powell's quadratic"
              + " models; cmaes: evolution strategy (default: ${DEFAULT-VALUE}).")
  private String method = "auto";

  @Option(
      names = "--starts",
      paramLabel = "N",
      defaultValue = "1",
      description =
          "Starts, as many at once as there are processors; all but the first at random points"
              + " (default: ${DEFAULT-VALUE}).")
  private int starts;

  @Option(
      names = "--seed",
      paramLabel = "S",
      defaultValue = "1",
      description = "Seed of all random numbers (default: ${DEFAULT-VALUE}).")
  private long seed;

  @Option(
      names = "--runs",
      paramLabel = "N",
      defaultValue = "2000",
      description = "At most so many runs for each start (default: ${DEFAULT-VALUE}).")
  private int runs;

  @Option(
      names = "--failed-as",
      paramLabel = "VALUE",
      description =
          "Objective of points that fail, so that the method goes around them; if left out, a"
              + " point that fails ends its start.")
  private @Nullable Double failedAs;

  @Option(
      names = "--history",
      paramLabel = "FILE.csv",
      description =
          "Write every point that was tried: values, aims, violation, failure; of two objectives"
              + " the points of the front.")
  private @Nullable Path history;

  @Option(
      names = "--report",
      paramLabel = "FILE.html",
      description =
          "Write a page with the optimum and pictures of the way to it, or with the front.")
  private @Nullable Path report;

  @Option(names = "--json", description = "Print one JSON object.")
  private boolean json;

  /** How derivatives were found, for the answer; empty for a method without them. */
  private String derivatives = "";

  @Spec private CommandSpec spec = CommandSpec.create();

  @Override
  public Integer call() throws IOException, InterruptedException {
    for (Path file : new Path[] {history, report}) {
      if (file != null) {
        OutputFile.requireUsable(file);
      }
    }
    DesignProblem problem;
    OptimiserSettings settings;
    Optimum optimum;
    try {
      settings = settings();
      problem = problem(design.model(spec.commandLine().getErr()), settings.method());
      if (minimise.size() + maximise.size() == 2) {
        return print(Front.of(problem, settings, front == null ? FRONT : front));
      }
      optimum = Optimiser.minimise(problem, settings);
    } catch (IllegalArgumentException | MechmlException e) {
      throw VariableOptions.refused(MessageCode.DESIGN_UNUSABLE, e);
    } catch (PointFailedException e) {
      spec.commandLine().getErr().println(MessageCode.NO_POINT_COMPUTED + " " + e.getMessage());
      return ExitStatus.SIMULATION_FAILED;
    }
    if (history != null) {
      write(history, csv(optimum));
    }
    if (report != null) {
      write(report, OptimumPage.of(design.fileName(), optimum));
    }
    PrintWriter out = spec.commandLine().getOut();
    out.println(json ? JSON.toJson(json(optimum)) : text(optimum));
    out.flush();
    return print(optimum);
  }

  private static void write(Path file, String text) throws IOException {
    OutputFile.write(file, text.getBytes(StandardCharsets.UTF_8));
  }

  private OptimiserSettings settings() {
    Method chosen =
        Arrays.stream(Method.values())
            .filter(each -> each.label().equals(method.toLowerCase(Locale.ROOT)))
            .findFirst()
            .orElseThrow(
                () ->
                    new IllegalArgumentException(
                        "there is no method \"" + method + "\"; there are " + Method.labels()));
    return new OptimiserSettings(
        chosen,
        starts,
        seed,
        runs,
        design.step(),
        failedAs == null ? OptionalDouble.empty() : OptionalDouble.of(failedAs),
        Math.min(Math.max(1, starts), Runtime.getRuntime().availableProcessors()));
  }

  private DesignProblem problem(MechModel model, Method asked) throws MechmlException {
    int objectives = minimise.size() + maximise.size();
    if (objectives > 2 || (objectives > 0) != residuals.isEmpty()) {
      throw new UsageException(
          MessageCode.DESIGN_UNUSABLE
              + " write one of --minimise, --maximise and --residual; two objectives make a front");
    } else if (front != null && objectives != 2) {
      throw new UsageException(
          MessageCode.DESIGN_UNUSABLE
              + " --front belongs to two objectives; write --minimise or --maximise once more");
    }
    List<DesignVariable> variables = design.variables(model);
    ModelDesign made = new ModelDesign(model, variables);
    minimise.forEach(made::minimise);
    maximise.forEach(made::maximise);
    residuals.forEach(made::residual);
    constraints.forEach(made::subjectTo);
    DesignProblem plain = made.problem();
    if (!asked.chosenFor(plain).hasDerivatives()) {
      return plain;
    }
    VariableOptions.Derived<DesignProblem> derived =
        design.derived(model, variables, exact -> exact ? made.problem(true) : plain);
    derivatives = ", " + derived.derivatives();
    return derived.made();
  }

  private int print(Front found) throws IOException {
    FrontText text = new FrontText(found, derivatives);
    if (history != null) {
      write(history, text.csv());
    }
    if (report != null) {
      write(report, FrontPage.of(design.fileName(), text));
    }
    PrintWriter out = spec.commandLine().getOut();
    out.println(json ? JSON.toJson(text.json()) : text.lines());
    out.flush();
    return ExitStatus.DONE;
  }

  private int print(Optimum optimum) {
    PrintWriter err = spec.commandLine().getErr();
    for (int k = 0; k < optimum.starts().size(); k++) {
      int number = k + 1;
      optimum
          .starts()
          .get(k)
          .ended()
          .ifPresent(
              why -> err.println(MessageCode.START_ENDED + " start " + number + " ended: " + why));
    }
    if (!optimum.best().isFeasible()) {
      err.println(
          MessageCode.NO_POINT_FEASIBLE
              + " no point satisfies all constraints; the best one violates one by "
              + shown(optimum.best().violation())
              + " of its size");
      return ExitStatus.SIMULATION_FAILED;
    }
    return ExitStatus.DONE;
  }

  private static String csv(Optimum optimum) {
    DesignProblem problem = optimum.problem();
    StringBuilder csv = new StringBuilder("start,run");
    problem.variables().forEach(variable -> csv.append(',').append(quoted(variable.name())));
    problem.aims().forEach(aim -> csv.append(',').append(quoted(aim.text())));
    csv.append(",objective,violation,failure\n");
    for (Trial trial : optimum.history()) {
      csv.append(trial.start()).append(',').append(trial.run());
      Arrays.stream(trial.point()).forEach(x -> csv.append(',').append(number(x)));
      Arrays.stream(trial.values()).forEach(x -> csv.append(',').append(number(x)));
      csv.append(',').append(number(trial.objective()));
      csv.append(',').append(number(trial.violation()));
      csv.append(',').append(quoted(trial.failure().orElse(""))).append('\n');
    }
    return csv.toString();
  }

  static String number(double value) {
    return Double.isFinite(value)
        ? ShortestDecimal.format(value)
        : Double.isNaN(value) ? "" : value > 0 ? "inf" : "-inf";
  }

  static String quoted(String text) {
    return text.matches("[^\",\\n\\r]*") ? text : '"' + text.replace("\"", "\"\"") + '"';
  }

  /** Returns a number with at most seven digits. */
  static String shown(double value) {
    return Double.isFinite(value)
        ? ShortestDecimal.format(
            new BigDecimal(value).round(new MathContext(SHOWN_DIGITS)).doubleValue())
        : String.valueOf(value);
  }

  /** Returns where a value is: at a bound, or nothing. */
  static String place(int bound) {
    return bound < 0 ? "at its lower bound" : bound > 0 ? "at its upper bound" : "";
  }

  /** Returns what is wanted of an aim, and how it stands at the optimum. */
  static String standing(Optimum optimum, int aim) {
    double value = optimum.best().values()[aim];
    return switch (optimum.problem().aims().get(aim).kind()) {
      case MINIMISE -> "minimised";
      case RESIDUAL -> "residual";
      case AT_MOST_ZERO, ZERO ->
          optimum.isViolated(aim)
              ? "violated by " + shown(Math.abs(value))
              : optimum.isActive(aim)
                  ? "holds with equality (active)"
                  : "holds, " + shown(-value) + " to spare";
    };
  }

  private String text(Optimum optimum) {
    DesignProblem problem = optimum.problem();
    Trial best = optimum.best();
    StringBuilder text = new StringBuilder();
    for (int j = 0; j < best.point().length; j++) {
      DesignVariable variable = problem.variables().get(j);
      text.append(variable.name()).append(" = ").append(shown(best.point()[j]));
      String place = place(optimum.bound(j));
      text.append(place.isEmpty() ? "" : "  (" + place + ")").append('\n');
    }
    for (int i = 0; i < best.values().length; i++) {
      Aim aim = problem.aims().get(i);
      text.append(aim.text());
      if (aim.kind() == Aim.Kind.MINIMISE || aim.kind() == Aim.Kind.RESIDUAL) {
        text.append(": ").append(shown(best.values()[i])).append('\n');
      } else {
        text.append(": ").append(standing(optimum, i)).append('\n');
      }
    }
    optimality(optimum).ifPresent(said -> text.append(said).append('\n'));
    return text.append("method ")
        .append(optimum.method().label())
        .append(", ")
        .append(counted(optimum.starts().size(), "start"))
        .append(", ")
        .append(counted(optimum.runs(), "run"))
        .append(", ")
        .append(optimum.failures())
        .append(" failed")
        .append(derivatives)
        .toString();
  }

  /** Returns whether the end is an optimum, and by which measure. */
  static Optional<String> optimality(Optimum optimum) {
    return optimum
        .isLocal()
        .map(
            local ->
                (local
                        ? "a local optimum: "
                        : "no local optimum yet (go on from here, with sqp or more runs): ")
                    + "slopes promise "
                    + shown(optimum.promise().orElseThrow())
                    + " of the objective within 0.1 % of the ranges");
  }

  static String counted(int count, String what) {
    return count == 1 ? "1 " + what : count + " " + what + "s";
  }

  private static JsonObject json(Optimum optimum) {
    DesignProblem problem = optimum.problem();
    Trial best = optimum.best();
    JsonObject all = new JsonObject();
    JsonObject values = new JsonObject();
    JsonArray bounds = new JsonArray();
    for (int j = 0; j < best.point().length; j++) {
      values.addProperty(problem.variables().get(j).name(), best.point()[j]);
      if (optimum.bound(j) != 0) {
        bounds.add(problem.variables().get(j).name());
      }
    }
    all.add("parameters", values);
    all.add("atBound", bounds);
    all.addProperty("objective", best.objective());
    all.addProperty("feasible", best.isFeasible());
    all.addProperty("violation", best.violation());
    JsonArray aims = new JsonArray();
    for (int i = 0; i < best.values().length; i++) {
      JsonObject aim = new JsonObject();
      aim.addProperty("formula", problem.aims().get(i).text());
      aim.addProperty("value", best.values()[i]);
      aim.addProperty("standing", standing(optimum, i));
      aims.add(aim);
    }
    all.add("aims", aims);
    optimum.isLocal().ifPresent(local -> all.addProperty("localOptimum", local));
    optimum.promise().ifPresent(promise -> all.addProperty("promise", promise));
    all.addProperty("method", optimum.method().label());
    all.addProperty("starts", optimum.starts().size());
    all.addProperty("runs", optimum.runs());
    all.addProperty("failed", optimum.failures());
    return all;
  }
}
