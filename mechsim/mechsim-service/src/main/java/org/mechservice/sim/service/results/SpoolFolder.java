package org.mechservice.sim.service.results;

import com.google.gson.JsonParseException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.Set;
import java.util.stream.Stream;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.text.FileErrors;
import org.mechservice.solver.text.OwnerOnly;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The folder in which the runs of a host outlive its process: for each run, its rows and its
 * record. One process at a time uses it.
 */
final class SpoolFolder implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(SpoolFolder.class);
  private static final String RECORD = ".json";

  private final Path folder;
  private final FileChannel lockFile;

  private SpoolFolder(Path folder, FileChannel lockFile) {
    this.folder = folder;
    this.lockFile = lockFile;
  }

  /**
   * Opens a folder, creating it if need be.
   *
   * @throws IllegalArgumentException with code S-114 if it cannot be used
   */
  static SpoolFolder open(Path folder) {
    try {
      Files.createDirectories(folder, OwnerOnly.folder());
      OwnerOnly.restrict(folder);
      FileChannel lockFile =
          FileChannel.open(
              folder.resolve("lock"),
              Set.of(StandardOpenOption.CREATE, StandardOpenOption.WRITE),
              OwnerOnly.file());
      if (!locked(lockFile)) {
        lockFile.close();
        throw unusable(folder, "another host uses it", null);
      }
      return new SpoolFolder(folder, lockFile);
    } catch (IOException e) {
      throw unusable(folder, FileErrors.reason(e), e);
    }
  }

  private static boolean locked(FileChannel lockFile) throws IOException {
    try {
      FileLock lock = lockFile.tryLock();
      return lock != null;
    } catch (java.nio.channels.OverlappingFileLockException ofThisProcess) {
      return false;
    }
  }

  private static IllegalArgumentException unusable(
      Path folder, String why, @org.jspecify.annotations.Nullable Exception cause) {
    return new IllegalArgumentException(
        MessageCode.SPOOL_FOLDER + " the spool folder " + folder + " cannot be used: " + why,
        cause);
  }

  /** Returns where the rows of a run are. */
  RowFile rows(String simId) {
    return RowFile.at(folder.resolve(simId + ".rows"));
  }

  /**
   * Writes the record of a run and forces it to disk. After a crash the folder contains either the
   * new or the old record, complete.
   */
  void write(RunRecord run) throws IOException {
    put(run, true);
    forceFolder();
  }

  /**
   * Writes the record of a run without forcing it to disk: it outlives the process, but not yet a
   * crash of the machine.
   */
  void note(RunRecord run) throws IOException {
    put(run, false);
  }

  private void put(RunRecord run, boolean forced) throws IOException {
    Path growing = folder.resolve(run.identity().simId() + ".part");
    try (FileChannel channel =
        FileChannel.open(
            growing,
            Set.of(
                StandardOpenOption.CREATE,
                StandardOpenOption.TRUNCATE_EXISTING,
                StandardOpenOption.WRITE),
            OwnerOnly.file())) {
      ByteBuffer bytes = ByteBuffer.wrap(run.toJson().getBytes(StandardCharsets.UTF_8));
      while (bytes.hasRemaining()) {
        channel.write(bytes);
      }
      if (forced) {
        channel.force(true);
      }
    }
    Files.move(
        growing,
        record(run.identity().simId()),
        StandardCopyOption.ATOMIC_MOVE,
        StandardCopyOption.REPLACE_EXISTING);
  }

  private Path record(String simId) {
    return folder.resolve(simId + RECORD);
  }

  private void forceFolder() {
    try (FileChannel channel = FileChannel.open(folder, StandardOpenOption.READ)) {
      channel.force(true);
    } catch (IOException e) {
      LOG.debug("folders cannot be forced to disk on this system", e);
    }
  }

  /** Deletes the record of a run, not its rows. */
  void delete(String simId) throws IOException {
    Files.deleteIfExists(record(simId));
  }

  /** Returns the record of a run. */
  RunRecord read(String simId) throws IOException {
    try {
      return RunRecord.ofJson(Files.readString(record(simId)));
    } catch (JsonParseException e) {
      throw new IOException(e.getMessage(), e);
    }
  }

  /** Receives what a folder has. */
  interface Reader {
    void read(SpoolFolder folder, RunRecord run) throws IOException;
  }

  /** Reads all records that can be read, one after the other; other files stay as they are. */
  void readAll(Reader reader) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      for (Path file : files.filter(path -> path.toString().endsWith(RECORD)).sorted().toList()) {
        RunRecord found;
        try {
          found = RunRecord.ofJson(Files.readString(file));
        } catch (IOException | JsonParseException e) {
          LOG.warn(
              MessageCode.SPOOL_FOLDER + " {} cannot be read and is left as it is: {}",
              file,
              e.toString());
          continue;
        }
        reader.read(this, found);
      }
    }
  }

  @Override
  public void close() {
    try {
      lockFile.close();
    } catch (IOException e) {
      LOG.debug("the lock of {} does not close: {}", folder, e.toString());
    }
  }
}
