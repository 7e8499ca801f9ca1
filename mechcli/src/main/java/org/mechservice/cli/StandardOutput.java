package org.mechservice.cli;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.util.Optional;

/** Standard output that remembers why it could not be written; Java's own says only that. */
final class StandardOutput extends FilterOutputStream {
  /** What the system says where the reader has read enough, as {@code head} does. */
  private static final String ENOUGH = "Broken pipe";

  private Optional<String> trouble = Optional.empty();

  StandardOutput(OutputStream to) {
    super(to);
  }

  static StandardOutput ofProcess() {
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
      trouble = Optional.of(String.valueOf(e.getMessage()));
      throw e;
    }
  }

  /** Returns why something is missing that its reader waits for. */
  Optional<String> trouble() {
    return trouble.filter(why -> !why.equals(ENOUGH));
  }
}
