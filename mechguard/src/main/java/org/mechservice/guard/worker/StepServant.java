package org.mechservice.guard.worker;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.StreamCorruptedException;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.StepwiseRun;

/** The worker's end of {@link WorkerSteps}: answers each call with what the run says to it. */
final class StepServant {
  // Calls
  static final byte BEGIN = 'b';
  static final byte RESTORE = 'r';
  static final byte SET = 's';
  static final byte SETTLE = 'e';
  static final byte STEP = 'p';
  static final byte STATE = 'y';
  static final byte REPORT = 'q';
  static final byte SAVE = 'v';
  // Answers, after the rows of a call
  static final byte DONE = 'd';
  static final byte ILLEGAL = 'i';

  private final DataInputStream in;
  private final DataOutputStream out;
  private final StepwiseRun run;
  private final double[] state;

  /**
   * @param run writes its rows to the same stream
   */
  StepServant(DataInputStream in, DataOutputStream out, StepwiseRun run, int stateLength) {
    this.in = in;
    this.out = out;
    this.run = run;
    state = new double[stateLength];
  }

  /** Answers until the program ends its stream. */
  void serve() throws IOException {
    for (int call = in.read(); call >= 0; call = in.read()) {
      if (call == SET) {
        run.set(in.readInt(), in.readDouble());
      } else {
        answer((byte) call);
        out.flush();
      }
    }
  }

  private void answer(byte call) throws IOException {
    try {
      switch (call) {
        case BEGIN -> {
          run.begin();
          done();
        }
        case RESTORE -> {
          run.restore(WorkerProcess.readBytes(in));
          done();
        }
        case SETTLE -> {
          run.settle();
          done();
        }
        case STEP -> {
          run.step();
          done();
        }
        case STATE -> {
          run.state(state);
          out.writeByte(DONE);
          for (double component : state) {
            out.writeDouble(component);
          }
        }
        case SAVE -> {
          byte[] saved = run.save();
          out.writeByte(DONE);
          out.writeInt(saved.length);
          out.write(saved);
        }
        case REPORT -> {
          out.writeByte(DONE);
          result(run.report().outcome()).write(out);
        }
        default -> throw new StreamCorruptedException("a call of the kind " + call);
      }
    } catch (IllegalArgumentException e) {
      out.writeByte(WorkerMain.REFUSED);
      out.writeUTF(WorkerMain.clipped(String.valueOf(e.getMessage())));
    } catch (IllegalStateException e) {
      out.writeByte(ILLEGAL);
      out.writeUTF(WorkerMain.clipped(String.valueOf(e.getMessage())));
    }
  }

  /** Answers with the time reached, and with the result if the run has ended there. */
  private void done() throws IOException {
    out.writeByte(DONE);
    out.writeDouble(run.time());
    out.writeBoolean(run.ended().isPresent());
    if (run.ended().isPresent()) {
      result(run.ended().get()).write(out);
    }
  }

  private WorkerResult result(Outcome outcome) {
    RunReport report = run.report();
    return new WorkerResult(report.asMap(), outcome);
  }
}
