package org.mechservice.solver.standalone;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeMap;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Accuracy;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * The command line of a model's own JAR.
 *
 * @param request the requested run
 * @param parameters values of parameters by their names
 * @param out CSV file to write; empty for none
 * @param quiet print nothing but errors
 * @param json print the report as JSON
 * @param help print the options and do nothing
 */
record StandaloneOptions(
    RunRequest request,
    Map<String, String> parameters,
    String out,
    boolean quiet,
    boolean json,
    boolean help) {

  static final String HELP =
      """
      Options:
        --t-end T      end of the run, s
        --t-step H     distance of the output rows, s
        --rtol R       relative tolerance
        --atol A       absolute tolerance, SI: one, or four A;B;C;D for positions, angles,
                       velocities, angular velocities
        --accuracy A   standard, or strict: smaller errors at the same tolerances
        --set P=V      value of a tunable parameter, in its unit; once for each
        --out FILE.csv write the rows as CSV, and their units beside it
        --columns C    column groups besides joints, separated by commas, or all
        --strict       let the first warning end the run
        --max-drift R  end the run where its energy balance drifts by more than R times the
                       energy scale
        --quiet        print nothing but errors
        --json         print the report as JSON
        --help         print this
      Exit status: 0 done, 1 the simulation failed, 2 bad usage.
      """;

  /**
   * Reads a command line.
   *
   * @param args the words of the command line
   * @param defaults settings the model was built with
   * @param available column groups of the model
   * @param shown default groups among them
   * @throws OptionException if an option is unknown, lacks its value, or has one that cannot be
   *     used
   */
  static StandaloneOptions parse(
      String[] args, RunSettings defaults, Set<ColumnGroup> available, Set<ColumnGroup> shown)
      throws OptionException {
    Parser parser = new Parser(args, available, shown);
    while (parser.next < args.length) {
      parser.take(args[parser.next++]);
    }
    RunSettings settings =
        defaults
            .withOutput(parser.tEnd.orElse(defaults.tEnd()), parser.tStep.orElse(defaults.tStep()))
            .withRelativeTolerance(parser.rtol.orElse(defaults.relativeTolerance()))
            .withAccuracy(parser.accuracy.orElse(defaults.accuracy()));
    return new StandaloneOptions(
        new RunRequest(
            parser.atol.isEmpty() ? settings : settings.withTolerances(parser.atol),
            parser.columns,
            parser.strict,
            parser.maxDrift),
        parser.parameters,
        parser.out,
        parser.quiet,
        parser.json,
        parser.help);
  }

  private static final class Parser {
    private final String[] args;
    private final Set<ColumnGroup> available;
    private int next;
    private OptionalDouble tEnd = OptionalDouble.empty();
    private OptionalDouble tStep = OptionalDouble.empty();
    private OptionalDouble rtol = OptionalDouble.empty();
    private List<Double> atol = List.of();
    private Optional<Accuracy> accuracy = Optional.empty();
    private Set<ColumnGroup> columns;
    private final Map<String, String> parameters = new TreeMap<>();
    private String out = "";
    private boolean strict;
    private OptionalDouble maxDrift = OptionalDouble.empty();
    private boolean quiet;
    private boolean json;
    private boolean help;

    Parser(String[] args, Set<ColumnGroup> available, Set<ColumnGroup> shown) {
      this.args = args;
      this.available = available;
      columns = shown;
    }

    void take(String word) throws OptionException {
      int equals = word.indexOf('=');
      String option = equals < 0 ? word : word.substring(0, equals);
      String inline = equals < 0 ? "" : word.substring(equals + 1);
      switch (option) {
        case "--t-end" -> tEnd = OptionalDouble.of(number(option, inline));
        case "--t-step" -> tStep = OptionalDouble.of(number(option, inline));
        case "--rtol" -> rtol = OptionalDouble.of(number(option, inline));
        case "--atol" -> atol = tolerances(value(option, inline));
        case "--accuracy" -> accuracy = Optional.of(accuracy(value(option, inline)));
        case "--set" -> set(value(option, inline));
        case "--out" -> out = csv(value(option, inline));
        case "--columns" -> columns = groups(value(option, inline));
        case "--strict" -> strict = true;
        case "--max-drift" -> maxDrift = OptionalDouble.of(positive(option, inline));
        case "--quiet" -> quiet = true;
        case "--json" -> json = true;
        case "--help" -> help = true;
        default ->
            throw new OptionException(
                MessageCode.STANDALONE_USAGE + " unknown option " + word + "\n" + HELP);
      }
    }

    private void set(String assignment) throws OptionException {
      int equals = assignment.indexOf('=');
      if (equals < 1) {
        throw new OptionException(
            MessageCode.STANDALONE_USAGE
                + " --set takes PARAMETER=VALUE, not \""
                + assignment
                + "\"");
      }
      String name = assignment.substring(0, equals).strip();
      if (parameters.put(name, assignment.substring(equals + 1)) != null) {
        throw new OptionException(
            MessageCode.STANDALONE_USAGE + " --set names parameter \"" + name + "\" twice");
      }
    }

    private static String csv(String file) throws OptionException {
      if (!file.toLowerCase(Locale.ROOT).endsWith(".csv")) {
        throw new OptionException(
            MessageCode.STANDALONE_USAGE
                + " --out "
                + file
                + ": a JAR of a model writes .csv files only; mech simulate writes the other"
                + " formats");
      }
      return file;
    }

    private String value(String option, String inline) throws OptionException {
      if (!inline.isEmpty()) {
        return inline;
      }
      if (next == args.length) {
        throw new OptionException(MessageCode.STANDALONE_USAGE + " " + option + " lacks its value");
      }
      return args[next++];
    }

    private static List<Double> tolerances(String text) throws OptionException {
      List<Double> tolerances = new ArrayList<>();
      for (String one : text.split(";", -1)) {
        tolerances.add(parse("--atol", one));
      }
      if (tolerances.size() != 1 && tolerances.size() != 4) {
        throw new OptionException(
            MessageCode.STANDALONE_USAGE
                + " --atol takes one number or four, not \""
                + text
                + "\"");
      }
      return tolerances;
    }

    private static Accuracy accuracy(String label) throws OptionException {
      try {
        return Accuracy.of(label);
      } catch (IllegalArgumentException e) {
        throw new OptionException(MessageCode.STANDALONE_USAGE + " --" + e.getMessage());
      }
    }

    private double number(String option, String inline) throws OptionException {
      return parse(option, value(option, inline));
    }

    private double positive(String option, String inline) throws OptionException {
      double number = number(option, inline);
      if (number <= 0) {
        throw new OptionException(
            MessageCode.STANDALONE_USAGE + " " + option + " must be positive, not " + number);
      }
      return number;
    }

    private static double parse(String option, String text) throws OptionException {
      try {
        double number = Double.parseDouble(text);
        if (Double.isFinite(number)) {
          return number;
        }
      } catch (NumberFormatException e) {
        // Said below, as for numbers that are not finite.
      }
      throw new OptionException(
          MessageCode.STANDALONE_USAGE
              + " "
              + option
              + " takes a finite number, not \""
              + text
              + "\"");
    }

    private Set<ColumnGroup> groups(String list) throws OptionException {
      if (list.equals("all")) {
        return available;
      }
      Set<ColumnGroup> groups = EnumSet.of(ColumnGroup.JOINTS);
      for (String name : list.split(",", -1)) {
        groups.add(group(name.strip().toLowerCase(Locale.ROOT)));
      }
      return groups;
    }

    private static ColumnGroup group(String name) throws OptionException {
      StringBuilder known = new StringBuilder();
      for (ColumnGroup group : ColumnGroup.values()) {
        if (group.label().equals(name)) {
          return group;
        }
        known.append(group.label()).append(", ");
      }
      throw new OptionException(
          MessageCode.STANDALONE_USAGE
              + " --columns: \""
              + name
              + "\" is no column group; there are "
              + known
              + "and all");
    }
  }
}
