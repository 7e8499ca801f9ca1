package org.mechservice.cli.shell;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.util.Optional;

/** Standard output that remembers why it could not be written; Java's own says only that. */
public final class StandardOutput extends FilterOutputStream {
  /** The system's message when the reader has closed the pipe, as {@code head} does. */
  private static final String ENOUGH = "Broken pipe";

  private Optional<String> failure = Optional.empty();

  StandardOutput(OutputStream to) {
    super(to);
  }

  public static StandardOutput ofProcess() {
    return new StandardOutput(new FileOutputStream(FileDescriptor.out));
  }

  @Override
  public void write(int b) throws IOException {
    write(new byte[] {(byte) b}, 0, 1);
  }

  @Override
  public void write(byte[] bytes, int offset, int count) throws IOException {
    try {
      out.write(bytes, offset, count);
    } catch (IOException e) {
      failure = Optional.of(String.valueOf(e.getMessage()));
      throw e;
    }
  }

  /** Returns why output is missing; empty if it was written or its reader closed the pipe. */
  public Optional<String> failure() {
    return failure.filter(why -> !why.equals(ENOUGH));
  }
}
