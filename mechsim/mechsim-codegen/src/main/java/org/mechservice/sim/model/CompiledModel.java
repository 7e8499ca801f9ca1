package org.mechservice.sim.model;

import java.io.ByteArrayOutputStream;
import java.lang.reflect.Constructor;
import java.util.Collections;
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
  private final Constructor<?> constructor;
  private final Constructor<?> describing;

  /**
   * Loads the class of a model.
   *
   * @param source what it was generated from
   * @param generated its source
   * @param options what it was built for
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
    constructor = constructor(generated.className(), classFiles, userClasses.loader());
    describing =
        userClasses.isEmpty()
            ? constructor
            : constructor(
                generated.className(),
                classFiles,
                UserClasses.loaderOf(IdleForces.of(source.mechanism())));
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

  /** Returns what it was generated from. */
  public MechmlModel source() {
    return source;
  }

  /** Returns the facts about its code; the plan of the code is not kept. */
  public GeneratedFacts generated() {
    return generated;
  }

  /** Returns what it was built for. */
  public BuildOptions options() {
    return options;
  }

  /** Returns class file bytes by binary class name, those of users too; not to be modified. */
  public SortedMap<String, byte[]> classFiles() {
    return classFiles;
  }

  /** Returns how many bytes its class files have. */
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

  /** Returns whether running it runs classes of users. */
  public boolean hasUserClasses() {
    return !userClasses.isEmpty();
  }

  /**
   * Returns an instance to be asked for names, units, columns and settings: classes of users are
   * not loaded for it, their forces do nothing.
   */
  public Model withoutUserClasses() {
    return describing().model();
  }

  /** Returns what makes instances like that of {@link #withoutUserClasses}, with parameters. */
  public ModelSource describing() {
    return source(describing);
  }

  /**
   * Returns a new instance of the model, for one run. Its classes are loaded once, those of users
   * too.
   *
   * @throws IllegalArgumentException S-068 if a class of a user cannot be used
   */
  public Model newInstance() {
    return instances().model();
  }

  /**
   * Returns what makes instances of the model, with values of its tunable parameters if wanted; the
   * model of one run is not to be that of another.
   */
  public ModelSource instances() {
    return source(constructor);
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
