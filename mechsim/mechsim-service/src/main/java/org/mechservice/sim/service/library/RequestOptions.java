package org.mechservice.sim.service.library;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.mechservice.idl.InvalidOption;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.OPT_ABS_TOL;
import org.mechservice.idl.OPT_ANALYSIS;
import org.mechservice.idl.OPT_CLOSURE;
import org.mechservice.idl.OPT_CODE;
import org.mechservice.idl.OPT_COLUMNS;
import org.mechservice.idl.OPT_COMPACT;
import org.mechservice.idl.OPT_CONTINUES;
import org.mechservice.idl.OPT_FORMULATION;
import org.mechservice.idl.OPT_INPUTS;
import org.mechservice.idl.OPT_INTEGRATOR;
import org.mechservice.idl.OPT_MAX_DRIFT;
import org.mechservice.idl.OPT_REL_TOL;
import org.mechservice.idl.OPT_SET;
import org.mechservice.idl.OPT_SILENCE;
import org.mechservice.idl.OPT_SIMULATION;
import org.mechservice.idl.OPT_SOURCE_PART;
import org.mechservice.idl.OPT_STANDALONE;
import org.mechservice.idl.OPT_STRICT;
import org.mechservice.idl.OPT_TEXT_PART;
import org.mechservice.idl.OPT_TUNABLE;
import org.mechservice.idl.OPT_T_END;
import org.mechservice.idl.OPT_T_STEP;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.sim.service.contract.ContractErrors;
import org.mechservice.solver.catalogue.Accuracy;
import org.mechservice.solver.catalogue.AnalysisKind;
import org.mechservice.solver.catalogue.SourceLanguage;

/**
 * The options of a request: the values of those that concern the run, by name, and how the model
 * file is to be read.
 */
public final class RequestOptions {
  private static final Set<String> KNOWN =
      new TreeSet<>(
          Set.of(
              OPT_SIMULATION.value,
              OPT_FORMULATION.value,
              OPT_CLOSURE.value,
              OPT_INTEGRATOR.value,
              OPT_REL_TOL.value,
              OPT_ABS_TOL.value,
              Accuracy.OPTION,
              OPT_T_END.value,
              OPT_T_STEP.value,
              OPT_COLUMNS.value,
              OPT_SET.value,
              OPT_TUNABLE.value,
              OPT_SOURCE_PART.value,
              OPT_TEXT_PART.value,
              SourceLanguage.OPTION,
              OPT_STANDALONE.value,
              OPT_STRICT.value,
              OPT_MAX_DRIFT.value,
              OPT_COMPACT.value,
              OPT_CODE.value,
              OPT_CONTINUES.value,
              OPT_ANALYSIS.value,
              OPT_INPUTS.value,
              OPT_SILENCE.value));

  /** Options that decide how the model file is read. */
  private static final Set<String> OF_READER =
      Set.of(OPT_SIMULATION.value, OPT_SET.value, OPT_TUNABLE.value, OPT_SILENCE.value);

  private final Map<String, String> texts;
  private final ReadOptions reading;

  private RequestOptions(Map<String, String> texts, ReadOptions reading) {
    this.texts = texts;
    this.reading = reading;
  }

  /**
   * Reads the options of a request.
   *
   * @throws InvalidOption if one is unknown or given twice, or an option of the reader has a value
   *     that cannot be used
   */
  public static RequestOptions of(NameValue[] options) throws InvalidOption {
    ReadOptions reading = reading(options);
    Map<String, String> given = new HashMap<>();
    for (NameValue option : options) {
      if (!KNOWN.contains(option.key)) {
        throw ContractErrors.option(
            option.key,
            "there is no option \"" + option.key + "\"; known are " + String.join(", ", KNOWN));
      }
      boolean ofReader = OF_READER.contains(option.key);
      if (!ofReader && given.put(option.key, option.text.strip()) != null) {
        throw ContractErrors.option(option.key, "option \"" + option.key + "\" is given twice");
      }
    }
    return new RequestOptions(given, reading);
  }

  private static ReadOptions reading(NameValue[] options) throws InvalidOption {
    Optional<String> simulation = Optional.empty();
    TreeMap<String, String> values = new TreeMap<>();
    TreeSet<String> tunable = new TreeSet<>();
    TreeSet<String> silenced = new TreeSet<>();
    for (NameValue option : options) {
      if (option.key.equals(OPT_SET.value)) {
        set(option.text, values);
      } else if (option.key.equals(OPT_TUNABLE.value)) {
        tunable.add(option.text.strip());
      } else if (option.key.equals(OPT_SILENCE.value)) {
        silenced.add(option.text.strip());
      } else if (option.key.equals(OPT_SIMULATION.value)) {
        simulation = Optional.of(option.text.strip());
      }
    }
    ReadOptions chosen = new ReadOptions(simulation, values, tunable).silencing(silenced);
    for (NameValue option : options) {
      if (option.key.equals(OPT_ANALYSIS.value)) {
        chosen = chosen.withAnalysis(analysis(option.text.strip()));
      } else if (option.key.equals(OPT_INPUTS.value)) {
        requireOutside(option.text.strip());
        chosen = chosen.withInputsFromOutside();
      }
    }
    return chosen;
  }

  private static AnalysisKind analysis(String label) throws InvalidOption {
    return AnalysisKind.of(label)
        .orElseThrow(
            () ->
                ContractErrors.option(
                    OPT_ANALYSIS.value,
                    "analysis is \"" + label + "\"; it must be one of " + AnalysisKind.labels()));
  }

  private static void requireOutside(String text) throws InvalidOption {
    if (!text.equals("outside")) {
      throw ContractErrors.option(
          OPT_INPUTS.value, "inputs is \"" + text + "\"; it must be outside, or left out");
    }
  }

  private static void set(String assignment, Map<String, String> values) throws InvalidOption {
    int equals = assignment.indexOf('=');
    if (equals < 1) {
      throw ContractErrors.option(
          OPT_SET.value, "option \"set\" is \"" + assignment + "\"; it must be PARAMETER=VALUE");
    }
    String name = assignment.substring(0, equals).strip();
    if (values.put(name, assignment.substring(equals + 1).strip()) != null) {
      throw ContractErrors.option(
          OPT_SET.value, "option \"set\" names parameter \"" + name + "\" twice");
    }
  }

  /** Returns how the model file is to be read: its simulation and its parameters. */
  public ReadOptions reading() {
    return reading;
  }

  boolean has(String name) {
    return texts.containsKey(name);
  }

  String text(String name, String otherwise) {
    return texts.getOrDefault(name, otherwise);
  }

  /** Returns a value of true or false; false where the option is not given. */
  boolean flag(String name) throws InvalidOption {
    String text = text(name, "false");
    return switch (text) {
      case "true" -> true;
      case "false" -> false;
      default ->
          throw ContractErrors.option(
              name, "option \"" + name + "\" is \"" + text + "\"; it must be true or false");
    };
  }

  double number(String name, double otherwise) throws InvalidOption {
    return has(name) ? number(name, text(name, "")) : otherwise;
  }

  double positive(String name, double otherwise, String unit) throws InvalidOption {
    return requirePositive(name, number(name, otherwise), unit);
  }

  double belowOne(String name, double otherwise) throws InvalidOption {
    double value = positive(name, otherwise, "");
    if (value >= 1) {
      throw ContractErrors.option(name, name + " is " + value + "; it must be below 1");
    }
    return value;
  }

  /**
   * Returns one number of a list.
   *
   * @param name of the option that has the list
   * @throws InvalidOption if it is none, or not positive
   */
  static double positiveOf(String name, String text) throws InvalidOption {
    return requirePositive(name, number(name, text), "");
  }

  private static double requirePositive(String name, double value, String unit)
      throws InvalidOption {
    if (value <= 0) {
      throw ContractErrors.option(
          name, (name + " is " + value + " " + unit).strip() + "; it must be positive");
    }
    return value;
  }

  private static double number(String name, String text) throws InvalidOption {
    try {
      double value = Double.parseDouble(text);
      // Java takes "1d" for a number, too.
      if (Double.isFinite(value) && !Character.isLetter(text.charAt(text.length() - 1))) {
        return value;
      }
    } catch (NumberFormatException e) {
      throw notANumber(name, text);
    }
    throw notANumber(name, text);
  }

  private static InvalidOption notANumber(String name, String text) {
    return ContractErrors.option(
        name, name + " is \"" + text + "\"; it must be a number such as 0.01 or 1e-6");
  }
}
