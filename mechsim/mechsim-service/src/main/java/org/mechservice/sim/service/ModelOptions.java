package org.mechservice.sim.service;

import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.mechservice.idl.InvalidOption;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.OPT_SET;
import org.mechservice.idl.OPT_SIMULATION;
import org.mechservice.idl.OPT_TUNABLE;
import org.mechservice.mechml.ReadOptions;

/**
 * The options of a request that decide how a model file is read: its simulation, its parameters.
 */
final class ModelOptions {
  /** The keys of these options. */
  static final Set<String> KEYS = Set.of(OPT_SIMULATION.value, OPT_SET.value, OPT_TUNABLE.value);

  private ModelOptions() {}

  /**
   * Reads them; the others are left aside.
   *
   * @throws InvalidOption if a value cannot be used, or something is given twice
   */
  static ReadOptions parse(NameValue[] options) throws InvalidOption {
    Optional<String> simulation = Optional.empty();
    TreeMap<String, String> values = new TreeMap<>();
    TreeSet<String> tunable = new TreeSet<>();
    for (NameValue option : options) {
      if (option.key.equals(OPT_SET.value)) {
        set(option.text, values);
      } else if (option.key.equals(OPT_TUNABLE.value)) {
        tunable.add(option.text.strip());
      } else if (option.key.equals(OPT_SIMULATION.value)) {
        simulation = Optional.of(option.text.strip());
      }
    }
    return new ReadOptions(simulation, values, tunable);
  }

  private static void set(String assignment, Map<String, String> values) throws InvalidOption {
    int equals = assignment.indexOf('=');
    if (equals < 1) {
      throw Refusal.option(
          OPT_SET.value, "option \"set\" is \"" + assignment + "\"; it must be PARAMETER=VALUE");
    }
    String name = assignment.substring(0, equals).strip();
    if (values.put(name, assignment.substring(equals + 1).strip()) != null) {
      throw Refusal.option(OPT_SET.value, "option \"set\" names parameter \"" + name + "\" twice");
    }
  }
}
