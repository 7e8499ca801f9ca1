package org.mechservice.sim.model;

import java.io.ByteArrayOutputStream;
import java.lang.reflect.Constructor;
import java.util.Collections;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Supplier;
import org.mechservice.guard.ModelClassLoader;
import org.mechservice.sim.user.UserClasses;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelSource;
import org.mechservice.solver.text.Sha256;

/**
 * The class files of a generated model, which run without the model file that they were generated
 * from. Immutable; shared freely between threads.
 */
public final class ModelClasses {
  /**
   * The files, by binary class name; not to be modified.
   *
   * @param own the model's own
   * @param ofUsers those of its users' forces
   * @param idle substitutes for them, see {@link org.mechservice.sim.user.IdleForces}
   */
  public record Files(
      SortedMap<String, byte[]> own,
      SortedMap<String, byte[]> ofUsers,
      SortedMap<String, byte[]> idle) {
    public Files {
      own = Collections.unmodifiableSortedMap(own);
      ofUsers = Collections.unmodifiableSortedMap(ofUsers);
      idle = Collections.unmodifiableSortedMap(idle);
    }

    /** Returns all files that travel with the model. */
    public SortedMap<String, byte[]> all() {
      SortedMap<String, byte[]> all = new TreeMap<>(own);
      all.putAll(ofUsers);
      return Collections.unmodifiableSortedMap(all);
    }

    /** Returns the SHA-256 of these files, which identifies the model to the bit. */
    public String sha256() {
      ByteArrayOutputStream bytes = new ByteArrayOutputStream();
      all().values().forEach(bytes::writeBytes);
      return Sha256.of(bytes.toByteArray());
    }
  }

  private final GeneratedFacts generated;
  private final Files files;
  private final SortedMap<String, byte[]> all;
  private final Supplier<ClassLoader> userLoader;
  private final Constructor<?> describing;
  private Optional<Constructor<?>> running = Optional.empty();

  /**
   * Loads the classes of a model whose users' classes do not run in this process.
   *
   * @param generated facts about its code
   */
  public ModelClasses(GeneratedFacts generated, Files files) {
    this(
        generated,
        files,
        () -> {
          throw new IllegalStateException("classes of users do not run in this process");
        });
  }

  /**
   * Loads the classes of a model.
   *
   * @param generated facts about its code
   * @param userLoader loads the classes of its users, for an instance that runs
   */
  ModelClasses(GeneratedFacts generated, Files files, Supplier<ClassLoader> userLoader) {
    this.generated = generated;
    this.files = files;
    this.userLoader = userLoader;
    all = files.all();
    describing = constructor(UserClasses.loaderOf(files.idle()));
    if (files.ofUsers().isEmpty()) {
      running = Optional.of(describing);
    }
  }

  private Constructor<?> constructor(ClassLoader userClasses) {
    try {
      return new ModelClassLoader(files.own(), userClasses)
          .loadClass(generated.className())
          .getConstructor();
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(
          "the generated class " + generated.className() + " cannot be loaded", e);
    }
  }

  /** Returns the facts about its code. */
  public GeneratedFacts generated() {
    return generated;
  }

  /** Returns the class files. */
  public Files files() {
    return files;
  }

  /** Returns all class files that travel with the model, by binary class name; not modified. */
  SortedMap<String, byte[]> all() {
    return all;
  }

  /** Returns the total size of the class files in bytes. */
  public long classBytes() {
    return all.values().stream().mapToLong(file -> file.length).sum();
  }

  /** Returns the SHA-256 of the class files, which identifies the model to the bit. */
  public String sha256() {
    return files.sha256();
  }

  /** Returns whether the model contains user classes. */
  public boolean hasUserClasses() {
    return !files.ofUsers().isEmpty();
  }

  /**
   * Returns a source of instances for queries of names, units, columns and settings, with values of
   * parameters. User classes are not loaded for it; their forces are zero.
   */
  public ModelSource describing() {
    return source(describing);
  }

  /**
   * Returns a source of instances of the model, with given values of its tunable parameters. Each
   * run needs its own instance. Its classes are loaded once; user classes are loaded in a confined
   * process, which the instance asks.
   *
   * @throws IllegalArgumentException S-068 if a user class cannot be used, S-168 if this machine
   *     cannot confine it
   */
  public ModelSource instances() {
    return source(running());
  }

  /** Returns a new instance of the model, for one run; see {@link #instances}. */
  Model newInstance() {
    return instances().model();
  }

  private synchronized Constructor<?> running() {
    if (running.isEmpty()) {
      running = Optional.of(constructor(userLoader.get()));
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
