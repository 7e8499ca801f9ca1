package org.mechservice.sim.build;

import java.io.ByteArrayOutputStream;
import java.lang.reflect.Constructor;
import java.util.Collections;
import java.util.SortedMap;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.build.jar.Sha256;
import org.mechservice.sim.build.javac.ModelClassLoader;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelSource;

/** A generated model and its class files. Immutable; shared freely between threads. */
public final class CompiledModel {
  private final MechmlModel source;
  private final GeneratedModel generated;
  private final BuildOptions options;
  private final SortedMap<String, byte[]> classFiles;
  private final Constructor<?> constructor;

  /**
   * Loads the class of a model.
   *
   * @param source what it was generated from
   * @param generated its source
   * @param options what it was built for
   * @param classFiles class file bytes by binary class name; not modified
   */
  CompiledModel(
      MechmlModel source,
      GeneratedModel generated,
      BuildOptions options,
      SortedMap<String, byte[]> classFiles) {
    this.source = source;
    this.generated = generated;
    this.options = options;
    this.classFiles = Collections.unmodifiableSortedMap(classFiles);
    this.constructor = constructor(generated.className(), classFiles);
  }

  private static Constructor<?> constructor(
      String className, SortedMap<String, byte[]> classFiles) {
    try {
      return new ModelClassLoader(classFiles).loadClass(className).getConstructor();
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException("the generated class " + className + " cannot be loaded", e);
    }
  }

  /** Returns what it was generated from. */
  public MechmlModel source() {
    return source;
  }

  /** Returns its source. */
  public GeneratedModel generated() {
    return generated;
  }

  /** Returns what it was built for. */
  public BuildOptions options() {
    return options;
  }

  /** Returns class file bytes by binary class name; not to be modified. */
  public SortedMap<String, byte[]> classFiles() {
    return classFiles;
  }

  /** Returns the SHA-256 of its class files, which identifies it to the bit. */
  public String sha256() {
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    classFiles.values().forEach(all::writeBytes);
    return Sha256.of(all.toByteArray());
  }

  /** Returns a new instance of the model, for one run. The class is loaded once. */
  public Model newInstance() {
    try {
      return ModelSource.of(constructor.newInstance());
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(
          "the generated class " + generated.className() + " cannot be instantiated", e);
    }
  }
}
