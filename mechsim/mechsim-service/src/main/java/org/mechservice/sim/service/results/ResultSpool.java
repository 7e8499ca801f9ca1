package org.mechservice.sim.service.results;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.mechservice.sim.service.limits.LimitReachedException;
import org.mechservice.sim.service.limits.SpoolQuota;

/**
 * The rows of one run. One thread appends, any number read at any row meanwhile; however many rows
 * there are and however slowly they are read, the heap holds one buffer of them, the rest is in a
 * file.
 */
public final class ResultSpool implements AutoCloseable {
  private static final int BUFFER_BYTES = 1 << 16;

  private final int columns;
  private final int rowBytes;
  private final RowFile place;
  private final SpoolQuota.Share account;
  private ByteBuffer tail;
  private @Nullable FileChannel file;
  private long rowsInFile;
  private long rows;
  private long accounted;
  private boolean ended;
  private boolean closed;

  /**
   * @param columns numbers per row
   * @param place file for rows that do not fit into memory
   * @param account counts the bytes on disk
   */
  ResultSpool(int columns, RowFile place, SpoolQuota.Share account) {
    this.columns = columns;
    this.place = place;
    this.account = account;
    rowBytes = columns * Double.BYTES;
    tail = ByteBuffer.allocate(Math.max(rowBytes, BUFFER_BYTES / rowBytes * rowBytes));
  }

  /**
   * Returns the rows that an earlier process has written.
   *
   * @throws IOException if they cannot be read
   */
  static ResultSpool left(int columns, RowFile place, SpoolQuota.Share account) throws IOException {
    ResultSpool spool = new ResultSpool(columns, place, account);
    spool.rows = place.size() / spool.rowBytes;
    spool.rowsInFile = spool.rows;
    spool.accounted = spool.rows * spool.rowBytes;
    account.note(spool.accounted);
    spool.end();
    return spool;
  }

  /** Returns the numbers per row. */
  public int columns() {
    return columns;
  }

  /**
   * Appends a row.
   *
   * @param values one number per column; not modified
   * @throws IOException if it cannot be kept
   */
  public synchronized void append(double[] values) throws IOException {
    if (closed) {
      throw new IOException("the results were deleted");
    }
    if (tail.remaining() < rowBytes) {
      emptyTail();
    }
    for (int column = 0; column < columns; column++) {
      tail.putDouble(values[column]);
    }
    rows++;
    notifyAll();
  }

  private void emptyTail() throws IOException {
    account.take(tail.position(), rows * rowBytes);
    accounted += tail.position();
    writeTail();
  }

  /**
   * Writes the rows so far to the file, if it outlives the process. Without this, the rows of a run
   * with little output would stay in memory until its end.
   *
   * @throws LimitReachedException if that is more than the run, or all runs, may have
   * @throws IOException if that is not possible
   */
  public synchronized void handOver() throws IOException {
    if (place.lasting() && !closed && !ended && tail.position() > 0) {
      emptyTail();
    }
  }

  private void writeTail() throws IOException {
    FileChannel channel = file == null ? place.open() : file;
    file = channel;
    tail.flip();
    long position = rowsInFile * rowBytes;
    while (tail.hasRemaining()) {
      position += channel.write(tail, position);
    }
    tail.clear();
    rowsInFile = rows;
  }

  /**
   * Writes all rows to the file, if it outlives the process, without forcing them to disk.
   *
   * @throws IOException if that is not possible
   */
  void write() throws IOException {
    written();
  }

  /**
   * Writes all rows to the file, if it outlives the process, and forces them to disk. Readers do
   * not wait meanwhile.
   *
   * @throws IOException if that is not possible
   */
  void secure() throws IOException {
    Optional<FileChannel> written = written();
    if (written.isPresent()) {
      written.get().force(true);
      synchronized (this) {
        if (ended) {
          tail = trimmed(tail);
          closeFile();
        }
      }
    }
  }

  private synchronized Optional<FileChannel> written() throws IOException {
    if (place.lasting() && !closed && (tail.position() > 0 || file != null)) {
      writeTail();
    }
    return place.lasting() && !closed ? Optional.ofNullable(file) : Optional.empty();
  }

  /** Declares that no row will follow. */
  public synchronized void end() {
    if (!ended) {
      ended = true;
      tail = trimmed(tail);
      if (place.lasting()) {
        // There can be thousands of ended runs, and there are not as many file descriptors.
        closeFile();
      }
      notifyAll();
    }
  }

  /** Ended runs are kept by the hundred, so they keep no more memory than their rows need. */
  private static ByteBuffer trimmed(ByteBuffer buffer) {
    return ByteBuffer.allocate(buffer.position()).put(buffer.flip());
  }

  /** Returns the number of rows so far. */
  public synchronized long rows() {
    return rows;
  }

  /** Returns whether there is no row from {@code row} on, and none will follow. */
  synchronized boolean endsAt(long row) {
    return ended && row >= rows;
  }

  /**
   * Waits until there is a row {@code row}, or there will be none, or the time is over.
   *
   * @param millis longest wait, ms
   */
  synchronized void await(long row, long millis) throws InterruptedException {
    long deadline = System.nanoTime() + millis * 1_000_000;
    while (rows <= row && !ended && !closed) {
      long left = (deadline - System.nanoTime() + 999_999) / 1_000_000;
      if (left <= 0) {
        return;
      }
      wait(left);
    }
  }

  /**
   * Reads rows.
   *
   * @param first row to begin with
   * @param count most rows to read
   * @return the rows that are there, one after the other
   * @throws IOException if they cannot be read, or were deleted
   */
  public double[] read(long first, int count) throws IOException {
    ByteBuffer bytes;
    int fromFile;
    FileChannel channel;
    synchronized (this) {
      if (closed) {
        throw new IOException("the results were deleted");
      }
      int present = (int) Math.max(0, Math.min(count, rows - first));
      fromFile = (int) Math.max(0, Math.min(present, rowsInFile - first));
      bytes = ByteBuffer.allocate(present * rowBytes);
      int fromTail = (present - fromFile) * rowBytes;
      int tailStart = (int) (first + fromFile - rowsInFile) * rowBytes;
      if (fromTail > 0) {
        bytes.put(fromFile * rowBytes, tail, tailStart, fromTail);
      }
      channel = file;
    }
    if (fromFile > 0) {
      readFile(channel, bytes, first * rowBytes, fromFile * rowBytes);
    }
    double[] values = new double[bytes.capacity() / Double.BYTES];
    bytes.clear().asDoubleBuffer().get(values);
    return values;
  }

  private void readFile(@Nullable FileChannel open, ByteBuffer bytes, long position, int length)
      throws IOException {
    if (open != null) {
      readChannel(open, bytes, position, length);
    } else {
      try (FileChannel again = place.open()) {
        readChannel(again, bytes, position, length);
      }
    }
  }

  private static void readChannel(FileChannel channel, ByteBuffer bytes, long position, int length)
      throws IOException {
    bytes.limit(length);
    while (bytes.hasRemaining()) {
      if (channel.read(bytes, position + bytes.position()) < 0) {
        throw new IOException("the file of the results is shorter than it was");
      }
    }
  }

  /** Ends all reading and frees the quota. */
  synchronized void giveUp() {
    closed = true;
    notifyAll();
    account.giveBack(accounted);
    accounted = 0;
  }

  /** Ends all reading; a file that outlives the process stays on disk. */
  @Override
  public synchronized void close() {
    giveUp();
    closeFile();
  }

  private void closeFile() {
    if (file != null) {
      try {
        file.close();
      } catch (IOException e) {
        throw new java.io.UncheckedIOException(e);
      } finally {
        file = null;
      }
    }
  }

  /** Deletes the rows. */
  void delete() {
    close();
    try {
      place.delete();
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }
}
