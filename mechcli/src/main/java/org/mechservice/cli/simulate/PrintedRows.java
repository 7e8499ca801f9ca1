package org.mechservice.cli.simulate;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import org.mechservice.solver.catalogue.MessageCode;

/** Standard output as a place for the rows of a run; a reader that has gone ends the run. */
final class PrintedRows extends OutputStream {
  private final PrintWriter terminal;

  PrintedRows(PrintWriter terminal) {
    this.terminal = terminal;
  }

  @Override
  public void write(int b) throws IOException {
    write(new byte[] {(byte) b}, 0, 1);
  }

  /** Writes whole characters only: a header line or numbers. */
  @Override
  public void write(byte[] bytes, int offset, int count) throws IOException {
    terminal.write(new String(bytes, offset, count, StandardCharsets.UTF_8));
    flush();
  }

  @Override
  public void flush() throws IOException {
    if (terminal.checkError()) {
      throw new IOException(
          MessageCode.FILE_UNUSABLE + " nobody reads standard output any more; the run has ended");
    }
  }

  /** Leaves standard output open. */
  @Override
  public void close() throws IOException {
    flush();
  }
}
