package org.mechservice.sim.model;

import java.io.ByteArrayOutputStream;
import java.lang.reflect.Constructor;
import java.util.Collections;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.compile.ModelClassLoader;
import org.mechservice.sim.user.IdleForces;
import org.mechservice.sim.user.UserClasses;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelSource;
import org.mechservice.solver.text.Sha256;

/** A generated model and its class files. Immutable; shared freely between threads. */
public final class CompiledModel {
  private final MechmlModel source;
  private final GeneratedFacts generated;
  private final BuildOptions options;
  private final SortedMap<String, byte[]> classFiles;
  private final UserClasses userClasses;
  private final SortedMap<String, byte[]> ownFiles;
  private final Constructor<?> describing;
  private Optional<Constructor<?>> running = Optional.empty();

  /**
   * Loads the class of a model.
   *
   * @param source model file that it was generated from
   * @param generated facts about its code
   * @param options options of the build
   * @param classFiles class file bytes by binary class name; not modified
   * @param userClasses the classes of its users' forces
   */
  CompiledModel(
      MechmlModel source,
      GeneratedModel generated,
      BuildOptions options,
      SortedMap<String, byte[]> classFiles,
      UserClasses userClasses) {
    this.source = source;
    this.generated = generated.facts();
    this.options = options;
    this.userClasses = userClasses;
    ownFiles = classFiles;
    describing =
        constructor(
            generated.className(),
            classFiles,
            UserClasses.loaderOf(IdleForces.of(source.mechanism())));
    if (userClasses.isEmpty()) {
      running = Optional.of(describing);
    }
    SortedMap<String, byte[]> all = new TreeMap<>(classFiles);
    all.putAll(userClasses.classFiles());
    this.classFiles = Collections.unmodifiableSortedMap(all);
  }

  private static Constructor<?> constructor(
      String className, SortedMap<String, byte[]> classFiles, ClassLoader userClasses) {
    try {
      return new ModelClassLoader(classFiles, userClasses).loadClass(className).getConstructor();
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException("the generated class " + className + " cannot be loaded", e);
    }
  }

  /** Returns the model file that it was generated from. */
  public MechmlModel source() {
    return source;
  }

  /** Returns the facts about its code; the plan of the code is not kept. */
  public GeneratedFacts generated() {
    return generated;
  }

  /** Returns the options of the build. */
  public BuildOptions options() {
    return options;
  }

  /**
   * Returns class file bytes by binary class name, including user classes; must not be modified.
   */
  public SortedMap<String, byte[]> classFiles() {
    return classFiles;
  }

  /** Returns the total size of its class files in bytes. */
  public long classBytes() {
    return classFiles.values().stream().mapToLong(file -> file.length).sum();
  }

  /** Returns the SHA-256 of its class files, which identifies it to the bit. */
  public String sha256() {
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    classFiles.values().forEach(all::writeBytes);
    return Sha256.of(all.toByteArray());
  }

  /** Returns the class files of its users, by binary class name; not to be modified. */
  public SortedMap<String, byte[]> userClassFiles() {
    return userClasses.classFiles();
  }

  /** Returns whether the model contains user classes. */
  public boolean hasUserClasses() {
    return !userClasses.isEmpty();
  }

  /**
   * Returns an instance for queries of names, units, columns and settings. User classes are not
   * loaded for it; their forces are zero.
   */
  public Model withoutUserClasses() {
    return describing().model();
  }

  /**
   * Returns a source of instances as {@link #withoutUserClasses} returns, with values of
   * parameters.
   */
  public ModelSource describing() {
    return source(describing);
  }

  /**
   * Returns a new instance of the model, for one run. Its classes are loaded once; user classes are
   * loaded in a confined process, which the instance asks.
   *
   * @throws IllegalArgumentException S-068 if a user class cannot be used, S-168 if this machine
   *     cannot confine it
   */
  public Model newInstance() {
    return instances().model();
  }

  /**
   * Returns a source of instances of the model, with given values of its tunable parameters. Each
   * run needs its own instance.
   */
  public ModelSource instances() {
    return source(running());
  }

  private synchronized Constructor<?> running() {
    if (running.isEmpty()) {
      running = Optional.of(constructor(generated.className(), ownFiles, userClasses.loader()));
    }
    return running.get();
  }

  private ModelSource source(Constructor<?> constructor) {
    try {
      return ModelSource.from(constructor.newInstance());
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(
          "the generated class " + generated.className() + " cannot be instantiated", e);
    }
  }
}
