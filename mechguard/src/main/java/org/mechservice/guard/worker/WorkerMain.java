package org.mechservice.guard.worker;

import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.io.StreamCorruptedException;
import java.util.List;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.concurrent.Semaphore;
import org.mechservice.guard.ModelClassLoader;
import org.mechservice.guard.UserClassLoader;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelSource;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Checkpoints;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.StepwiseRun;

/** Main class of a worker process: computes one run and ends. */
public final class WorkerMain implements ResultSink {
  // From the worker
  static final byte DESCRIPTION = 'D';
  static final byte COLUMNS = 'C';
  static final byte ROW = 'R';
  static final byte STEP = 'P';
  static final byte WAIT = 'W';
  static final byte REACHED = 'F';
  static final byte CHECKPOINT = 'K';
  static final byte END = 'E';
  static final byte REFUSED = 'X';
  static final byte THROWN = 'T';
  // To the worker, after the model
  static final byte DESCRIBE = 'Q';
  static final byte RUN = 'O';
  static final byte STEPS = 'I';
  // To the worker, while it runs
  static final byte GO_ON = 'G';
  static final byte GO_FREELY = 'L';
  static final byte ASK = 'A';
  static final byte STOP = 'S';
  static final byte SAVE = 'V';

  /** Time between two messages of a run that goes on freely. */
  private static final long REACHED_NANOS = 5_000_000;

  /** Longest text of a failure, in characters; 3 bytes each fit into a message. */
  private static final int MOST_TEXT = 10_000;

  private final DataInputStream in;
  private final DataOutputStream out;
  private final AskingControl control = new AskingControl();
  private final Semaphore answers = new Semaphore(0);
  private volatile byte answer;

  private WorkerMain(InputStream in, OutputStream out) {
    this.in = new DataInputStream(in);
    this.out = new DataOutputStream(new BufferedOutputStream(out));
  }

  /**
   * Reads the order from standard input, computes, and writes rows and result to standard output.
   */
  public static void main(String[] arguments) throws IOException {
    // Not System.out, which hides that the host has closed its end.
    OutputStream out = new FileOutputStream(FileDescriptor.out);
    // Nothing a class prints may get between the messages.
    System.setOut(new PrintStream(OutputStream.nullOutputStream(), false, "US-ASCII"));
    new WorkerMain(System.in, out).work();
    Runtime.getRuntime().halt(0);
  }

  private void work() throws IOException {
    WorkerModel model = WorkerModel.read(in);
    try {
      Optional<ModelSource> described = Optional.empty();
      byte asked = in.readByte();
      if (asked == DESCRIBE) {
        described = Optional.of(source(model));
        WorkerDescription description = WorkerDescription.of(described.get());
        out.writeByte(DESCRIPTION);
        description.write(out);
        out.flush();
        asked = in.readByte();
      }
      if (asked != RUN && asked != STEPS) {
        throw new StreamCorruptedException("an order of the kind " + asked);
      }
      WorkerOrder order = WorkerOrder.read(model, in);
      if (asked == STEPS) {
        serveSteps(described.isPresent() ? described.get() : source(model), order);
        return;
      }
      CheckpointOrder checkpoints = CheckpointOrder.read(in);
      Thread listener = new Thread(this::listen, "orders");
      listener.setDaemon(true);
      listener.start();
      RunReport report =
          run(
              described.isPresent() ? described.get() : source(model),
              order,
              new SentCheckpoints(checkpoints));
      control.tellLast();
      out.writeByte(END);
      new WorkerResult(report.asMap(), report.outcome()).write(out);
    } catch (IllegalArgumentException e) {
      out.writeByte(REFUSED);
      out.writeUTF(clipped(String.valueOf(e.getMessage())));
    } catch (OutOfMemoryError e) {
      throw e; // ends the process with a status of its own
    } catch (RuntimeException | Error e) {
      out.writeByte(THROWN);
      out.writeUTF(clipped(e.toString()));
    }
    out.flush();
  }

  /** Returns a text that fits into a message. */
  static String clipped(String text) {
    return text.length() > MOST_TEXT ? text.substring(0, MOST_TEXT) + "..." : text;
  }

  private static ModelSource source(WorkerModel model) {
    ClassLoader classes =
        new ModelClassLoader(model.classFiles(), new UserClassLoader(model.userClassFiles()));
    try {
      return ModelSource.from(classes.loadClass(model.className()).getConstructor().newInstance());
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(e);
    }
  }

  private static Solver solver() {
    return ServiceLoader.load(Solver.class, WorkerMain.class.getClassLoader())
        .findFirst()
        .orElseThrow(() -> new IllegalStateException("no solver on the class path"));
  }

  private void serveSteps(ModelSource source, WorkerOrder order) throws IOException {
    Model model = source.model(order.values());
    String hash = in.readUTF();
    StepwiseRun run = solver().stepped(model, order.request(), this, hash);
    out.writeByte(StepServant.DONE);
    out.flush();
    new StepServant(in, out, run, model.description().stateCount()).serve();
  }

  private RunReport run(ModelSource source, WorkerOrder order, Checkpoints checkpoints)
      throws IOException {
    return solver().run(source.model(order.values()), order.request(), this, control, checkpoints);
  }

  /**
   * A control that asks the host after every step whether the run continues, and waits for the
   * answer; while the host lets it go on freely, it tells now and then how far it is.
   */
  private final class AskingControl extends RunControl {
    private volatile boolean free;

    /** Whether the host has let the run go on from the present step already. */
    private boolean letGo;

    private long toldAt;
    private boolean untold;

    /** Returns whether the host wants a checkpoint of this step before the next one. */
    @Override
    public boolean holdsAt(double time, double stepSize, int order, long steps) {
      letGo = goesFreely(time, stepSize, order, steps);
      if (letGo) {
        return false;
      }
      boolean save = ask(STEP, time, stepSize, order, steps) == SAVE && !stopRequested();
      letGo = !save;
      return save;
    }

    @Override
    public boolean proceed(double time, double stepSize, int order, long steps) {
      if (!letGo && !goesFreely(time, stepSize, order, steps)) {
        ask(WAIT, time, stepSize, order, steps);
      }
      letGo = false;
      return !stopRequested();
    }

    private boolean goesFreely(double time, double stepSize, int order, long steps) {
      if (!free) {
        return false;
      }
      reached(time, stepSize, order, steps);
      untold = true;
      if (System.nanoTime() - toldAt > REACHED_NANOS) {
        tellLast();
        toldAt = System.nanoTime();
      }
      return true;
    }

    /** Tells the host how far the run is, if it does not know. */
    void tellLast() {
      if (untold) {
        untold = false;
        tell(REACHED, time(), stepSize(), order(), steps());
      }
    }

    void setFree(boolean free) {
      this.free = free;
    }

    private boolean tell(byte kind, double time, double stepSize, int order, long steps) {
      try {
        out.writeByte(kind);
        out.writeDouble(time);
        out.writeDouble(stepSize);
        out.writeInt(order);
        out.writeLong(steps);
        out.writeBoolean(stiff());
        out.flush();
        return true;
      } catch (IOException e) {
        stop(); // the host has closed the pipe
        return false;
      }
    }

    private byte ask(byte kind, double time, double stepSize, int order, long steps) {
      untold = false;
      if (!tell(kind, time, stepSize, order, steps)) {
        return STOP;
      }
      answers.acquireUninterruptibly();
      return answer;
    }
  }

  /** Leaves checkpoints where the host wants them. */
  private final class SentCheckpoints implements Checkpoints {
    private final CheckpointOrder order;

    SentCheckpoints(CheckpointOrder order) {
      this.order = order;
    }

    @Override
    public String modelHash() {
      return order.modelHash();
    }

    /** {@inheritDoc} Finite: where the control holds the run, and where it is stopped. */
    @Override
    public double secondsBetween() {
      return order.possible() ? Double.MAX_VALUE : Double.POSITIVE_INFINITY;
    }

    @Override
    public Optional<byte[]> saved() {
      return order.saved();
    }

    @Override
    public void keep(byte[] checkpoint) throws IOException {
      out.writeByte(CHECKPOINT);
      out.writeInt(checkpoint.length);
      out.write(checkpoint);
    }
  }

  /** Takes the host's answers and its wish to be asked or to stop, until its process ends. */
  private void listen() {
    try {
      for (int order = in.read(); order >= 0; order = in.read()) {
        if (order == STOP) {
          control.stop();
        }
        control.setFree(order == GO_FREELY);
        if (order != ASK) {
          answer = (byte) order;
          answers.release();
        }
      }
    } catch (IOException e) {
      // The same as the end of the stream.
    }
    Runtime.getRuntime().halt(1);
  }

  @Override
  public void begin(List<Variable> columns) throws IOException {
    out.writeByte(COLUMNS);
    out.writeInt(columns.size());
    for (Variable column : columns) {
      out.writeUTF(column.name());
      out.writeUTF(column.unit());
    }
  }

  @Override
  public void row(double[] values) throws IOException {
    out.writeByte(ROW);
    for (double value : values) {
      out.writeDouble(value);
    }
  }
}
