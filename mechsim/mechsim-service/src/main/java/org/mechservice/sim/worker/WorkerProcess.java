package org.mechservice.sim.worker;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.StreamCorruptedException;
import java.io.UTFDataFormatException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.mechservice.guard.Confinement;
import org.mechservice.guard.WorkerBounds;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Checkpoints;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.text.WellFormedText;

/** A worker process, as its host controls it. Runs once. */
public final class WorkerProcess {
  /** Exit status of a Java process that runs out of memory, with {@code ExitOnOutOfMemoryError}. */
  private static final int EXIT_OUT_OF_MEMORY = 3;

  /** Added to the number of the signal that has ended a process. */
  private static final int SIGNALLED = 128;

  private static final int SIGKILL = 9;
  private static final int SIGTERM = 15;
  private static final int SIGXCPU = 24;

  private static final String ASK_CLASSES =
      "Look for what the classes of the model's users do there.";

  private static final long WATCH_MILLIS = 20;

  /** A worker that has not stopped by then computes in a class that does not come back. */
  private static final long PATIENCE_MILLIS = 1000;

  private static final long DYING_SECONDS = 60;

  private static final int MOST_COLUMNS = 1_000_000;
  private static final int MOST_CHECKPOINT_BYTES = 1 << 28;
  private static final double MEGABYTE = 1e6;

  /** The command of a wall, its first process within, and Java. */
  private static final int PROCESSES_OF_WALL = 3;

  private final Confinement confinement;
  private final WorkerBounds bounds;
  private volatile Optional<Process> process = Optional.empty();
  private List<ProcessHandle> processes = List.of();
  private long cpuNanos;

  /**
   * @param confinement wall around the process
   * @param bounds what it may use at most
   */
  public WorkerProcess(Confinement confinement, WorkerBounds bounds) {
    this.confinement = confinement;
    this.bounds = bounds;
  }

  /**
   * Returns the processor time that the process and those of its wall have taken, ns; 0 before its
   * start.
   */
  public synchronized long cpuNanos() {
    if (process.isPresent() && processes.size() < (confinement.stands() ? PROCESSES_OF_WALL : 1)) {
      ProcessHandle started = process.get().toHandle();
      processes = Stream.concat(Stream.of(started), started.descendants()).toList();
    }
    long now =
        processes.stream()
            .flatMap(running -> running.info().totalCpuDuration().stream())
            .mapToLong(Duration::toNanos)
            .sum();
    cpuNanos = Math.max(cpuNanos, now); // the time of an ended process is not known any more
    return cpuNanos;
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
    } catch (StreamCorruptedException e) {
      throw new WorkerLostException(
          MessageCode.WORKER_ENDED,
          "the process of the run sent what makes no sense: " + e.getMessage() + ".",
          ASK_CLASSES);
    } catch (PeerGoneException e) {
      throw lost(started, bounds.heapBytes());
    } finally {
      started.destroyForcibly();
    }
  }

  private Process start() throws IOException {
    return confinement
        .command(bounds, WorkerMain.class, List.of())
        .redirectError(ProcessBuilder.Redirect.DISCARD)
        .start();
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
   * Returns the reason why a worker that has closed its end is gone. It may take its time to die:
   * its memory goes back to the system first.
   */
  static WorkerLostException lost(Process gone, long memoryBytes) {
    try {
      if (gone.waitFor(DYING_SECONDS, TimeUnit.SECONDS)) {
        return lost(gone.exitValue(), memoryBytes);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    return new WorkerLostException(
        MessageCode.WORKER_ENDED, "the process of the run does not answer any more.", ASK_CLASSES);
  }

  private static WorkerLostException lost(int status, long memoryBytes) {
    if (status == EXIT_OUT_OF_MEMORY) {
      return new WorkerLostException(
          MessageCode.OUT_OF_MEMORY,
          memoryBytes > 0
              ? String.format(
                  Locale.ROOT,
                  "the run needed more than the %.0f MB of memory that this host allows one"
                      + " process.",
                  memoryBytes / MEGABYTE)
              : "the run needed more memory than its process could get.",
          ASK_CLASSES);
    } else if (status == SIGNALLED + SIGKILL || status == SIGNALLED + SIGTERM) {
      return new WorkerLostException(
          MessageCode.WORKER_KILLED,
          "the process of the run was killed from outside, with signal "
              + (status - SIGNALLED)
              + ".",
          "Start the run again. If this happens again, ask the operator whether the machine has run"
              + " out of memory.");
    } else if (status == SIGNALLED + SIGXCPU) {
      return new WorkerLostException(
          MessageCode.WORKER_ENDED,
          "the process of the run has used up its processor time.",
          ASK_CLASSES);
    }
    return new WorkerLostException(
        MessageCode.WORKER_ENDED,
        "the process of the run ended unexpectedly, with status " + status + ".",
        ASK_CLASSES);
  }

  /** The worker has closed its end. */
  private static final class PeerGoneException extends IOException {
    private static final long serialVersionUID = 1L;

    PeerGoneException(IOException cause) {
      super(cause);
    }
  }

  /** The dialogue between host and worker. */
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
      send(
          () -> {
            order.write(out);
            ofCheckpoints.write(out);
          });
      while (true) {
        byte kind = receive(in::readByte);
        switch (kind) {
          case WorkerMain.COLUMNS -> sink.begin(columns());
          case WorkerMain.ROW -> sink.row(receive(this::nextRow));
          case WorkerMain.STEP -> step(true);
          case WorkerMain.WAIT -> step(false);
          case WorkerMain.CHECKPOINT -> checkpoints.keep(receive(this::checkpoint));
          case WorkerMain.END -> {
            return receive(() -> WorkerResult.read(in));
          }
          case WorkerMain.REFUSED -> throw refused();
          case WorkerMain.THROWN -> throw thrown();
          default -> throw new StreamCorruptedException("a message of the kind " + kind);
        }
      }
    }

    private WorkerLostException thrown() throws IOException {
      return new WorkerLostException(
          MessageCode.WORKER_ENDED,
          "the process of the run failed: " + receive(() -> WellFormedText.of(in.readUTF())) + ".",
          ASK_CLASSES);
    }

    private IllegalArgumentException refused() throws IOException {
      String why = receive(() -> WellFormedText.of(in.readUTF()));
      return new IllegalArgumentException(why);
    }

    private List<Variable> columns() throws IOException {
      int count = receive(in::readInt);
      if (count < 1 || count > MOST_COLUMNS || row.length > 0) {
        throw new StreamCorruptedException(count + " columns");
      }
      List<Variable> columns = new ArrayList<>();
      for (int i = 0; i < count; i++) {
        String name = receive(() -> WellFormedText.of(in.readUTF()));
        columns.add(new Variable(name, receive(() -> WellFormedText.of(in.readUTF()))));
      }
      row = new double[count];
      return columns;
    }

    private double[] nextRow() throws IOException {
      if (row.length == 0) {
        throw new StreamCorruptedException("a row before the columns");
      }
      for (int i = 0; i < row.length; i++) {
        row[i] = in.readDouble();
      }
      return row;
    }

    private byte[] checkpoint() throws IOException {
      int length = in.readInt();
      if (length < 0 || length > MOST_CHECKPOINT_BYTES) {
        throw new StreamCorruptedException("a checkpoint of " + length + " bytes");
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
      double time = receive(in::readDouble);
      double stepSize = receive(in::readDouble);
      int order = receive(in::readInt);
      long steps = receive(in::readLong);
      control.setStiff(receive(in::readBoolean));
      byte answer;
      if (mayBeSaved && isDue(time, stepSize, order, steps)) {
        answer = WorkerMain.SAVE;
      } else if (control.proceed(time, stepSize, order, steps)) {
        answer = WorkerMain.GO_ON;
      } else {
        answer = WorkerMain.STOP;
      }
      send(() -> out.writeByte(answer));
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
    private static <T> T receive(Reading<T> message)
        throws PeerGoneException, StreamCorruptedException {
      try {
        return message.read();
      } catch (StreamCorruptedException | UTFDataFormatException e) {
        throw new StreamCorruptedException(String.valueOf(e.getMessage()));
      } catch (IOException e) {
        throw new PeerGoneException(e);
      }
    }

    private void send(Writing message) throws PeerGoneException {
      try {
        message.write();
        out.flush();
      } catch (IOException e) {
        throw new PeerGoneException(e);
      }
    }
  }
}
