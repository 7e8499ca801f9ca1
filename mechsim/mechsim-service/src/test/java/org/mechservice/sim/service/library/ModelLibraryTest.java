package org.mechservice.sim.service.library;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.ref.WeakReference;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.CompiledModel;
import org.mechservice.sim.model.GeneratedModel;
import org.mechservice.sim.model.Scenes;

class ModelLibraryTest {
  /**
   * A collection of garbage clears what nothing but weak references keep, at the latest the next.
   */
  private static final int COLLECTIONS = 20;

  private static final BuildOptions OPTIONS = new BuildOptions("DTR", Set.of(), Scenes.SETTINGS);

  private final SetUpTimes times = new SetUpTimes();
  private LoadedModel pendulum;

  @BeforeEach
  void load() throws Exception {
    byte[] file = Files.readAllBytes(Path.of("../../examples/pendulum/pendulum.xml"));
    pendulum = LoadedModel.read("pendulum.xml", file, List.of(), true);
  }

  /** The plan of 1000 bodies has a hundred times the size of their class file. */
  @Test
  void ofACompiledModelNoPlanIsKept() {
    try (ModelLibrary library = new ModelLibrary()) {
      WeakReference<GeneratedModel> plan =
          new WeakReference<>(library.generated(pendulum, OPTIONS, times));
      CompiledModel compiled = library.compiled(pendulum, OPTIONS, times);
      for (int i = 0; i < COLLECTIONS && plan.get() != null; i++) {
        System.gc();
      }
      assertThat(plan.get()).isNull();
      assertThat(library.compiled(pendulum, OPTIONS, times)).isSameAs(compiled);
    }
  }

  @Test
  void thePlanMadeAheadIsTheOneThatIsCompiled() {
    try (ModelLibrary library = new ModelLibrary()) {
      library.generated(pendulum, OPTIONS, times);
      double treating = times.asMap().getOrDefault("t1s", 0.0);
      library.compiled(pendulum, OPTIONS, times);
      assertThat(times.asMap()).containsEntry("t1s", treating);
    }
  }

  @Test
  void theSourceOfACompiledModelIsThatOfItsClass() {
    try (ModelLibrary library = new ModelLibrary()) {
      String before = library.generated(pendulum, OPTIONS, times).source();
      library.compiled(pendulum, OPTIONS, times);
      assertThat(library.generated(pendulum, OPTIONS, times).source()).isEqualTo(before);
    }
  }
}
