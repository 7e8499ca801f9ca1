package org.mechservice.sim.service.library;

import org.mechservice.sim.model.GeneratedFacts;
import org.mechservice.sim.model.ModelClasses;

/**
 * The classes of the latest models that were built, loaded once: Java compiles them to machine code
 * while they run, and the next run of the same model finds them so. Thread-safe.
 */
public final class ClassLibrary {
  private final BoundedCache<String, ModelClasses> kept =
      new BoundedCache<>(ModelLibrary.KEPT, ModelLibrary.CLASS_BYTES, ModelClasses::classBytes);

  /** Keeps classes that are loaded. */
  public void keep(ModelClasses classes) {
    kept.get(key(classes.generated(), classes.files()), Runnable::run, () -> classes);
  }

  /** Returns the classes of a model; loads them if they are not kept. */
  public ModelClasses of(GeneratedFacts generated, ModelClasses.Files files) {
    return kept.get(key(generated, files), Runnable::run, () -> new ModelClasses(generated, files));
  }

  private static String key(GeneratedFacts generated, ModelClasses.Files files) {
    return generated.className() + " " + files.sha256();
  }
}
