package org.mechservice.sim.service;

import java.io.IOException;
import java.util.Optional;
import java.util.function.Supplier;

/**
 * What is on disk of one run: what is known of it, and its rows. Thread-safe; who comes late with
 * older news does not change what was settled.
 */
final class RunRecord {
  private final Optional<SpoolFolder> folder;
  private final String simId;
  private final ResultSpool rows;
  private boolean settled;

  /**
   * @param folder in which runs outlive the process; empty: they do not
   */
  RunRecord(Optional<SpoolFolder> folder, String simId, ResultSpool rows) {
    this.folder = folder;
    this.simId = simId;
    this.rows = rows;
  }

  /** Returns whether it outlives the process. */
  boolean lasts() {
    return folder.isPresent();
  }

  /** Writes down that a run has begun, so that a crash does not make it disappear. */
  synchronized void begun(EndedRun run) throws IOException {
    if (!settled) {
      write(run);
    }
  }

  /** Writes down how a run will be said to have ended, with all its rows. */
  synchronized void ended(EndedRun run) throws IOException {
    if (!settled) {
      rows.secure();
      write(run);
    }
  }

  /**
   * Writes down how a run was said to have ended, with all its rows: first so that it outlives the
   * process, which takes no time, then so that it outlives the machine, for which nobody waits.
   */
  synchronized void settle(Supplier<EndedRun> run) throws IOException {
    if (!settled) {
      EndedRun end = run.get();
      if (folder.isPresent()) {
        rows.write();
        folder.get().note(end);
      }
      ended(end);
      settled = true;
    }
  }

  private void write(EndedRun run) throws IOException {
    if (folder.isPresent()) {
      folder.get().write(run);
    }
  }

  /** Deletes everything. */
  synchronized void delete() throws IOException {
    settled = true;
    if (folder.isPresent()) {
      folder.get().delete(simId);
    }
    rows.delete();
  }
}
