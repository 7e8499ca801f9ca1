package org.mechservice.sim.service.results;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.idl.CurveSample;
import org.mechservice.idl.Progress;
import org.mechservice.idl.SimState;
import org.mechservice.sim.service.limits.CurrentLimits;
import org.mechservice.sim.service.limits.HostLimits;
import org.mechservice.solver.api.result.Variable;

/** What clients leave behind: no more of one than its share, and no more in memory than needed. */
class RunStoreTest {
  private static final RunColumns COLUMNS =
      new RunColumns(List.of(new Variable("t", "s")), List.of());

  @TempDir private Path folder;

  private static RunStore store(Optional<Path> folder, long clientKept) {
    return new RunStore(
        folder, new CurrentLimits(HostLimits.DEFAULT.with("clientKept", clientKept)));
  }

  private static RunRecord run(String id, String owner, long endedAt, String model, String text) {
    return new RunRecord(
        new RunIdentity(id, "session", "here", owner, "m", "m.xml", model, 0, List.of()),
        COLUMNS,
        List.of(),
        new Progress(id, SimState.SIM_DONE, 0, 1, 0, 1, 1, 1, 1, 1, 0),
        1,
        endedAt,
        text,
        "{}",
        Optional.empty(),
        List.of(new CurveSample(1, 2, 3, 4, 5, 6)));
  }

  /** Keeps a run that ends in the given order. */
  private static RunRecord keep(RunStore store, String id, String owner, long order, String model)
      throws Exception {
    RunRecord run = run(id, owner, System.currentTimeMillis() + order, model, "done");
    ResultSpool rows = store.newRows(id, owner, 1);
    store.files(id, rows).writeEnded(run);
    store.keep(run, rows);
    return run;
  }

  @Test
  void clientWithManyRunsLosesItsOldestAndNobodyElseAny() throws Exception {
    try (RunStore store = store(Optional.of(folder), 2)) {
      keep(store, "ann", "ann", 0, "");
      for (int i = 0; i < 5; i++) {
        keep(store, "eve" + i, "eve", i, "");
      }
      assertThat(store.find("ann")).isPresent();
      assertThat(store.find("eve2")).isEmpty();
      assertThat(store.find("eve3")).isPresent();
      assertThat(store.find("eve4")).isPresent();
    }
    assertThat(folder.resolve("eve2.json")).doesNotExist();
    assertThat(folder.resolve("eve4.json")).exists();
  }

  @Test
  void withoutAFolderTheClientWhoLeavesMostMakesRoom() throws Exception {
    try (RunStore store = store(Optional.empty(), 1000)) {
      keep(store, "ann", "ann", 0, "");
      for (int i = 0; i < 600; i++) {
        keep(store, "eve" + i, "eve", i, "");
      }
      assertThat(store.find("ann")).isPresent();
      assertThat(store.find("eve0")).isEmpty();
      assertThat(store.find("eve599")).isPresent();
    }
  }

  @Test
  void largeRecordIsReadFromDiskWhenItIsAskedFor() throws Exception {
    String model = "x".repeat(1_000_000);
    try (RunStore store = store(Optional.of(folder), 1000)) {
      RunRecord run = keep(store, "a", "ann", 0, model);
      RunStore.Kept kept = store.find("a").orElseThrow();
      assertThat(kept.identity().modelText()).isEmpty();
      assertThat(kept.run().identity()).isEqualTo(run.identity());
      assertThat(kept.run().curves()).hasSize(1);
      Files.delete(folder.resolve("a.json"));
      assertThatThrownBy(kept::run).isInstanceOf(IOException.class);
      assertThat(store.known("a")).isEmpty();
    }
  }

  /** All of them are one message to the server, with four bytes for a character. */
  @Test
  void listsHaveTheLatestRunsAndTheBeginningsOfLongTexts() throws Exception {
    try (RunStore store = store(Optional.of(folder), 10_000)) {
      for (int i = 0; i < 4500; i++) {
        RunRecord run = run("r" + i, "eve", i + Long.MAX_VALUE / 4, "", "y".repeat(10_000));
        store.keep(run, store.newRows("r" + i, "eve", 1));
      }
      assertThat(store.summaries()).hasSize(4000).noneMatch(run -> run.simId.equals("r499"));
      assertThat(store.summaries()).allMatch(run -> run.text.length() < 600);
    }
  }
}
