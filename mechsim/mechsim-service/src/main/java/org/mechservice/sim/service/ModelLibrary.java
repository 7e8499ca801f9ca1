package org.mechservice.sim.service;

import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicInteger;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.CompiledModel;
import org.mechservice.sim.model.GeneratedModel;
import org.mechservice.sim.model.ModelFactory;

/**
 * Generates and compiles models, and keeps the latest: the same file with the same options is done
 * once. As many builds run at once as there are processors; the others wait their turn.
 *
 * <p>What is kept of a compiled model is its class files and what is to be said of it. The plan
 * they are written from, a hundred times as large, is kept until they are written, and afterwards
 * made anew if somebody asks for the source.
 */
final class ModelLibrary implements AutoCloseable {
  /** Of models that are small enough. */
  private static final int KEPT = 64;

  /**
   * Values of plans that are kept, of 140 bytes each. A tree of 1000 bodies has half a million by
   * DTR.
   */
  static final long PLANNED_VALUES = 1_000_000;

  /** Bytes of class files that are kept; 1000 bodies take a megabyte. */
  static final long CLASS_BYTES = 32L << 20;

  private record Key(
      String fileName, String sha256, String userSha256, ReadOptions read, BuildOptions options) {}

  private final Latest<Key, GeneratedModel> generated =
      new Latest<>(KEPT, PLANNED_VALUES, GeneratedModel::plannedValues);
  private final Latest<Key, CompiledModel> compiled =
      new Latest<>(KEPT, CLASS_BYTES, CompiledModel::classBytes);
  private final AtomicInteger builders = new AtomicInteger();
  private final ExecutorService builds =
      Executors.newFixedThreadPool(
          Runtime.getRuntime().availableProcessors(),
          task -> {
            Thread thread = new Thread(task, "mechservice-build-" + builders.incrementAndGet());
            thread.setDaemon(true);
            return thread;
          });

  /**
   * Returns the generated class of a model.
   *
   * @param times told what it cost
   * @throws IllegalArgumentException if the model does not fit the options
   */
  GeneratedModel generated(LoadedModel loaded, BuildOptions options, SetUpTimes times) {
    return generated.get(
        key(loaded, options),
        builds,
        () -> {
          long start = System.nanoTime();
          GeneratedModel source = ModelFactory.generate(loaded.model(), options);
          times.addTreating(System.nanoTime() - start);
          return source;
        });
  }

  /**
   * Returns the compiled class of a model.
   *
   * @param times told what it cost
   * @throws IllegalArgumentException if the model does not fit the options
   */
  CompiledModel compiled(LoadedModel loaded, BuildOptions options, SetUpTimes times) {
    Key key = key(loaded, options);
    Optional<CompiledModel> known = compiled.known(key);
    if (known.isPresent()) {
      return known.get();
    }
    GeneratedModel source = generated(loaded, options, times);
    CompiledModel written =
        compiled.get(
            key,
            builds,
            () -> {
              long start = System.nanoTime();
              CompiledModel model =
                  ModelFactory.compile(loaded.model(), options, source, loaded.userClasses());
              times.addCompiling(System.nanoTime() - start);
              return model;
            });
    generated.forget(key);
    return written;
  }

  private static Key key(LoadedModel loaded, BuildOptions options) {
    return new Key(
        loaded.fileName(),
        loaded.sha256(),
        loaded.userClasses().sha256(),
        loaded.options(),
        options);
  }

  @Override
  public void close() {
    builds.shutdown();
  }
}
