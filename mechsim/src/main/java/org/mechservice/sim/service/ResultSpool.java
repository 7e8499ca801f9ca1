package org.mechservice.sim.service;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import org.jspecify.annotations.Nullable;

/**
 * The rows of one run. One thread appends, any number read at any row meanwhile; however many rows
 * there are and however slowly they are read, the heap holds one buffer of them, the rest is in a
 * temporary file. The file has no name any more once it is open (where the system allows that), so
 * nothing is left of it when the process ends, however it ends.
 */
final class ResultSpool implements AutoCloseable {
  private static final int BUFFER_BYTES = 1 << 16;

  private final int columns;
  private final int rowBytes;
  private final ByteBuffer tail;
  private @Nullable FileChannel file;
  private long rowsInFile;
  private long rows;
  private boolean ended;
  private boolean closed;

  /**
   * @param columns numbers per row
   */
  ResultSpool(int columns) {
    this.columns = columns;
    rowBytes = columns * Double.BYTES;
    tail = ByteBuffer.allocate(Math.max(rowBytes, BUFFER_BYTES / rowBytes * rowBytes));
  }

  /** Returns the numbers per row. */
  int columns() {
    return columns;
  }

  /**
   * Appends a row.
   *
   * @param values one number per column; not modified
   * @throws IOException if it cannot be kept
   */
  synchronized void append(double[] values) throws IOException {
    if (closed) {
      throw new IOException("the results were deleted");
    }
    if (tail.remaining() < rowBytes) {
      writeTail();
    }
    for (int column = 0; column < columns; column++) {
      tail.putDouble(values[column]);
    }
    rows++;
    notifyAll();
  }

  private void writeTail() throws IOException {
    FileChannel channel = file == null ? createFile() : file;
    file = channel;
    tail.flip();
    long position = rowsInFile * rowBytes;
    while (tail.hasRemaining()) {
      position += channel.write(tail, position);
    }
    tail.clear();
    rowsInFile = rows;
  }

  private static FileChannel createFile() throws IOException {
    Path path = Files.createTempFile("mechservice-", ".rows");
    return FileChannel.open(
        path,
        StandardOpenOption.READ,
        StandardOpenOption.WRITE,
        StandardOpenOption.DELETE_ON_CLOSE);
  }

  /** Declares that no row will follow. */
  synchronized void end() {
    ended = true;
    notifyAll();
  }

  /** Returns the number of rows so far. */
  synchronized long rows() {
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
  double[] read(long first, int count) throws IOException {
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
    if (channel != null) {
      readFile(channel, bytes, first * rowBytes, fromFile * rowBytes);
    }
    double[] values = new double[bytes.capacity() / Double.BYTES];
    bytes.clear().asDoubleBuffer().get(values);
    return values;
  }

  private static void readFile(FileChannel channel, ByteBuffer bytes, long position, int length)
      throws IOException {
    bytes.limit(length);
    while (bytes.hasRemaining()) {
      if (channel.read(bytes, position + bytes.position()) < 0) {
        throw new IOException("the file of the results is shorter than it was");
      }
    }
  }

  /** Deletes the rows. */
  @Override
  public synchronized void close() {
    closed = true;
    notifyAll();
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
}
