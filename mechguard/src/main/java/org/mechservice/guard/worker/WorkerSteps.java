package org.mechservice.guard.worker;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.StreamCorruptedException;
import java.lang.ref.Cleaner;
import java.util.Optional;
import java.util.function.Function;
import org.mechservice.guard.Confinement;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.StepwiseRun;

/**
 * A run that is stepped from outside, in a worker: numbers and texts come back from there, and no
 * class of the model is loaded here. Its process ends with this program, or when the run can no
 * longer be reached.
 */
public final class WorkerSteps implements StepwiseRun {
  private static final Cleaner UNREACHED = Cleaner.create();

  private final WorkerProcess.Talk talk;
  private final DataInputStream in;
  private final DataOutputStream out;
  private final WorkerRows rows;
  private final Function<WorkerResult, RunReport> reports;
  private final Cleaner.Cleanable process;
  private double time;
  private Optional<WorkerResult> ended = Optional.empty();

  /**
   * @param talk with a worker that has its order
   * @param sink takes the rows
   * @param reports makes a report of what the worker tells
   */
  WorkerSteps(WorkerProcess.Talk talk, ResultSink sink, Function<WorkerResult, RunReport> reports) {
    this.talk = talk;
    in = talk.in();
    out = talk.out();
    rows = new WorkerRows(in, sink);
    this.reports = reports;
    Process started = talk.process();
    process = UNREACHED.register(this, () -> Confinement.end(started));
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
    if (ended.isPresent()) {
      throw new IllegalStateException("the run has ended");
    }
    advance(() -> out.writeByte(StepServant.STEP));
    return ended.isEmpty();
  }

  /** Makes a call that takes the run on; one whose process is lost has failed. */
  private void advance(WorkerProcess.Writing call) throws IOException {
    try {
      answerOf(call);
      time = WorkerProcess.receive(in::readDouble);
      if (WorkerProcess.receive(in::readBoolean)) {
        ended = Optional.of(WorkerProcess.receive(() -> WorkerResult.read(in)));
      }
    } catch (WorkerProcess.PeerGoneException | StreamCorruptedException e) {
      loseBy(talk.lost(e));
    } catch (WorkerLostException e) {
      loseBy(e);
    }
  }

  private void loseBy(WorkerLostException why) {
    String cause = String.valueOf(why.getMessage());
    Failure failure = new Failure(why.code(), cause, time, 0, 0, "", why.advice());
    ended = Optional.of(WorkerResult.lost(failure));
    process.clean();
  }

  /** Makes a call, takes the rows that come of it, and returns when the answer follows. */
  void answerOf(WorkerProcess.Writing call) throws IOException {
    WorkerProcess.send(out, call);
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
      answerOf(() -> out.writeByte(call));
      return WorkerProcess.receive(answer);
    } catch (WorkerLostException e) {
      throw new IllegalStateException(e.getMessage(), e);
    } catch (IOException e) {
      throw new IllegalStateException(talk.lost(e).getMessage(), e);
    }
  }
}
