package org.mechservice.cli.optimise;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.mechservice.cli.model.ParameterOption;
import org.mechservice.cli.model.UserCodeOption;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.cli.shell.MechVersion;
import org.mechservice.cli.shell.OutputFile;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.library.MechModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.api.ModelParameter;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.ode.solve.IntegrationException;
import org.mechservice.solver.text.ShortestDecimal;
import org.mechservice.study.Reduction;
import org.mechservice.study.gradient.Gradient;
import org.mechservice.study.gradient.GradientMethod;
import org.mechservice.study.gradient.Gradients;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code mech gradient}: derivatives of results by parameters and start values. */
@Command(
    name = "gradient",
    description = {
      "Computes derivatives of outputs by parameters and start values, in one or a few runs.",
      "Integrals and extremes are those of the motion, between its rows too."
    },
    footer = {
      "mech gradient model.xml --of 'rms(acceleration)' 'max(travel)' --by k c",
      "mech gradient model.xml --of 'series(x,0.05)' --by k=1e3:2e4 c --report gradient.html"
    },
    mixinStandardHelpOptions = true,
    versionProvider = MechVersion.class)
public final class GradientCommand implements Callable<Integer> {
  private static final Gson JSON =
      new GsonBuilder()
          .setPrettyPrinting()
          .disableHtmlEscaping()
          .serializeSpecialFloatingPointValues()
          .create();

  @Parameters(paramLabel = "MODEL.xml", description = "Model in MechML.")
  private Path file = Path.of("");

  @Option(
      names = "--of",
      required = true,
      arity = "1..*",
      paramLabel = "OUTPUT",
      description =
          "What is differentiated: last(x), at(x,2.5), min(x), max(x), mean(x), rms(x),"
              + " integral(x), crossing(x,0), series(x,0.1); a name alone is its last value.")
  private List<String> of = List.of();

  @Option(
      names = "--by",
      required = true,
      arity = "1..*",
      paramLabel = "PARAM",
      description =
          "Parameters of the model, and start values by their columns, such as crank.v; with a range"
              + " k=1e3:2e4 by which the page of --report scales its pictures (default: 10 %% of the"
              + " value).")
  private List<String> by = List.of();

  @Option(
      names = "--method",
      paramLabel = "METHOD",
      defaultValue = "auto",
      description =
          "forward: tangents along with the motion, for few parameters; adjoint: backwards in time,"
              + " for few outputs; auto: the cheaper one (default: ${DEFAULT-VALUE}).")
  private String method = "auto";

  @Option(
      names = "--simulation",
      paramLabel = "NAME",
      description = "Name or number of the simulation of the file (default: the first).")
  private Optional<String> simulation = Optional.empty();

  @Option(
      names = "--memory",
      paramLabel = "MB",
      defaultValue = "256",
      description =
          "Memory in which the adjoint keeps the motion; what does not fit is computed again"
              + " (default: ${DEFAULT-VALUE}).")
  private int memory;

  @Option(
      names = {"-o", "--out", "--output"},
      paramLabel = "FILE.csv",
      description = "Write a row for each output: its value and its derivatives.")
  private @Nullable Path out;

  @Option(
      names = "--report",
      paramLabel = "FILE.html",
      description =
          "Write a page with pictures: effects of the parameters, over time for a series, cost and"
              + " errors.")
  private @Nullable Path report;

  @Option(names = "--json", description = "Print one JSON object.")
  private boolean json;

  @Mixin private UserCodeOption userCode = new UserCodeOption();

  @Mixin private ParameterOption settings = new ParameterOption();

  @Spec private CommandSpec spec = CommandSpec.create();

  @Override
  public Integer call() throws IOException {
    for (Path target : new Path[] {out, report}) {
      if (target != null) {
        OutputFile.requireUsable(target);
      }
    }
    List<DifferentiatedBy> parameters = by.stream().map(DifferentiatedBy::parse).toList();
    List<Reduction> outputs = outputs();
    Gradient found;
    Optional<String> page = Optional.empty();
    try {
      MechModel model = model();
      Gradients gradients = gradients(model, parameters, outputs);
      found = gradients.compute(chosen());
      if (report != null) {
        RunSettings run = model.request().settings();
        Gradients finer = gradients(finer(model, run), parameters, outputs);
        page =
            Optional.of(
                GradientPage.of(
                    String.valueOf(file.getFileName()),
                    found,
                    finer.compute(found.method()),
                    outputs,
                    gradients.outputs(),
                    changes(parameters, model, found)));
      }
    } catch (IllegalArgumentException | MechmlException e) {
      throw VariableOptions.refused(MessageCode.GRADIENT_UNUSABLE, e);
    } catch (IntegrationException e) {
      spec.commandLine().getErr().println(MessageCode.GRADIENT_FAILED + " " + e.getMessage());
      return ExitStatus.SIMULATION_FAILED;
    }
    if (out != null) {
      OutputFile.write(out, csv(found).getBytes(StandardCharsets.UTF_8));
    }
    if (report != null && page.isPresent()) {
      OutputFile.write(report, page.get().getBytes(StandardCharsets.UTF_8));
    }
    PrintWriter shown = spec.commandLine().getOut();
    shown.println(json ? JSON.toJson(json(found)) : text(found));
    shown.flush();
    return ExitStatus.DONE;
  }

  private GradientMethod chosen() {
    return GradientMethod.named(method)
        .orElseThrow(
            () ->
                new IllegalArgumentException(
                    "there is no method \"" + method + "\"; there are auto, forward, adjoint"));
  }

  private MechModel model() throws IOException, MechmlException {
    MechModel model = MechModel.read(file, userCode.consent());
    if (simulation.isPresent()) {
      model = model.simulation(simulation.get());
    }
    for (Map.Entry<String, String> value : settings.values().entrySet()) {
      model = model.set(value.getKey(), value.getValue());
    }
    return model;
  }

  private List<Reduction> outputs() {
    List<Reduction> outputs = new ArrayList<>();
    for (String text : of) {
      try {
        outputs.add(Reduction.parse(text));
      } catch (IllegalArgumentException e) {
        throw new UsageException(
            MessageCode.GRADIENT_UNUSABLE + " --of " + text + ": " + e.getMessage());
      }
    }
    return outputs;
  }

  private Gradients gradients(
      MechModel model, List<DifferentiatedBy> parameters, List<Reduction> outputs)
      throws MechmlException {
    List<String> names = parameters.stream().map(DifferentiatedBy::name).toList();
    return Gradients.of(model, names, outputs).memory((long) memory << 20);
  }

  /** Returns a model at a tenth of its tolerances. */
  private static MechModel finer(MechModel model, RunSettings run) {
    return model.tolerances(
        run.relativeTolerance() / 10,
        run.absoluteTolerance() / 10,
        run.angleTolerance() / 10,
        run.velocityTolerance() / 10,
        run.angularVelocityTolerance() / 10);
  }

  private static List<GradientPage.Change> changes(
      List<DifferentiatedBy> parameters, MechModel model, Gradient found) {
    List<GradientPage.Change> changes = new ArrayList<>();
    for (int k = 0; k < parameters.size(); k++) {
      DifferentiatedBy one = parameters.get(k);
      String unit = found.parameterUnits().get(k);
      changes.add(
          one.range()
              .map(range -> GradientPage.Change.range(range.get(0), range.get(1), unit))
              .orElseGet(() -> GradientPage.Change.part(value(model, one.name()), unit)));
    }
    return changes;
  }

  /** Returns the value of a parameter; 0 for a start value. */
  private static double value(MechModel model, String name) {
    return model.parameters().stream()
        .filter(parameter -> parameter.name().equals(name))
        .mapToDouble(ModelParameter::value)
        .findFirst()
        .orElse(0);
  }

  private static String text(Gradient found) {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < found.outputs().size(); i++) {
      text.append(found.outputs().get(i))
          .append(" = ")
          .append(OptimiseCommand.shown(found.values()[i]))
          .append(unit(found.units().get(i)))
          .append('\n');
      for (int k = 0; k < found.parameters().size(); k++) {
        text.append("  by ")
            .append(found.parameters().get(k))
            .append(": ")
            .append(OptimiseCommand.shown(found.derivatives()[i][k]))
            .append(" per")
            .append(
                found.parameterUnits().get(k).equals("1")
                    ? " 1"
                    : " " + found.parameterUnits().get(k))
            .append('\n');
      }
    }
    text.append(found.method().label()).append(" (").append(found.reason()).append(')');
    if (!found.differenced().isEmpty()) {
      text.append("; the equations differenced by ").append(String.join(", ", found.differenced()));
    }
    return text.toString();
  }

  private static String unit(String unit) {
    return unit.equals("1") ? "" : " " + unit;
  }

  private static String csv(Gradient found) {
    StringBuilder text = new StringBuilder("output,value");
    found.parameters().forEach(name -> text.append(',').append(quoted(name)));
    text.append("\r\n");
    for (int i = 0; i < found.outputs().size(); i++) {
      text.append(quoted(found.outputs().get(i)))
          .append(',')
          .append(ShortestDecimal.format(found.values()[i]));
      for (double slope : found.derivatives()[i]) {
        text.append(',').append(ShortestDecimal.format(slope));
      }
      text.append("\r\n");
    }
    return text.toString();
  }

  private static String quoted(String text) {
    return text.matches("[^,\"\r\n]*") ? text : '"' + text.replace("\"", "\"\"") + '"';
  }

  private static JsonObject json(Gradient found) {
    JsonObject all = new JsonObject();
    JsonArray outputs = new JsonArray();
    for (int i = 0; i < found.outputs().size(); i++) {
      JsonObject one = new JsonObject();
      one.addProperty("output", found.outputs().get(i));
      one.addProperty("unit", found.units().get(i));
      one.addProperty("value", found.values()[i]);
      JsonObject slopes = new JsonObject();
      for (int k = 0; k < found.parameters().size(); k++) {
        slopes.addProperty(found.parameters().get(k), found.derivatives()[i][k]);
      }
      one.add("derivatives", slopes);
      outputs.add(one);
    }
    all.add("outputs", outputs);
    JsonObject units = new JsonObject();
    for (int k = 0; k < found.parameters().size(); k++) {
      units.addProperty(found.parameters().get(k), found.parameterUnits().get(k));
    }
    all.add("parameterUnits", units);
    all.addProperty("method", found.method().label());
    all.addProperty("reason", found.reason());
    all.addProperty("steps", found.steps());
    JsonArray differenced = new JsonArray();
    found.differenced().forEach(differenced::add);
    all.add("differenced", differenced);
    return all;
  }
}
