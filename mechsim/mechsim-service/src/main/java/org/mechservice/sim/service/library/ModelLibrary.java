package org.mechservice.sim.service.library;

import java.lang.ref.WeakReference;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicInteger;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.check.CheckReport;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.CompiledModel;
import org.mechservice.sim.model.GeneratedModel;
import org.mechservice.sim.model.ModelFactory;

/**
 * Generates and compiles models, and keeps the latest ones: the same file with the same options is
 * built once. As many builds run at once as there are processors; the others wait.
 *
 * <p>Of a compiled model the class files and its description are kept. The generated plan, a
 * hundred times as large, is kept until the class files are written; a later request for the source
 * generates it anew.
 */
public final class ModelLibrary implements AutoCloseable {
  /** Of models that are small enough. */
  static final int KEPT = 64;

  private static final int CHECK_REPORTS_KEPT = 32;

  /**
   * Values of plans that are kept, of 140 bytes each. A tree of 1000 bodies has half a million by
   * DTR.
   */
  static final long PLANNED_VALUES = 1_000_000;

  /** Bytes of class files that are kept; 1000 bodies take a megabyte. */
  static final long CLASS_BYTES = 32L << 20;

  private record Key(
      String fileName, String sha256, String userSha256, ReadOptions read, BuildOptions options) {}

  private final BoundedCache<Key, GeneratedModel> generated =
      new BoundedCache<>(KEPT, PLANNED_VALUES, GeneratedModel::plannedValues);
  private final BoundedCache<Key, CompiledModel> compiled =
      new BoundedCache<>(KEPT, CLASS_BYTES, model -> model.classes().classBytes());

  private record ModelText(String fileName, String text) {}

  private final BoundedCache<ModelText, String> checkReports =
      new BoundedCache<>(CHECK_REPORTS_KEPT, Long.MAX_VALUE, report -> 0);

  /** Models of which sessions hold the set-up, for their check reports. */
  private final Map<ModelText, WeakReference<MechmlModel>> held = new LinkedHashMap<>();

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
   * @param times receives the time it took
   * @throws IllegalArgumentException if the model does not fit the options
   */
  public GeneratedModel generated(LoadedModel loaded, BuildOptions options, SetUpTimes times) {
    hold(loaded);
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
   * @param times receives the time it took
   * @throws IllegalArgumentException if the model does not fit the options
   */
  public CompiledModel compiled(LoadedModel loaded, BuildOptions options, SetUpTimes times) {
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

  /**
   * Returns the check report of a model as JSON; empty if its text is, or cannot be read. The
   * latest reports are kept. The loops of a model that a session holds are not analysed again.
   */
  public String checkReport(String fileName, String text) {
    return text.isEmpty()
        ? ""
        : checkReports.get(
            new ModelText(fileName, text),
            Runnable::run,
            () -> newCheckReport(new ModelText(fileName, text)));
  }

  private String newCheckReport(ModelText file) {
    try {
      Optional<MechmlModel> model = heldModel(file);
      return CheckReport.of(model.isPresent() ? model.get() : read(file)).json();
    } catch (MechmlException e) {
      return ""; // its encoding is not UTF-8
    }
  }

  /** Remembers the model of a file as it stands, without values of its own for parameters. */
  private void hold(LoadedModel loaded) {
    if (!loaded.options().equals(ReadOptions.NONE)) {
      return;
    }
    ModelText file = new ModelText(loaded.fileName(), loaded.text());
    synchronized (held) {
      held.put(file, new WeakReference<>(loaded.model()));
      if (held.size() > CHECK_REPORTS_KEPT) {
        held.remove(held.keySet().iterator().next());
      }
    }
  }

  private Optional<MechmlModel> heldModel(ModelText file) {
    synchronized (held) {
      return Optional.ofNullable(held.get(file)).map(WeakReference::get);
    }
  }

  private static MechmlModel read(ModelText file) throws MechmlException {
    return MechmlReader.read(file.fileName(), file.text().getBytes(StandardCharsets.UTF_8));
  }

  @Override
  public void close() {
    builds.shutdown();
  }
}
