package org.mechservice.sim.service;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Supplier;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.sim.build.BuildOptions;
import org.mechservice.sim.build.CompiledModel;
import org.mechservice.sim.build.GeneratedModel;
import org.mechservice.sim.build.ModelFactory;

/**
 * Generates and compiles models, and keeps the latest: the same file with the same options is done
 * once. As many builds run at once as there are processors; the others wait their turn.
 */
final class ModelLibrary implements AutoCloseable {
  /** A generated class of a large scene takes some 100 kB, so this is bounded by tens of MB. */
  private static final int KEPT = 64;

  private record Key(
      String fileName, String sha256, String userSha256, ReadOptions read, BuildOptions options) {}

  private static final class Latest<V> extends LinkedHashMap<Key, CompletableFuture<V>> {
    private static final long serialVersionUID = 1L;

    Latest() {
      super(KEPT, 0.75f, true);
    }

    @Override
    protected boolean removeEldestEntry(Map.Entry<Key, CompletableFuture<V>> eldest) {
      return size() > KEPT;
    }
  }

  private final Latest<GeneratedModel> generated = new Latest<>();
  private final Latest<CompiledModel> compiled = new Latest<>();
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
    return once(
        generated,
        key(loaded, options),
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
    GeneratedModel source = generated(loaded, options, times);
    return once(
        compiled,
        key(loaded, options),
        () -> {
          long start = System.nanoTime();
          CompiledModel model =
              ModelFactory.compile(loaded.model(), options, source, loaded.userClasses());
          times.addCompiling(System.nanoTime() - start);
          return model;
        });
  }

  private static Key key(LoadedModel loaded, BuildOptions options) {
    return new Key(
        loaded.fileName(),
        loaded.sha256(),
        loaded.userClasses().sha256(),
        loaded.options(),
        options);
  }

  private <V> V once(Latest<V> kept, Key key, Supplier<V> build) {
    CompletableFuture<V> future;
    synchronized (kept) {
      future = kept.get(key);
      if (future == null) {
        future = CompletableFuture.supplyAsync(build, builds);
        kept.put(key, future);
      }
    }
    try {
      return future.join();
    } catch (CompletionException e) {
      synchronized (kept) {
        kept.remove(key, future);
      }
      if (e.getCause() instanceof RuntimeException cause) {
        throw cause;
      }
      throw e;
    }
  }

  @Override
  public void close() {
    builds.shutdown();
  }
}
