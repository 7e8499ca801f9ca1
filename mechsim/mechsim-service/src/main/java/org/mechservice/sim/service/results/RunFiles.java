package org.mechservice.sim.service.results;

import java.io.IOException;
import java.util.Optional;
import java.util.function.Supplier;

/**
 * The files of one run: its record and its rows. Thread-safe; after {@link #writeFinal} the record
 * on disk does not change any more.
 */
public final class RunFiles {
  private final Optional<SpoolFolder> folder;
  private final String simId;
  private final ResultSpool rows;
  private boolean isFinal;

  /**
   * @param folder in which runs outlive the process; empty: they do not
   */
  RunFiles(Optional<SpoolFolder> folder, String simId, ResultSpool rows) {
    this.folder = folder;
    this.simId = simId;
    this.rows = rows;
  }

  /** Returns whether it outlives the process. */
  public boolean lasts() {
    return folder.isPresent();
  }

  /** Writes the record of a run that has begun, so that it is found after a crash. */
  public synchronized void writeBegun(RunRecord run) throws IOException {
    if (!isFinal) {
      write(run);
    }
  }

  /** Writes the record of the end of a run, before it is announced, and all its rows. */
  public synchronized void writeEnded(RunRecord run) throws IOException {
    if (!isFinal) {
      rows.secure();
      write(run);
    }
  }

  /**
   * Writes the record of an end that is announced already, and all rows: first without waiting for
   * the disk, so that they outlive the process, then forced to disk, so that they outlive the
   * machine.
   */
  public synchronized void writeFinal(Supplier<RunRecord> run) throws IOException {
    if (!isFinal) {
      RunRecord end = run.get();
      if (folder.isPresent()) {
        rows.write();
        folder.get().note(end);
      }
      writeEnded(end);
      isFinal = true;
    }
  }

  private void write(RunRecord run) throws IOException {
    if (folder.isPresent()) {
      folder.get().write(run);
    }
  }

  /** Deletes everything. */
  synchronized void delete() throws IOException {
    isFinal = true;
    if (folder.isPresent()) {
      folder.get().delete(simId);
    }
    rows.delete();
  }
}
