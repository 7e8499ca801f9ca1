package org.mechservice.sim.service.results;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Set;
import org.mechservice.solver.text.OwnerOnly;

/** The file for the rows of a run that do not fit into memory. */
interface RowFile {
  /** Opens it, creating it if need be. */
  FileChannel open() throws IOException;

  /** Returns its size, bytes; 0 if it is not there. */
  long size() throws IOException;

  /** Returns whether the file outlives the process. */
  boolean lasting();

  /** Deletes it. */
  void delete() throws IOException;

  /**
   * A temporary file, without a name where the system allows that: it disappears when the process
   * ends, however it ends.
   */
  static RowFile temporary() {
    return new RowFile() {
      @Override
      public FileChannel open() throws IOException {
        return FileChannel.open(
            Files.createTempFile("mechservice-", ".rows"),
            StandardOpenOption.READ,
            StandardOpenOption.WRITE,
            StandardOpenOption.DELETE_ON_CLOSE);
      }

      @Override
      public long size() {
        return 0;
      }

      @Override
      public boolean lasting() {
        return false;
      }

      @Override
      public void delete() {
        // Its channel's end is its own.
      }
    };
  }

  /** A file that stays. */
  static RowFile at(Path path) {
    return new RowFile() {
      @Override
      public FileChannel open() throws IOException {
        return FileChannel.open(
            path,
            Set.of(StandardOpenOption.READ, StandardOpenOption.WRITE, StandardOpenOption.CREATE),
            OwnerOnly.file());
      }

      @Override
      public long size() throws IOException {
        return Files.exists(path) ? Files.size(path) : 0;
      }

      @Override
      public boolean lasting() {
        return true;
      }

      @Override
      public void delete() throws IOException {
        Files.deleteIfExists(path);
      }
    };
  }
}
