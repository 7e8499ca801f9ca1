package org.mechservice.study.run;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.ByteBuffer;
import java.nio.channels.ClosedByInterruptException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * The rows of a study so far, in the order of the points, behind a line that says which study it
 * is. A last line that is incomplete is forgotten when the file is opened again.
 */
final class StudyJournal implements AutoCloseable {
  private final Path file;
  private final RandomAccessFile access;
  private final FileChannel out;

  private StudyJournal(Path file, RandomAccessFile access) {
    this.file = file;
    this.access = access;
    this.out = access.getChannel();
  }

  /**
   * Opens a journal, or begins it.
   *
   * @param identity one line
   * @param row receives the complete rows in it, without their line breaks
   * @throws IOException S-181 if it is that of another study; S-042 if another process has it
   */
  static StudyJournal open(Path file, String identity, Consumer<String> row) throws IOException {
    StudyJournal journal = new StudyJournal(file, new RandomAccessFile(file.toFile(), "rw"));
    try {
      journal.lock();
      journal.begin(identity, row);
      return journal;
    } catch (IOException | RuntimeException e) {
      journal.close();
      throw e;
    }
  }

  private void lock() throws IOException {
    try {
      FileLock lock = out.tryLock();
      if (lock != null) {
        return;
      }
    } catch (OverlappingFileLockException e) {
      throw busy(e);
    }
    throw busy(null);
  }

  private IOException busy(@Nullable Exception cause) {
    return new IOException(
        MessageCode.FILE_UNUSABLE
            + " "
            + file
            + " is in use: the same study is running; wait for it, or write elsewhere with -o",
        cause);
  }

  private void begin(String identity, Consumer<String> row) throws IOException {
    long end = completeBytes();
    out.truncate(end);
    out.position(end);
    if (end == 0) {
      append(identity + "\n");
      return;
    }
    try (BufferedReader lines = Files.newBufferedReader(file)) {
      String first = lines.readLine();
      if (!identity.equals(first)) {
        throw new IOException(
            MessageCode.STUDY_CHANGED
                + " "
                + file
                + " was begun with another study file, model, version or part; delete it to begin"
                + " anew, or write elsewhere with -o");
      }
      for (String line = lines.readLine(); line != null; line = lines.readLine()) {
        row.accept(line);
      }
    }
  }

  /** Returns the place behind the last line break. */
  private long completeBytes() throws IOException {
    long end = out.size();
    ByteBuffer block = ByteBuffer.allocate(1 << 16);
    while (end > 0) {
      long start = Math.max(0, end - block.capacity());
      block.clear().limit((int) (end - start));
      while (block.hasRemaining() && out.read(block, start + block.position()) >= 0) {
        // reads until the block is full
      }
      for (int i = block.position() - 1; i >= 0; i--) {
        if (block.get(i) == '\n') {
          return start + i + 1;
        }
      }
      end = start;
    }
    return 0;
  }

  void append(String lines) throws IOException {
    ByteBuffer bytes = ByteBuffer.wrap(lines.getBytes(StandardCharsets.UTF_8));
    try {
      while (bytes.hasRemaining()) {
        out.write(bytes);
      }
    } catch (ClosedByInterruptException e) {
      throw e;
    } catch (IOException e) {
      // such as a full disk, of which Java does not say where
      throw new IOException(
          MessageCode.FILE_UNUSABLE
              + " "
              + file
              + " cannot be written: "
              + e.getMessage()
              + "; the complete rows in it are kept, and the same command goes on from there",
          e);
    }
  }

  /** Hands out the rows, without their line breaks. */
  void rows(RowReader row) throws IOException {
    try (BufferedReader lines = Files.newBufferedReader(file)) {
      lines.readLine();
      for (String line = lines.readLine(); line != null; line = lines.readLine()) {
        row.take(line);
      }
    }
  }

  /** Takes rows. */
  interface RowReader {
    /** Takes a row without its line break. */
    void take(String line) throws IOException;
  }

  @Override
  public void close() throws IOException {
    access.close();
  }

  /** Closes the journal and deletes it: its rows are in the table. */
  void delete() throws IOException {
    close();
    Files.deleteIfExists(file);
  }
}
