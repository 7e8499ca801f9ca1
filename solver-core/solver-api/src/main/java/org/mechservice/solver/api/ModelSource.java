package org.mechservice.solver.api;

import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.jar.JarFile;
import java.util.jar.Manifest;
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
    List<TunableParameter> parameters = parameters();
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
    return model(numbers);
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
   * Loads the model of a JAR, whose manifest names its class. The class sees those of this program,
   * and so does not need the solver that a standalone JAR carries.
   *
   * @param jar as {@code mech build} writes it
   * @throws IOException if the file cannot be read, or is no JAR of a model
   */
  static ModelSource load(Path jar) throws IOException {
    String name;
    try (JarFile file = new JarFile(jar.toFile())) {
      Manifest manifest = file.getManifest();
      name = manifest == null ? null : manifest.getMainAttributes().getValue("Mech-Model");
    }
    if (name == null) {
      throw new IOException(
          MessageCode.STANDALONE_JAR_DAMAGED
              + " "
              + jar
              + " is no JAR of a model: its manifest has no Mech-Model; make one with mech build"
              + " MODEL.xml -o FILE.jar");
    }
    try {
      URLClassLoader loader =
          new URLClassLoader(new URL[] {jar.toUri().toURL()}, ModelSource.class.getClassLoader());
      return from(loader.loadClass(name).getDeclaredConstructor().newInstance());
    } catch (ReflectiveOperationException | LinkageError e) {
      throw new IOException(
          MessageCode.STANDALONE_JAR_DAMAGED + " the model in " + jar + " cannot be loaded: " + e,
          e);
    }
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
