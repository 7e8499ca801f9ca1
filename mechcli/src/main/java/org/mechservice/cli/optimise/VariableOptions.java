package org.mechservice.cli.optimise;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.mechservice.cli.model.ParameterOption;
import org.mechservice.cli.model.UserCodeOption;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.library.MechModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.solver.api.ModelParameter;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.study.ModelInputs;
import org.mechservice.study.optimise.DesignVariable;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** The model and its variables, parameters that may be changed between bounds. */
final class VariableOptions {
  @Parameters(paramLabel = "MODEL.xml", description = "Model in MechML.")
  private Path file = Path.of("");

  @Option(
      names = "--by",
      required = true,
      arity = "1..*",
      paramLabel = "P=LOW:HIGH[:START]",
      description =
          "Parameters to find, each with its bounds and, if wanted, its first value, in its unit;"
              + " the first value is else that of the file, or the middle if that is outside.")
  private List<String> by = List.of();

  @Option(
      names = "--simulation",
      paramLabel = "NAME",
      description = "Name or number of the simulation of the file (default: the first).")
  private Optional<String> simulation = Optional.empty();

  @Option(
      names = "--step",
      paramLabel = "PART",
      defaultValue = "1e-4",
      description =
          "Step of differences, as a part of each parameter's range (default: ${DEFAULT-VALUE}).")
  private double step;

  @Option(
      names = "--gradient",
      paramLabel = "HOW",
      defaultValue = "auto",
      description =
          "exact: derivatives by integrating them along with the motion; differences: of whole"
              + " runs; auto: exact where the model has them and they take less time (default:"
              + " ${DEFAULT-VALUE}).")
  private String gradient = "auto";

  @Mixin private UserCodeOption userCode = new UserCodeOption();

  @Mixin private ParameterOption settings = new ParameterOption();

  double step() {
    return step;
  }

  /** A calculation that is made with exact derivatives or without. */
  interface Made<T> {
    T made(boolean exact) throws MechmlException;
  }

  /**
   * The result of the calculation, and the kind of its derivatives.
   *
   * @param derivatives how derivatives are found, for the answer
   */
  record Derived<T>(T made, String derivatives) {}

  /**
   * Makes something with exact derivatives, unless differences are asked for, there are none, or
   * they take more time.
   *
   * @throws IllegalArgumentException if exact derivatives are asked for and there are none
   */
  <T> Derived<T> derived(MechModel model, List<DesignVariable> variables, Made<T> maker)
      throws MechmlException {
    if (!List.of("auto", "exact", "differences").contains(gradient)) {
      throw new IllegalArgumentException(
          "--gradient is \"" + gradient + "\"; there are auto, exact and differences");
    } else if (gradient.equals("differences")) {
      return new Derived<>(maker.made(false), "differences of runs");
    } else if (gradient.equals("auto") && isOneOfTheEquations(model, variables)) {
      return new Derived<>(
          maker.made(false),
          "differences of runs, since they take less time for one parameter of masses or geometry");
    }
    try {
      return new Derived<>(maker.made(true), "exact derivatives");
    } catch (IllegalArgumentException e) {
      if (gradient.equals("exact")) {
        throw e;
      }
      T without = maker.made(false);
      return new Derived<>(without, "differences of runs, since " + e.getMessage());
    }
  }

  /**
   * Returns whether the only variable is a parameter for which equations are made anew: five times
   * for each derivative, where a difference takes two runs.
   */
  private static boolean isOneOfTheEquations(MechModel model, List<DesignVariable> variables)
      throws MechmlException {
    return variables.size() == 1
        && ModelInputs.of(model, List.of(variables.get(0).name())).names().isEmpty();
  }

  /** Returns the name of the model's file. */
  String fileName() {
    return String.valueOf(file.getFileName());
  }

  /**
   * Reads the model, with the parameters that have been set.
   *
   * @param err is told of classes of forces that run unconfined
   * @throws UsageException if it cannot be used
   */
  MechModel model(PrintWriter err) throws IOException {
    try {
      MechModel model = MechModel.read(file, userCode.consent());
      if (simulation.isPresent()) {
        model = model.simulation(simulation.get());
      }
      for (Map.Entry<String, String> value : settings.values().entrySet()) {
        model = model.set(value.getKey(), value.getValue());
      }
      model.userCodeWarning().ifPresent(err::println);
      return model;
    } catch (MechmlException e) {
      throw new UsageException(String.valueOf(e.getMessage()));
    }
  }

  /**
   * Returns the parameters to find.
   *
   * @throws IllegalArgumentException if one does not exist or its bounds are none
   */
  List<DesignVariable> variables(MechModel model) {
    Map<String, ModelParameter> known =
        model.parameters().stream()
            .collect(Collectors.toMap(ModelParameter::name, parameter -> parameter));
    List<String> names = model.parameters().stream().map(ModelParameter::name).toList();
    List<DesignVariable> variables = new ArrayList<>();
    for (String text : by) {
      int equals = text.indexOf('=');
      String[] numbers = text.substring(equals + 1).split(":", -1);
      if (equals < 1 || numbers.length < 2 || numbers.length > 3) {
        throw new IllegalArgumentException(
            "--by takes P=LOW:HIGH or P=LOW:HIGH:START, such as c=100:5000, not \""
                + text
                + "\""
                + (text.contains("=") ? "" : "; write the model's file before the options"));
      }
      String name = text.substring(0, equals).strip();
      ModelParameter parameter = known.get(name);
      if (parameter == null) {
        throw new IllegalArgumentException(
            "the model has no parameter \""
                + name
                + '"'
                + NearestName.suggestion(name, names)
                + (names.isEmpty() ? "" : "; it has " + String.join(", ", names)));
      }
      variables.add(variable(parameter, numbers));
    }
    return variables;
  }

  private static DesignVariable variable(ModelParameter parameter, String[] numbers) {
    double low = number(parameter, numbers[0]);
    double high = number(parameter, numbers[1]);
    if (numbers.length == 3) {
      return new DesignVariable(parameter.name(), low, high, number(parameter, numbers[2]));
    }
    double value = parameter.value();
    return value >= low && value <= high
        ? new DesignVariable(parameter.name(), low, high, value)
        : DesignVariable.between(parameter.name(), low, high);
  }

  private static double number(ModelParameter parameter, String text) {
    try {
      return Double.parseDouble(text.strip());
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException(
          "--by " + parameter.name() + ": \"" + text + "\" is no number", e);
    }
  }

  /** Returns a refusal with its code, unless the message has one. */
  static UsageException refused(MessageCode code, Exception why) {
    String text = String.valueOf(why.getMessage());
    boolean coded = text.matches("(?s)[MNS]-\\d{3} .*") || why instanceof MechmlException;
    return new UsageException(coded ? text : code + " " + text);
  }
}
