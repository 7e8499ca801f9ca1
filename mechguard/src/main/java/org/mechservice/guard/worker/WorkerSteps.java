package org.mechservice.guard.worker;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.StreamCorruptedException;
import java.io.UncheckedIOException;
import java.lang.ref.Cleaner;
import java.time.Duration;
import java.util.Optional;
import java.util.function.Function;
import org.mechservice.guard.Patience;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.StepwiseRun;

/**
 * A run that is stepped from outside, in a worker: numbers and texts come back from there, and no
 * class of the model is loaded here. Its process ends with this program, or when the run can no
 * longer be reached, or a call takes too long, or the thread of a call is interrupted.
 */
public final class WorkerSteps implements StepwiseRun {
  private static final String ADVICE =
      WorkerProcess.ASK_CLASSES + " Steps that are honest and take so long are made shorter.";

  private static final Cleaner UNREACHED = Cleaner.create();

  private final WorkerProcess.Talk talk;
  private final DataInputStream in;
  private final DataOutputStream out;
  private final WorkerRows rows;
  private final Function<WorkerResult, RunReport> reports;
  private final Patience patience;
  private final Cleaner.Cleanable process;
  private double time;
  private volatile boolean stepping;
  private volatile boolean interrupted;
  private Optional<WorkerResult> ended = Optional.empty();

  /** Why there is no process any more. */
  private Optional<WorkerLostException> lost = Optional.empty();

  /**
   * @param talk with a worker that has its order
   * @param sink takes the rows
   * @param longest time of a call
   * @param reports makes a report of what the worker tells
   */
  WorkerSteps(
      WorkerProcess.Talk talk,
      ResultSink sink,
      Duration longest,
      Function<WorkerResult, RunReport> reports) {
    this.talk = talk;
    in = talk.in();
    out = talk.out();
    rows = new WorkerRows(in, sink);
    this.reports = reports;
    Process started = talk.process();
    Patience waiting = new Patience(started, longest, "a step");
    patience = waiting;
    process =
        UNREACHED.register(
            this,
            () -> {
              waiting.close();
              started.destroyForcibly();
            });
  }

  /** Hands over the order; without an answer that it can be met there is no run. */
  void order(WorkerProcess.Writing order) throws IOException {
    boolean met = false;
    try {
      call(order, () -> true);
      met = true;
    } finally {
      if (!met) {
        process.clean();
      }
    }
  }

  @Override
  public void begin() throws IOException {
    advance(() -> out.writeByte(StepServant.BEGIN));
  }

  @Override
  public void restore(byte[] saved) {
    try {
      advance(
          () -> {
            out.writeByte(StepServant.RESTORE);
            out.writeInt(saved.length);
            out.write(saved);
          });
    } catch (IOException e) {
      throw new IllegalStateException(e);
    }
    if (ended.isPresent() && ended.get().outcome() instanceof Outcome.Failed lost) {
      throw new IllegalStateException(lost.failure().message());
    }
  }

  @Override
  public boolean step() throws IOException {
    requireGoesOn();
    stepping = true;
    try {
      advance(() -> out.writeByte(StepServant.STEP));
    } finally {
      stepping = false;
    }
    return ended.isEmpty();
  }

  private void requireGoesOn() {
    if (ended.isPresent()) {
      throw new IllegalStateException("the run has ended");
    }
  }

  @Override
  public void settle() throws IOException {
    requireGoesOn();
    advance(() -> out.writeByte(StepServant.SETTLE));
  }

  /** {@inheritDoc} The process ends, too. */
  @Override
  public void interrupt() {
    if (stepping) {
      interrupted = true;
      process.clean();
    }
  }

  /** Makes a call that takes the run on; one whose process is lost has failed. */
  private void advance(WorkerProcess.Writing call) throws IOException {
    try {
      ended =
          call(
              call,
              () -> {
                time = in.readDouble();
                return in.readBoolean()
                    ? Optional.of(WorkerResult.read(in))
                    : Optional.<WorkerResult>empty();
              });
    } catch (WorkerLostException e) {
      String cause = String.valueOf(e.getMessage());
      Failure failure = new Failure(e.code(), cause, time, 0, 0, "", e.advice());
      ended = Optional.of(interrupted ? WorkerResult.stopped() : WorkerResult.lost(failure));
    }
  }

  /**
   * Makes a call, takes the rows that come of it, and returns the answer that follows.
   *
   * @throws WorkerLostException if there is no process, or none any more
   */
  private <T> T call(WorkerProcess.Writing call, WorkerProcess.Reading<T> answer)
      throws IOException {
    if (lost.isPresent()) {
      throw lost.get();
    }
    patience.begin();
    try {
      WorkerProcess.send(out, call);
      takeRows();
      return WorkerProcess.receive(answer);
    } catch (WorkerProcess.PeerGoneException | StreamCorruptedException e) {
      throw lose(WorkerProcess.lost(patience, ADVICE).orElseGet(() -> talk.lost(e)));
    } catch (WorkerLostException e) {
      throw lose(e);
    } finally {
      patience.end();
    }
  }

  private WorkerLostException lose(WorkerLostException why) {
    lost = Optional.of(why);
    process.clean();
    return why;
  }

  /** Takes rows until an answer follows. */
  private void takeRows() throws IOException {
    while (true) {
      byte kind = WorkerProcess.receive(in::readByte);
      switch (kind) {
        case WorkerMain.COLUMNS -> rows.begin();
        case WorkerMain.ROW -> rows.next();
        case StepServant.DONE -> {
          return;
        }
        case WorkerMain.REFUSED -> throw WorkerProcess.refused(in);
        case StepServant.ILLEGAL ->
            throw new IllegalStateException(WorkerProcess.refused(in).getMessage());
        case WorkerMain.THROWN -> throw WorkerProcess.thrown(in);
        default -> throw new StreamCorruptedException("a message of the kind " + kind);
      }
    }
  }

  /** {@inheritDoc} Checked with the next call that has an answer. */
  @Override
  public void set(int component, double value) {
    try {
      WorkerProcess.send(
          out,
          () -> {
            out.writeByte(StepServant.SET);
            out.writeInt(component);
            out.writeDouble(value);
          });
    } catch (WorkerProcess.PeerGoneException e) {
      // The next step finds it, and says why.
    }
  }

  @Override
  public void state(double[] y) {
    asked(
        StepServant.STATE,
        () -> {
          for (int i = 0; i < y.length; i++) {
            y[i] = in.readDouble();
          }
          return y;
        });
  }

  @Override
  public double time() {
    return time;
  }

  @Override
  public Optional<Outcome> ended() {
    return ended.map(WorkerResult::outcome);
  }

  @Override
  public RunReport report() {
    return reports.apply(
        ended.isPresent() ? ended.get() : asked(StepServant.REPORT, () -> WorkerResult.read(in)));
  }

  @Override
  public byte[] save() {
    return asked(StepServant.SAVE, () -> WorkerProcess.readBytes(in));
  }

  private <T> T asked(byte call, WorkerProcess.Reading<T> answer) {
    try {
      return call(() -> out.writeByte(call), answer);
    } catch (WorkerLostException e) {
      throw new IllegalStateException(e.getMessage(), e);
    } catch (IOException e) {
      throw new UncheckedIOException(e); // of a sink, and there are no rows here
    }
  }
}
