package org.mechservice.client.jar;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import org.mechservice.client.failure.JarRefusedException;
import org.mechservice.client.run.LocalRun;
import org.mechservice.guard.BytecodeVerifier;
import org.mechservice.guard.Confinement;
import org.mechservice.guard.ForceRelay;
import org.mechservice.guard.UserCode;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelSource;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.RunNotes;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.simulation.RuntimeSolver;
import org.mechservice.solver.text.Sha256;

/**
 * A model that was fetched, with the solver of this process or one that came with it.
 *
 * @param modelClass a {@link Model} or a {@link ModelSource}
 * @param solver runs it
 * @param sha256 of the model's JAR
 * @param formulationReason reason for the model's formulation; empty if unknown
 * @param shown column groups its file selects
 * @param userCode how the classes of its users run, if it has such: as a warning where nothing
 *     confines them, else empty
 */
public record FetchedModel(
    Class<?> modelClass,
    Solver solver,
    String sha256,
    Optional<String> formulationReason,
    Set<ColumnGroup> shown,
    Optional<String> userCode) {
  private static final Solver OWN_SOLVER = new RuntimeSolver();
  private static final String CLASS = ".class";

  /** Package of generated classes; users have no classes there. */
  private static final String GENERATED = "org/mechservice/";

  private static final String SHOWN_ATTRIBUTE = "Mech-Columns-Shown";
  private static final String REASON_ATTRIBUTE = "Mech-Formulation-Reason";

  /**
   * Loads a model, whose classes are verified before.
   *
   * @param runtimeJar the solver that came with it; empty: that of this process
   * @param consent whether classes of users may run where they cannot be confined
   * @throws JarRefusedException if they do not fit this client or each other, or a class uses what
   *     it must not (S-232; of a user: S-156)
   */
  public static FetchedModel load(
      BuiltJar modelJar, Optional<byte[]> runtimeJar, UserCode consent) {
    FetchedJar model = FetchedJar.read(modelJar.bytes(), "the model JAR");
    Optional<FetchedJar> runtime =
        runtimeJar.map(bytes -> FetchedJar.read(bytes, "the runtime JAR"));
    SortedMap<String, byte[]> ofUsers = classFiles(model, false);
    requirePermitted(
        MessageCode.MODEL_CLASS_NOT_PERMITTED,
        BytecodeVerifier.checkModel(classFiles(model, true), ofUsers.keySet()));
    Optional<ClassLoader> userClasses = userClasses(ofUsers, consent);
    FetchedClasses classes = new FetchedClasses(model, runtime, userClasses);
    try {
      return new FetchedModel(
          modelClass(classes, modelJar.mainClass()),
          runtime.isPresent() ? solver(classes) : OWN_SOLVER,
          Sha256.of(modelJar.bytes()),
          model.attribute(REASON_ATTRIBUTE),
          ColumnGroup.of(model.attribute(SHOWN_ATTRIBUTE).orElse(ColumnGroup.JOINTS.label())),
          userClasses.map(u -> consent.warning(Confinement.ofThisMachine()).orElse("")));
    } catch (ReflectiveOperationException | LinkageError | ServiceConfigurationError e) {
      throw refused("cannot be loaded: " + e);
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
    requirePermitted(MessageCode.USER_CLASS_NOT_PERMITTED, BytecodeVerifier.check(files));
    try {
      return Optional.of(new ForceRelay(files, consent).newLoader());
    } catch (IllegalArgumentException e) {
      throw new JarRefusedException(
          MessageCode.NO_CONFINEMENT.code(), String.valueOf(e.getMessage()));
    }
  }

  /**
   * Returns class files by binary name.
   *
   * @param generated whether the generated ones; else those of users
   */
  private static SortedMap<String, byte[]> classFiles(FetchedJar model, boolean generated) {
    SortedMap<String, byte[]> files = new TreeMap<>();
    for (String name : model.names()) {
      if (name.endsWith(CLASS) && name.startsWith(GENERATED) == generated) {
        files.put(
            name.substring(0, name.length() - CLASS.length()).replace('/', '.'),
            model.entry(name).orElseThrow());
      }
    }
    return files;
  }

  private static void requirePermitted(MessageCode code, List<BytecodeVerifier.Refusal> refusals) {
    refusals.stream()
        .findFirst()
        .ifPresent(
            use -> {
              throw new JarRefusedException(code.code(), use.text());
            });
  }

  private static Class<?> modelClass(FetchedClasses classes, String mainClass)
      throws ReflectiveOperationException {
    Class<?> type = classes.loadClass(mainClass);
    if (type.getClassLoader() != classes) {
      throw refused("names " + mainClass + ", which it does not contain");
    }
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
    Optional<RunNotes.Note> unconfined =
        userCode
            .filter(warning -> !warning.isEmpty())
            .map(w -> new RunNotes.Note(MessageCode.USER_CODE_UNCONFINED, 0, true, w));
    return new LocalRun(source, model, solver, sha256, request, facts, unconfined);
  }
}
