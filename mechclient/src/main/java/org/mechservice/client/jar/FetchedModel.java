package org.mechservice.client.jar;

import java.util.Optional;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;
import java.util.SortedMap;
import org.mechservice.client.failure.JarRefusedException;
import org.mechservice.guard.Confinement;
import org.mechservice.guard.ForceRelay;
import org.mechservice.guard.UserCode;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelSource;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.simulation.RuntimeSolver;

/**
 * A model that was fetched and is loaded in this process, with the solver of this process or one
 * that came with it.
 *
 * @param modelClass a {@link Model} or a {@link ModelSource}
 * @param solver runs it
 * @param jar it came in
 * @param userCode how the classes of its users run, if it has such: as a warning where nothing
 *     confines them, else empty
 */
record FetchedModel(
    Class<?> modelClass, Solver solver, VerifiedJar jar, Optional<String> userCode) {
  private static final Solver OWN_SOLVER = new RuntimeSolver();

  /**
   * Loads a model.
   *
   * @param runtimeJar the solver that came with it; empty: that of this process
   * @param consent whether classes of users may run where they cannot be confined
   * @throws JarRefusedException if the JARs do not fit this client or each other
   */
  static FetchedModel load(VerifiedJar jar, Optional<byte[]> runtimeJar, UserCode consent) {
    Optional<FetchedJar> runtime =
        runtimeJar.map(bytes -> FetchedJar.read(bytes, "the runtime JAR"));
    Optional<ClassLoader> userClasses = userClasses(jar.ofUsers(), consent);
    FetchedClasses classes = new FetchedClasses(jar.files(), runtime, userClasses);
    try {
      return new FetchedModel(
          modelClass(classes, jar.mainClass()),
          runtime.isPresent() ? solver(classes) : OWN_SOLVER,
          jar,
          userClasses.map(u -> consent.warning(Confinement.ofThisMachine()).orElse("")));
    } catch (ReflectiveOperationException | LinkageError | ServiceConfigurationError e) {
      throw VerifiedJar.refused("cannot be loaded: " + e);
    }
  }

  /**
   * Returns the loader of what the model's users have written: classes that hand each call on to a
   * confined process.
   */
  private static Optional<ClassLoader> userClasses(
      SortedMap<String, byte[]> files, UserCode consent) {
    if (files.isEmpty()) {
      return Optional.empty();
    }
    try {
      return Optional.of(new ForceRelay(files, consent).newLoader());
    } catch (IllegalArgumentException e) {
      throw new JarRefusedException(
          MessageCode.NO_CONFINEMENT.code(), String.valueOf(e.getMessage()));
    }
  }

  private static Class<?> modelClass(FetchedClasses classes, String mainClass)
      throws ReflectiveOperationException {
    Class<?> type = classes.loadClass(mainClass);
    if (type.getClassLoader() != classes) {
      throw VerifiedJar.refused("names " + mainClass + ", which it does not contain");
    }
    if (!Model.class.isAssignableFrom(type) && !ModelSource.class.isAssignableFrom(type)) {
      throw VerifiedJar.refused("names " + mainClass + ", which is no model");
    }
    return type;
  }

  private static Solver solver(FetchedClasses classes) {
    return ServiceLoader.load(Solver.class, classes)
        .findFirst()
        .orElseThrow(() -> VerifiedJar.refused("came with a runtime JAR that offers no solver"));
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
      throw VerifiedJar.refused("cannot be loaded: " + e);
    }
  }
}
