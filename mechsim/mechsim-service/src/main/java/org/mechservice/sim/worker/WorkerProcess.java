package org.mechservice.sim.worker;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Checkpoints;
import org.mechservice.solver.api.run.RunControl;

/** A worker as its host sees it. Runs once. */
public final class WorkerProcess {
  /** Exit status of a Java process that runs out of memory, with {@code ExitOnOutOfMemoryError}. */
  private static final int EXIT_OUT_OF_MEMORY = 3;

  private static final long WATCH_MILLIS = 20;

  /** A worker that has not stopped by then computes in a class that does not come back. */
  private static final long PATIENCE_MILLIS = 1000;

  private static final long DYING_SECONDS = 60;

  private static final int MOST_COLUMNS = 1_000_000;
  private static final int MOST_CHECKPOINT_BYTES = 1 << 28;
  private static final double MEGABYTE = 1e6;

  private final long memoryBytes;
  private volatile Optional<Process> process = Optional.empty();

  /**
   * @param memoryBytes most memory; negative: what Java takes by itself
   */
  public WorkerProcess(long memoryBytes) {
    this.memoryBytes = memoryBytes;
  }

  /** Returns the processor time the process has taken, ns; 0 before its start. */
  public long cpuNanos() {
    return process
        .flatMap(running -> running.info().totalCpuDuration())
        .map(Duration::toNanos)
        .orElse(0L);
  }

  /**
   * Computes a run in a new process.
   *
   * @param sink takes the rows
   * @param control steers and watches
   * @param checkpoints given one where the run is held or stopped, and, while the time between two
   *     is 0, after each step
   * @throws IllegalArgumentException if the settings do not fit the model; the message names the
   *     reason
   * @throws WorkerLostException if the process has ended without a result
   * @throws IOException if a row cannot be kept, or no process can be started
   */
  public WorkerResult run(
      WorkerOrder order, ResultSink sink, RunControl control, Checkpoints checkpoints)
      throws IOException {
    Process started = start();
    process = Optional.of(started);
    Thread watch = new Thread(() -> watch(started, control), "mechservice-worker-watch");
    watch.setDaemon(true);
    watch.start();
    try (DataOutputStream out =
            new DataOutputStream(new BufferedOutputStream(started.getOutputStream()));
        DataInputStream in =
            new DataInputStream(new BufferedInputStream(started.getInputStream()))) {
      return new Dialogue(in, out, sink, control, checkpoints).hold(order);
    } catch (PeerGoneException e) {
      throw lost(started, memoryBytes);
    } finally {
      started.destroyForcibly();
    }
  }

  private Process start() throws IOException {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    if (memoryBytes > 0) {
      command.add("-Xmx" + Math.max(memoryBytes, 1 << 24));
    }
    command.addAll(
        List.of(
            "-XX:+UseSerialGC",
            "-XX:+ExitOnOutOfMemoryError",
            "-XX:TieredStopAtLevel=4",
            "-Xshare:auto",
            "-cp",
            System.getProperty("java.class.path"),
            WorkerMain.class.getName()));
    ProcessBuilder builder =
        new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.DISCARD);
    builder.environment().clear();
    return builder.start();
  }

  /** Stops the worker on request; kills it if it does not end by itself. */
  private static void watch(Process started, RunControl control) {
    try {
      while (!started.waitFor(WATCH_MILLIS, TimeUnit.MILLISECONDS)) {
        if (control.stopRequested()) {
          started.getOutputStream().write(WorkerMain.STOP);
          started.getOutputStream().flush();
          if (!started.waitFor(PATIENCE_MILLIS, TimeUnit.MILLISECONDS)) {
            started.destroyForcibly();
          }
          return;
        }
      }
    } catch (IOException e) {
      started.destroyForcibly(); // it does not even listen
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      started.destroyForcibly();
    }
  }

  /**
   * Says why a worker is gone that has closed its end. It may take its time to die: its memory goes
   * back to the system first.
   */
  static WorkerLostException lost(Process gone, long memoryBytes) {
    try {
      if (gone.waitFor(DYING_SECONDS, TimeUnit.SECONDS)) {
        return lost(gone.exitValue(), memoryBytes);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    return new WorkerLostException("the process of the run does not answer any more.", false);
  }

  private static WorkerLostException lost(int status, long memoryBytes) {
    if (status != EXIT_OUT_OF_MEMORY) {
      return new WorkerLostException(
          "the process of the run ended unexpectedly, with status " + status + ".", false);
    }
    return new WorkerLostException(
        memoryBytes > 0
            ? String.format(
                Locale.ROOT,
                "the run needed more than the %.0f MB of memory that this host allows one process.",
                memoryBytes / MEGABYTE)
            : "the run needed more memory than its process could get.",
        true);
  }

  /** The worker has closed its end. */
  private static final class PeerGoneException extends IOException {
    private static final long serialVersionUID = 1L;

    PeerGoneException(IOException cause) {
      super(cause);
    }
  }

  /** What host and worker say to each other. */
  private static final class Dialogue {
    private final DataInputStream in;
    private final DataOutputStream out;
    private final ResultSink sink;
    private final RunControl control;
    private final Checkpoints checkpoints;
    private double[] row = new double[0];

    Dialogue(
        DataInputStream in,
        DataOutputStream out,
        ResultSink sink,
        RunControl control,
        Checkpoints checkpoints) {
      this.in = in;
      this.out = out;
      this.sink = sink;
      this.control = control;
      this.checkpoints = checkpoints;
    }

    WorkerResult hold(WorkerOrder order) throws IOException {
      CheckpointOrder ofCheckpoints = CheckpointOrder.of(checkpoints);
      say(
          () -> {
            order.write(out);
            ofCheckpoints.write(out);
          });
      while (true) {
        byte kind = hear(in::readByte);
        switch (kind) {
          case WorkerMain.COLUMNS -> sink.begin(columns());
          case WorkerMain.ROW -> sink.row(hear(this::nextRow));
          case WorkerMain.STEP -> step(true);
          case WorkerMain.WAIT -> step(false);
          case WorkerMain.CHECKPOINT -> checkpoints.keep(hear(this::checkpoint));
          case WorkerMain.END -> {
            return hear(() -> WorkerResult.read(in));
          }
          case WorkerMain.REFUSED -> throw refused();
          default -> throw new PeerGoneException(new IOException("message " + kind));
        }
      }
    }

    private IllegalArgumentException refused() throws PeerGoneException {
      String why = hear(in::readUTF);
      return new IllegalArgumentException(why);
    }

    private List<Variable> columns() throws IOException {
      int count = hear(in::readInt);
      if (count < 0 || count > MOST_COLUMNS) {
        throw new PeerGoneException(new IOException(count + " columns"));
      }
      List<Variable> columns = new ArrayList<>();
      for (int i = 0; i < count; i++) {
        String name = hear(in::readUTF);
        columns.add(new Variable(name, hear(in::readUTF)));
      }
      row = new double[count];
      return columns;
    }

    private double[] nextRow() throws IOException {
      for (int i = 0; i < row.length; i++) {
        row[i] = in.readDouble();
      }
      return row;
    }

    private byte[] checkpoint() throws IOException {
      int length = in.readInt();
      if (length < 0 || length > MOST_CHECKPOINT_BYTES) {
        throw new IOException("a checkpoint of " + length + " bytes");
      }
      byte[] bytes = in.readNBytes(length);
      if (bytes.length < length) {
        throw new EOFException();
      }
      return bytes;
    }

    /**
     * Answers a worker that has taken a step.
     *
     * @param mayBeSaved whether it can make a checkpoint before it goes on
     */
    private void step(boolean mayBeSaved) throws IOException {
      double time = hear(in::readDouble);
      double stepSize = hear(in::readDouble);
      int order = hear(in::readInt);
      long steps = hear(in::readLong);
      byte answer;
      if (mayBeSaved && isDue(time, stepSize, order, steps)) {
        answer = WorkerMain.SAVE;
      } else if (control.proceed(time, stepSize, order, steps)) {
        answer = WorkerMain.GO_ON;
      } else {
        answer = WorkerMain.STOP;
      }
      say(() -> out.writeByte(answer));
    }

    private boolean isDue(double time, double stepSize, int order, long steps) {
      double between = checkpoints.secondsBetween();
      return Double.isFinite(between)
          && (between == 0 || control.holdsAt(time, stepSize, order, steps));
    }

    private interface Reading<T> {
      T read() throws IOException;
    }

    private interface Writing {
      void write() throws IOException;
    }

    /**
     * A row that cannot be kept is the host's trouble; a message that does not come, the worker's.
     */
    private static <T> T hear(Reading<T> message) throws PeerGoneException {
      try {
        return message.read();
      } catch (IOException e) {
        throw new PeerGoneException(e);
      }
    }

    private void say(Writing message) throws PeerGoneException {
      try {
        message.write();
        out.flush();
      } catch (IOException e) {
        throw new PeerGoneException(e);
      }
    }
  }
}
