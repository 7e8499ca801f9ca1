package org.mechservice.cli.optimise;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonNull;
import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.cli.shell.MechVersion;
import org.mechservice.cli.shell.OutputFile;
import org.mechservice.library.MechModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.result.SignalTable;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.study.identify.Identification;
import org.mechservice.study.identify.Measurements;
import org.mechservice.study.identify.Profile;
import org.mechservice.study.optimise.Derivatives;
import org.mechservice.study.optimise.DesignVariable;
import org.mechservice.study.optimise.PointFailedException;
import org.mechservice.study.optimise.Response;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code mech identify}: the parameters for which a model agrees best with measurements. */
@Command(
    name = "identify",
    description = {
      "Finds the values of parameters for which outputs agree best with measured ones, and says how"
          + " well the measurements determine each.",
      "The first column of the measurements is the time; a column NAME.sigma has the standard"
          + " deviations of the column NAME."
    },
    footer =
        "mech identify model.xml --data measured.csv --by k=1e3:1e5 c=10:1000 --report fit.html",
    mixinStandardHelpOptions = true,
    versionProvider = MechVersion.class)
public final class IdentifyCommand implements Callable<Integer> {
  private static final Gson JSON =
      new GsonBuilder().setPrettyPrinting().disableHtmlEscaping().serializeNulls().create();

  @Mixin private VariableOptions design = new VariableOptions();

  @Option(
      names = "--data",
      required = true,
      paramLabel = "FILE.csv",
      description = "Measured values; also .tsv, .mat, .json and .parquet.")
  private Path data = Path.of("");

  @Option(
      names = "--column",
      paramLabel = "MEASURED[=OUTPUT]",
      description =
          "Columns to use, with the output that each measures (default: all, each the output of"
              + " its name).")
  private List<String> columns = List.of();

  @Option(
      names = "--sigma",
      paramLabel = "MEASURED=VALUE",
      description = "Standard deviation of all values of a column, in its unit.")
  private List<String> sigmas = List.of();

  @Option(
      names = "--level",
      paramLabel = "LEVEL",
      defaultValue = "0.95",
      description = "Level of the confidence intervals (default: ${DEFAULT-VALUE}).")
  private double level;

  @Option(
      names = "--profile",
      arity = "1..*",
      paramLabel = "PARAMETER",
      description =
          "Parameters whose intervals are computed and the model is not taken as linear: each is"
              + " held at values beside the found one, and the others are fitted anew.")
  private List<String> profiled = List.of();

  @Option(
      names = "--report",
      paramLabel = "FILE.html",
      description = "Write a page with the parameters and pictures of fit and residuals.")
  private @Nullable Path report;

  @Option(names = "--json", description = "Print one JSON object.")
  private boolean json;

  /** How derivatives were found, for the answer. */
  private String derivatives = "";

  @Spec private CommandSpec spec = CommandSpec.create();

  @Override
  public Integer call() throws IOException {
    if (report != null) {
      OutputFile.requireUsable(report);
    }
    MechModel model = design.model(spec.commandLine().getErr());
    Measurements measured = measurements(SignalTable.read(data));
    Identification found;
    List<Profile> profiles = new ArrayList<>();
    try {
      if (!(level > 0 && level < 1)) {
        throw new IllegalArgumentException(
            "--level is " + level + "; it must be between 0 and 1, such as 0.95");
      }
      List<DesignVariable> variables = design.variables(model);
      VariableOptions.Derived<Optional<Derivatives>> derived =
          design.derived(
              model,
              variables,
              exact -> exact ? Optional.of(measured.slopes(model, variables)) : Optional.empty());
      derivatives = derived.derivatives();
      Response residuals = measured.residuals(model, variables);
      List<String> names = variables.stream().map(DesignVariable::name).toList();
      for (String name : profiled) {
        if (!names.contains(name)) {
          throw new IllegalArgumentException(
              "--profile "
                  + name
                  + ": no parameter of that name is identified; there are "
                  + String.join(", ", names));
        }
      }
      found = Identification.of(variables, residuals, design.step(), derived.made());
      for (String name : profiled) {
        profiles.add(
            Profile.of(
                found, names.indexOf(name), residuals, design.step(), derived.made(), level));
      }
    } catch (IllegalArgumentException | MechmlException e) {
      throw VariableOptions.refused(MessageCode.DESIGN_UNUSABLE, e);
    } catch (PointFailedException e) {
      spec.commandLine().getErr().println(MessageCode.NO_POINT_COMPUTED + " " + e.getMessage());
      return ExitStatus.SIMULATION_FAILED;
    }
    if (report != null) {
      String page = FitPage.of(design.fileName(), found, measured, profiles, level);
      OutputFile.write(report, page.getBytes(StandardCharsets.UTF_8));
    }
    PrintWriter out = spec.commandLine().getOut();
    out.println(json ? JSON.toJson(json(found, profiles)) : text(found, profiles));
    out.flush();
    found
        .undetermined()
        .forEach(
            words ->
                spec.commandLine().getErr().println(MessageCode.NOT_IDENTIFIABLE + " " + words));
    return ExitStatus.DONE;
  }

  private Measurements measurements(SignalTable table) {
    try {
      Map<String, String> outputs = new LinkedHashMap<>();
      for (String column : columns) {
        int equals = column.indexOf('=');
        String name = equals < 0 ? column : column.substring(0, equals);
        outputs.put(name.strip(), column.substring(equals + 1).strip());
      }
      Map<String, Double> deviations = new LinkedHashMap<>();
      for (String sigma : sigmas) {
        int equals = sigma.indexOf('=');
        try {
          deviations.put(
              sigma.substring(0, Math.max(0, equals)).strip(),
              Double.parseDouble(sigma.substring(equals + 1).strip()));
        } catch (NumberFormatException e) {
          throw new IllegalArgumentException(
              "--sigma takes MEASURED=VALUE, such as x=0.01, not \"" + sigma + "\"", e);
        }
      }
      return Measurements.of(table, outputs, deviations);
    } catch (IllegalArgumentException e) {
      throw VariableOptions.refused(MessageCode.MEASUREMENTS_UNUSABLE, e);
    }
  }

  private String text(Identification found, List<Profile> profiles) {
    StringBuilder text = new StringBuilder();
    for (int j = 0; j < found.values().length; j++) {
      String place = OptimiseCommand.place(found.bound(j));
      text.append(found.variables().get(j).name())
          .append(" = ")
          .append(OptimiseCommand.shown(found.values()[j]))
          .append(interval(found, j, level))
          .append(place.isEmpty() ? "" : "  (" + place + ")")
          .append('\n');
    }
    for (Profile profile : profiles) {
      text.append(sentence(found, profile)).append('\n');
    }
    return text.append("noise ")
        .append(OptimiseCommand.shown(found.noise()))
        .append(" standard deviations, ")
        .append(OptimiseCommand.counted(found.residuals().length, "measured value"))
        .append(", ")
        .append(OptimiseCommand.counted(found.runs(), "run"))
        .append(", ")
        .append(derivatives)
        .toString();
  }

  /** Returns the interval of a profile in words. */
  static String sentence(Identification found, Profile profile) {
    DesignVariable variable = found.variables().get(profile.variable());
    return "profile of "
        + variable.name()
        + ": from "
        + profile.lower().map(OptimiseCommand::shown).orElse("below what was tried")
        + " to "
        + profile.upper().map(OptimiseCommand::shown).orElse("above what was tried")
        + ", "
        + OptimiseCommand.counted(profile.runs(), "run");
  }

  /** Returns the half width of an interval, or that there is none. */
  static String interval(Identification found, int variable, double level) {
    return Double.isInfinite(found.deviations()[variable])
        ? "  not determined by the data"
        : " ± " + OptimiseCommand.shown(found.halfWidth(variable, level));
  }

  private JsonObject json(Identification found, List<Profile> profiles) {
    JsonObject all = new JsonObject();
    JsonArray parameters = new JsonArray();
    for (int j = 0; j < found.values().length; j++) {
      JsonObject one = new JsonObject();
      one.addProperty("name", found.variables().get(j).name());
      one.addProperty("value", found.values()[j]);
      one.add("deviation", finite(found.deviations()[j]));
      one.add("halfWidth", finite(found.halfWidth(j, level)));
      one.addProperty("atBound", found.bound(j) != 0);
      parameters.add(one);
    }
    all.add("parameters", parameters);
    all.addProperty("level", level);
    JsonArray correlation = new JsonArray();
    for (double[] row : found.correlation()) {
      JsonArray cells = new JsonArray();
      for (double cell : row) {
        cells.add(finite(cell));
      }
      correlation.add(cells);
    }
    all.add("correlation", correlation);
    JsonArray singular = new JsonArray();
    for (double value : found.singularValues()) {
      singular.add(value);
    }
    all.add("singularValues", singular);
    JsonArray undetermined = new JsonArray();
    found.undetermined().forEach(undetermined::add);
    all.add("undetermined", undetermined);
    if (!profiles.isEmpty()) {
      JsonArray curves = new JsonArray();
      for (Profile profile : profiles) {
        JsonObject one = new JsonObject();
        one.addProperty("name", found.variables().get(profile.variable()).name());
        one.add("lower", finite(profile.lower().orElse(Double.NaN)));
        one.add("upper", finite(profile.upper().orElse(Double.NaN)));
        JsonArray points = new JsonArray();
        for (double[] point : profile.points()) {
          JsonObject each = new JsonObject();
          each.addProperty("value", point[0]);
          each.addProperty("tau", point[1]);
          points.add(each);
        }
        one.add("points", points);
        curves.add(one);
      }
      all.add("profiles", curves);
    }
    all.addProperty("noise", found.noise());
    all.addProperty("measuredValues", found.residuals().length);
    all.addProperty("runs", found.runs());
    return all;
  }

  private static JsonElement finite(double value) {
    return Double.isFinite(value) ? new JsonPrimitive(value) : JsonNull.INSTANCE;
  }
}
