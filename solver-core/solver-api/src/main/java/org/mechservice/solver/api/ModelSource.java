package org.mechservice.solver.api;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * A class of a model JAR that creates the model, such as the compact form, instead of implementing
 * it.
 */
public interface ModelSource {
  /** Returns a new model, for one run. */
  Model model();

  /** Returns the parameters that may be changed before a run. */
  default List<TunableParameter> parameters() {
    return List.of();
  }

  /**
   * Returns a new model, for one run, with other values of its parameters.
   *
   * @param values in the order and units of {@link #parameters}
   */
  default Model model(double[] values) {
    return model();
  }

  /**
   * Returns a new model, for one run, with other values of some parameters.
   *
   * @param values numbers by the parameters' names, in their units
   * @throws IllegalArgumentException S-125 if a parameter cannot be set, S-126 if a value is no
   *     finite number; the message says so
   */
  default Model model(Map<String, String> values) {
    if (values.isEmpty()) {
      return model();
    }
    return model(numbers(parameters(), values));
  }

  /**
   * Returns the values of all parameters, some of which are set.
   *
   * @param parameters those that may be set
   * @param values numbers by the parameters' names, in their units
   * @throws IllegalArgumentException S-125 if a parameter cannot be set, S-126 if a value is no
   *     finite number; the message says so
   */
  static double[] numbers(List<TunableParameter> parameters, Map<String, String> values) {
    Map<String, String> left = new TreeMap<>(values);
    double[] numbers = new double[parameters.size()];
    for (int i = 0; i < numbers.length; i++) {
      TunableParameter parameter = parameters.get(i);
      String given = left.remove(parameter.name());
      numbers[i] = given == null ? parameter.value() : number(parameter, given.strip());
    }
    if (!left.isEmpty()) {
      throw settled(left.keySet().iterator().next(), parameters);
    }
    return numbers;
  }

  private static double number(TunableParameter parameter, String given) {
    try {
      double number = Double.parseDouble(given);
      if (Double.isFinite(number) && !Character.isLetter(given.charAt(given.length() - 1))) {
        return number;
      }
    } catch (NumberFormatException e) {
      throw notANumber(parameter, given);
    }
    throw notANumber(parameter, given);
  }

  private static IllegalArgumentException notANumber(TunableParameter parameter, String given) {
    return new IllegalArgumentException(
        MessageCode.PARAMETER_NOT_A_NUMBER
            + " parameter \""
            + parameter.name()
            + "\" is set to \""
            + given
            + "\"; it takes a number, in the unit "
            + parameter.unit());
  }

  private static IllegalArgumentException settled(String name, List<TunableParameter> parameters) {
    String tunable =
        parameters.stream().map(TunableParameter::name).collect(Collectors.joining(", "));
    return new IllegalArgumentException(
        MessageCode.PARAMETER_FIXED
            + " parameter \""
            + name
            + "\" cannot be set in this model as it was built, where "
            + (tunable.isEmpty() ? "none can" : "one can set " + tunable)
            + "; build it with mech build MODEL.xml -o FILE.jar --standalone --tunable "
            + name
            + ", or with --set "
            + name
            + "=VALUE");
  }

  /**
   * Returns an instance of a JAR's model class as a source of models.
   *
   * @param instance a source, or a model, which is then the only one the source has
   * @throws ClassCastException if it is neither
   */
  static ModelSource from(Object instance) {
    if (instance instanceof ModelSource source) {
      return source;
    }
    Model model = (Model) instance;
    return () -> model;
  }

  /**
   * Returns the model of an instance of a JAR's model class.
   *
   * @param instance a {@link Model} or a source of one
   * @throws ClassCastException if it is neither
   */
  static Model of(Object instance) {
    return from(instance).model();
  }
}
