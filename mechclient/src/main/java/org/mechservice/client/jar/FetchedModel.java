package org.mechservice.client.jar;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;
import java.util.Set;
import org.mechservice.client.failure.JarRefusedException;
import org.mechservice.client.run.LocalRun;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelSource;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.text.Sha256;

/**
 * A model and the solver that came with it, loaded separately from the client's own classes.
 *
 * @param modelClass a {@link Model} or a {@link ModelSource}
 * @param solver the server's solver
 * @param sha256 of the model's JAR
 * @param formulationReason reason for the model's formulation; empty if unknown
 * @param shown column groups its file selects
 */
public record FetchedModel(
    Class<?> modelClass,
    Solver solver,
    String sha256,
    Optional<String> formulationReason,
    Set<ColumnGroup> shown) {
  private static final String SHOWN_ATTRIBUTE = "Mech-Columns-Shown";
  private static final String REASON_ATTRIBUTE = "Mech-Formulation-Reason";

  /**
   * Loads a model with its solver.
   *
   * @throws JarRefusedException if they do not fit this client or each other
   */
  public static FetchedModel load(BuiltJar modelJar, byte[] runtimeJar) {
    FetchedJar model = FetchedJar.read(modelJar.bytes(), "the model JAR");
    FetchedJar runtime = FetchedJar.read(runtimeJar, "the runtime JAR");
    FetchedClasses classes = new FetchedClasses(List.of(model, runtime));
    try {
      return new FetchedModel(
          modelClass(classes, modelJar.mainClass()),
          solver(classes),
          Sha256.of(modelJar.bytes()),
          model.attribute(REASON_ATTRIBUTE),
          ColumnGroup.of(model.attribute(SHOWN_ATTRIBUTE).orElse(ColumnGroup.JOINTS.label())));
    } catch (ReflectiveOperationException | LinkageError | ServiceConfigurationError e) {
      throw refused("cannot be loaded: " + e);
    }
  }

  private static Class<?> modelClass(FetchedClasses classes, String mainClass)
      throws ReflectiveOperationException {
    Class<?> type = classes.loadClass(mainClass);
    if (!Model.class.isAssignableFrom(type) && !ModelSource.class.isAssignableFrom(type)) {
      throw refused("names " + mainClass + ", which is no model");
    }
    return type;
  }

  private static Solver solver(FetchedClasses classes) {
    return ServiceLoader.load(Solver.class, classes)
        .findFirst()
        .orElseThrow(() -> refused("came with a runtime JAR that offers no solver"));
  }

  private static JarRefusedException refused(String why) {
    return new JarRefusedException(MessageCode.JAR_REFUSED.code(), "the model JAR " + why);
  }

  /**
   * Returns a new source of the model: one for each run.
   *
   * @throws JarRefusedException if the class cannot be used
   */
  ModelSource newSource() {
    try {
      return ModelSource.from(modelClass.getDeclaredConstructor().newInstance());
    } catch (ReflectiveOperationException | LinkageError e) {
      throw refused("cannot be loaded: " + e);
    }
  }

  /**
   * Prepares a run of the model in this process.
   *
   * @param columns column groups asked for; empty: those its file selects
   * @param strict whether the first warning ends the run
   * @param maxDrift drift of the energy balance, over the energy scale, that ends it
   * @param silenced warnings that it does not give
   */
  public LocalRun prepare(
      Optional<Set<ColumnGroup>> columns,
      boolean strict,
      OptionalDouble maxDrift,
      Set<MessageCode> silenced,
      Map<String, Object> facts) {
    ModelSource source = newSource();
    Model model = source.model();
    RunRequest request =
        new RunRequest(
            model.description().defaults(), columns.orElse(shown), strict, maxDrift, silenced);
    return new LocalRun(source, model, solver, sha256, request, facts);
  }
}
