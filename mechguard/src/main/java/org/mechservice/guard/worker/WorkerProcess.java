package org.mechservice.guard.worker;

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
import java.util.concurrent.CancellationException;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import java.util.stream.Stream;
import org.mechservice.guard.Confinement;
import org.mechservice.guard.LowPriority;
import org.mechservice.guard.Patience;
import org.mechservice.guard.WorkerBounds;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Checkpoints;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.text.WellFormedText;

/**
 * A worker process, as its host or the program of a user controls it. It may be asked what its
 * model is, and runs it once.
 */
public final class WorkerProcess implements AutoCloseable {
  /** Exit status of a Java process that runs out of memory, with {@code ExitOnOutOfMemoryError}. */
  private static final int EXIT_OUT_OF_MEMORY = 3;

  /** Added to the number of the signal that has ended a process. */
  private static final int SIGNALLED = 128;

  private static final int SIGKILL = 9;
  private static final int SIGTERM = 15;
  private static final int SIGXCPU = 24;

  static final String ASK_CLASSES = "Look for what the classes of the model's users do there.";

  private static final long WATCH_MILLIS = 20;

  /** A worker that has not stopped by then computes in a class that does not come back. */
  private static final long PATIENCE_MILLIS = 1000;

  private static final long DYING_SECONDS = 60;

  /** Far more than the start of Java and of a large model's class takes. */
  private static final Duration LONGEST_DESCRIPTION = Duration.ofSeconds(60);

  private static final int MOST_CHECKPOINT_BYTES = 1 << 28;
  private static final double MEGABYTE = 1e6;
  private static final double NANOSECONDS = 1e9;

  /** The command of a wall, its first process within, and Java. */
  private static final int PROCESSES_OF_WALL = 3;

  private final Confinement confinement;
  private final WorkerBounds bounds;
  private volatile Optional<Process> process = Optional.empty();
  private Optional<Talk> talk = Optional.empty();

  /** Whether the process has its model, which it has described. */
  private boolean described;

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

  /** Lets others come first at the operating system, from now on. */
  public synchronized void lowerPriority() {
    process.map(Process::toHandle).ifPresent(LowPriority::lower);
  }

  /**
   * The process, and the streams to and from it.
   *
   * @param memoryBytes what it may use
   */
  record Talk(Process process, DataOutputStream out, DataInputStream in, long memoryBytes) {
    static Talk with(Process started, WorkerBounds bounds) {
      return new Talk(
          started,
          new DataOutputStream(new BufferedOutputStream(started.getOutputStream())),
          new DataInputStream(new BufferedInputStream(started.getInputStream())),
          bounds.heapBytes());
    }

    /** Returns what an end of the talk that was not expected says of the process. */
    WorkerLostException lost(IOException end) {
      if (end instanceof StreamCorruptedException nonsense) {
        return makesNoSense(nonsense);
      }
      return WorkerProcess.lost(process, memoryBytes);
    }
  }

  /**
   * Starts the process, which waits for its model: while that is on its way, Java starts.
   *
   * @throws IOException if it cannot be started
   */
  public synchronized void begin() throws IOException {
    if (talk.isEmpty()) {
      Process started =
          Confinement.start(
              confinement
                  .command(bounds, WorkerMain.class, List.of())
                  .redirectError(ProcessBuilder.Redirect.DISCARD));
      process = Optional.of(started);
      talk = Optional.of(Talk.with(started, bounds));
    }
  }

  /**
   * Asks the process what its model is; its run continues in the same process.
   *
   * @throws IllegalArgumentException if the model refuses to be made; the message names the reason
   * @throws WorkerLostException if the process has ended, or does not answer
   * @throws IOException if no process can be started
   */
  public WorkerDescription describe(WorkerModel model) throws IOException {
    Talk started = talk();
    described = true;
    boolean answered = false;
    try (Patience patience =
        new Patience(started.process(), LONGEST_DESCRIPTION, "the description of a model")) {
      patience.begin();
      try {
        send(
            started.out(),
            () -> {
              model.write(started.out());
              started.out().writeByte(WorkerMain.DESCRIBE);
            });
        WorkerDescription description = answer(started.in());
        answered = true;
        return description;
      } catch (StreamCorruptedException | PeerGoneException e) {
        throw lost(patience, ASK_CLASSES).orElseGet(() -> started.lost(e));
      }
    } finally {
      if (!answered) {
        close();
      }
    }
  }

  private static WorkerDescription answer(DataInputStream in) throws IOException {
    byte kind = receive(in::readByte);
    return switch (kind) {
      case WorkerMain.DESCRIPTION -> receive(() -> WorkerDescription.read(in));
      case WorkerMain.REFUSED -> throw refused(in);
      case WorkerMain.THROWN -> throw thrown(in);
      default -> throw new StreamCorruptedException("a message of the kind " + kind);
    };
  }

  private synchronized Talk talk() throws IOException {
    begin();
    return talk.orElseThrow();
  }

  /**
   * Computes a run, in a new process if there is none that has described the model.
   *
   * @param order of a run, of the model that the process has described
   * @param sink takes the rows
   * @param control steers and watches
   * @param checkpoints given one where the run is held or stopped, and after the first step when
   *     the time between two is over
   * @throws IllegalArgumentException if the settings do not fit the model; the message names the
   *     reason
   * @throws WorkerLostException if the process has ended without a result
   * @throws IOException if a row cannot be kept, or no process can be started
   */
  public WorkerResult run(
      WorkerOrder order, ResultSink sink, RunControl control, Checkpoints checkpoints)
      throws IOException {
    Talk with = talk();
    boolean hasModel = described;
    try (Dialogue dialogue = new Dialogue(with.in(), with.out(), sink, control, checkpoints)) {
      Thread watch =
          new Thread(() -> watch(with.process(), control, dialogue), "mechservice-worker-watch");
      watch.setDaemon(true);
      watch.start();
      return dialogue.hold(order, hasModel);
    } catch (StreamCorruptedException | PeerGoneException e) {
      throw with.lost(e);
    } finally {
      with.process().destroyForcibly();
    }
  }

  /**
   * Returns the columns of a run, whose first row the process computes. It ends with the thread
   * that waits for it, and after as long as a description may take.
   *
   * @param order of a run that ends where it begins
   * @throws IllegalArgumentException if the settings do not fit the model
   * @throws WorkerLostException if the process has ended without a result
   * @throws IOException if no process can be started
   * @throws CancellationException if the thread is interrupted, which it stays
   */
  public List<Variable> columns(WorkerOrder order) throws IOException {
    List<Variable> named = new ArrayList<>();
    ResultSink names =
        new ResultSink() {
          @Override
          public void begin(List<Variable> columns) {
            named.addAll(columns);
          }

          @Override
          public void row(double[] values) {}
        };
    try (Patience patience =
        new Patience(talk().process(), LONGEST_DESCRIPTION, "the first row of a run")) {
      patience.begin();
      try {
        run(order, names, new RunControl(), Checkpoints.NONE);
      } catch (WorkerLostException e) {
        if (Thread.currentThread().isInterrupted()) {
          throw new CancellationException("the caller was interrupted");
        }
        throw lost(patience, ASK_CLASSES).orElse(e);
      }
    }
    return named;
  }

  /**
   * Begins a run that is stepped from outside, of the model that the process has described.
   *
   * @param hash identifies the model in saved runs
   * @param sink takes the rows
   * @param longest time of a call, after which the process is taken for lost
   * @param reports makes a report of what the worker tells
   * @throws IllegalArgumentException if the settings do not fit the model; the message names the
   *     reason
   * @throws WorkerLostException if the process has ended
   */
  public WorkerSteps steps(
      WorkerOrder order,
      String hash,
      ResultSink sink,
      Duration longest,
      Function<WorkerResult, RunReport> reports)
      throws IOException {
    Talk with = talk();
    WorkerSteps steps = new WorkerSteps(with, sink, longest, reports);
    steps.order(
        () -> {
          with.out().writeByte(WorkerMain.STEPS);
          order.write(with.out());
          with.out().writeUTF(hash);
        });
    return steps;
  }

  /** Returns that the process was ended from here; empty if it was not. */
  static Optional<WorkerLostException> lost(Patience patience, String advice) {
    return patience
        .ended()
        .map(why -> new WorkerLostException(MessageCode.WORKER_ENDED, why, advice));
  }

  private static WorkerLostException makesNoSense(StreamCorruptedException e) {
    return new WorkerLostException(
        MessageCode.WORKER_ENDED,
        "the process of the run sent what makes no sense: " + e.getMessage() + ".",
        ASK_CLASSES);
  }

  /** Ends the process, if there is one. */
  @Override
  public void close() {
    process.ifPresent(Process::destroyForcibly);
  }

  /**
   * Stops the worker on request, and lets it ask again if it may be held; kills it if it does not
   * end by itself.
   */
  private static void watch(Process started, RunControl control, Dialogue dialogue) {
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
        dialogue.letAskIfItMayBeHeld();
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
  static final class PeerGoneException extends IOException {
    private static final long serialVersionUID = 1L;

    PeerGoneException(IOException cause) {
      super(cause);
    }
  }

  /** The dialogue between host and worker. */
  private static final class Dialogue implements AutoCloseable {
    private final DataInputStream in;
    private final DataOutputStream out;
    private final WorkerRows rows;
    private final RunControl control;
    private final Checkpoints checkpoints;

    /** When the last checkpoint was kept, or the run began. */
    private volatile long savedAt = System.nanoTime();

    /** Whether the worker goes on without asking; as its last answer or wish said. */
    private boolean free;

    Dialogue(
        DataInputStream in,
        DataOutputStream out,
        ResultSink sink,
        RunControl control,
        Checkpoints checkpoints) {
      this.in = in;
      this.out = out;
      this.rows = new WorkerRows(in, sink);
      this.control = control;
      this.checkpoints = checkpoints;
    }

    @Override
    public void close() throws IOException {
      try (in) {
        out.close();
      }
    }

    /**
     * @param hasModel whether the worker has the model of the order already
     */
    WorkerResult hold(WorkerOrder order, boolean hasModel) throws IOException {
      CheckpointOrder ofCheckpoints = CheckpointOrder.of(checkpoints);
      send(
          out,
          () -> {
            if (!hasModel) {
              order.model().write(out);
            }
            out.writeByte(WorkerMain.RUN);
            order.write(out);
            ofCheckpoints.write(out);
          });
      while (true) {
        byte kind = receive(in::readByte);
        switch (kind) {
          case WorkerMain.COLUMNS -> rows.begin();
          case WorkerMain.ROW -> rows.next();
          case WorkerMain.STEP -> step(true);
          case WorkerMain.WAIT -> step(false);
          case WorkerMain.REACHED -> reached();
          case WorkerMain.CHECKPOINT -> {
            checkpoints.keep(receive(() -> readBytes(in)));
            savedAt = System.nanoTime();
          }
          case WorkerMain.END -> {
            return receive(() -> WorkerResult.read(in));
          }
          case WorkerMain.REFUSED -> throw refused(in);
          case WorkerMain.THROWN -> throw thrown(in);
          default -> throw new StreamCorruptedException("a message of the kind " + kind);
        }
      }
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
      if (mayBeSaved && isDue(time, stepSize, order, steps)) {
        answer(WorkerMain.SAVE);
      } else {
        answer(control.proceed(time, stepSize, order, steps) ? WorkerMain.GO_ON : WorkerMain.STOP);
      }
    }

    /** Answers a worker that waits; it is let go on freely if nothing can hold it. */
    private synchronized void answer(byte answer) throws IOException {
      free = answer == WorkerMain.GO_ON && mayGoFreely();
      send(out, () -> out.writeByte(free ? WorkerMain.GO_FREELY : answer));
    }

    /** Notes how far a worker is that goes on freely. */
    private void reached() throws IOException {
      double time = receive(in::readDouble);
      double stepSize = receive(in::readDouble);
      int order = receive(in::readInt);
      control.reached(time, stepSize, order, receive(in::readLong));
      control.setStiff(receive(in::readBoolean));
      letAskIfItMayBeHeld();
    }

    private boolean mayGoFreely() {
      return control.isFree() && !isTimeToSave();
    }

    /** Lets a worker that goes on freely ask after its next step, if it may be held there. */
    synchronized void letAskIfItMayBeHeld() throws IOException {
      if (free && !mayGoFreely()) {
        free = false;
        send(out, () -> out.writeByte(WorkerMain.ASK));
      }
    }

    private boolean isDue(double time, double stepSize, int order, long steps) {
      return Double.isFinite(checkpoints.secondsBetween())
          && (isTimeToSave() || control.holdsAt(time, stepSize, order, steps));
    }

    private boolean isTimeToSave() {
      return (System.nanoTime() - savedAt) / NANOSECONDS >= checkpoints.secondsBetween();
    }
  }

  /** Reads a saved run. */
  static byte[] readBytes(DataInputStream in) throws IOException {
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

  static WorkerLostException thrown(DataInputStream in) throws IOException {
    return new WorkerLostException(
        MessageCode.WORKER_ENDED,
        "the process of the run failed: " + receive(() -> WellFormedText.of(in.readUTF())) + ".",
        ASK_CLASSES);
  }

  static IllegalArgumentException refused(DataInputStream in) throws IOException {
    String why = receive(() -> WellFormedText.of(in.readUTF()));
    return new IllegalArgumentException(why);
  }

  interface Reading<T> {
    T read() throws IOException;
  }

  interface Writing {
    void write() throws IOException;
  }

  /**
   * A row that cannot be kept is the host's trouble; a message that does not come, the worker's.
   */
  static <T> T receive(Reading<T> message) throws PeerGoneException, StreamCorruptedException {
    try {
      return message.read();
    } catch (StreamCorruptedException | UTFDataFormatException e) {
      throw new StreamCorruptedException(String.valueOf(e.getMessage()));
    } catch (IOException e) {
      throw new PeerGoneException(e);
    }
  }

  static void send(DataOutputStream out, Writing message) throws PeerGoneException {
    try {
      message.write();
      out.flush();
    } catch (IOException e) {
      throw new PeerGoneException(e);
    }
  }
}
