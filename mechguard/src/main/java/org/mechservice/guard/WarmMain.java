package org.mechservice.guard;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.FileDescriptor;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.util.Optional;

/**
 * The main loop of a process that {@link WarmProcesses} keeps: answers one request at a time on its
 * standard input and output, and ends when its parent does.
 */
public final class WarmMain {
  private static final long LOOK_MILLIS = 1000;

  /** Answers requests. */
  @FunctionalInterface
  public interface Service {
    /**
     * Reads the rest of a request and writes its answer.
     *
     * @param first first byte of the request, which has been read
     */
    void answer(int first, DataInputStream in, DataOutputStream out) throws IOException;
  }

  private final Service service;
  private final long idleMillis;
  private volatile long idleSince = System.nanoTime();
  private volatile boolean busy;

  private WarmMain(Service service, long idleMillis) {
    this.service = service;
    this.idleMillis = idleMillis;
  }

  /**
   * Answers what comes on standard input, until it ends, the parent does, or nothing has come for
   * some time. Nothing that is printed gets between the answers.
   *
   * @param idleMillis longest wait for a request, ms
   */
  public static void serve(Service service, long idleMillis) throws IOException {
    OutputStream out = new FileOutputStream(FileDescriptor.out);
    System.setOut(new PrintStream(OutputStream.nullOutputStream(), false, "US-ASCII"));
    new WarmMain(service, idleMillis)
        .serve(
            new DataInputStream(new BufferedInputStream(new FileInputStream(FileDescriptor.in))),
            new DataOutputStream(new BufferedOutputStream(out)));
  }

  private void serve(DataInputStream in, DataOutputStream out) throws IOException {
    Thread watch = new Thread(this::watch, "idle");
    watch.setDaemon(true);
    watch.start();
    try {
      for (int first = in.read(); first >= 0; first = in.read()) {
        busy = true;
        service.answer(first, in, out);
        out.flush();
        idleSince = System.nanoTime();
        busy = false;
      }
    } catch (EOFException e) {
      // The parent has gone in the middle of a request.
    }
    Runtime.getRuntime().halt(0);
  }

  private void watch() {
    Optional<ProcessHandle> parent = ProcessHandle.current().parent();
    try {
      while (ProcessHandle.current().parent().equals(parent)
          && (busy || (System.nanoTime() - idleSince) / 1_000_000 < idleMillis)) {
        Thread.sleep(LOOK_MILLIS);
      }
    } catch (InterruptedException e) {
      // Ends the process, too.
    }
    Runtime.getRuntime().halt(0);
  }
}
