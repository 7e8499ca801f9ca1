package org.mechservice.guard.worker;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.StreamCorruptedException;
import java.util.LinkedHashMap;
import java.util.Map;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunNotes;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.text.WellFormedText;

/**
 * The result of a run in a worker.
 *
 * @param report the run report's entries: {@link String}, {@link Long}, {@link Double}
 * @param outcome how it ended
 */
public record WorkerResult(Map<String, Object> report, Outcome outcome) {
  private static final int MOST_ENTRIES = 1000;

  /** Returns the result with one more note in its report. */
  public WorkerResult with(RunNotes.Note note) {
    Map<String, Object> noted = new LinkedHashMap<>(report);
    noted.merge("notes", note.message(), (before, more) -> before + "\n" + more);
    return new WorkerResult(noted, outcome);
  }

  /** Returns the result of a run whose worker has been lost. */
  public static WorkerResult lost(Failure failure) {
    Map<String, Object> report = new LinkedHashMap<>();
    report.put("outcome", "failed");
    report.put("failure", failure.message());
    return new WorkerResult(report, new Outcome.Failed(failure));
  }

  /** Returns the result of a run that has been stopped together with its worker. */
  static WorkerResult stopped() {
    return new WorkerResult(Map.of("outcome", "stopped"), new Outcome.Stopped());
  }

  void write(DataOutputStream out) throws IOException {
    out.writeInt(report.size());
    for (Map.Entry<String, Object> entry : report.entrySet()) {
      out.writeUTF(entry.getKey());
      if (entry.getValue() instanceof Double number) {
        out.writeByte('d');
        out.writeDouble(number);
      } else if (entry.getValue() instanceof Long number) {
        out.writeByte('l');
        out.writeLong(number);
      } else {
        out.writeByte('s');
        out.writeUTF(entry.getValue().toString());
      }
    }
    writeOutcome(out);
  }

  private void writeOutcome(DataOutputStream out) throws IOException {
    if (outcome instanceof Outcome.Failed failed) {
      Failure why = failed.failure();
      out.writeByte('f');
      out.writeUTF(why.code().code());
      out.writeUTF(WorkerMain.clipped(why.cause()));
      out.writeDouble(why.time());
      out.writeDouble(why.stepSize());
      out.writeInt(why.order());
      out.writeUTF(why.part());
      out.writeUTF(why.advice());
    } else {
      out.writeByte(outcome instanceof Outcome.Stopped ? 's' : 'c');
    }
  }

  static WorkerResult read(DataInputStream in) throws IOException {
    int entries = in.readInt();
    if (entries < 0 || entries > MOST_ENTRIES) {
      throw new StreamCorruptedException("a report of " + entries + " entries");
    }
    Map<String, Object> report = new LinkedHashMap<>();
    for (int left = entries; left > 0; left--) {
      String name = WellFormedText.of(in.readUTF());
      report.put(name, readValue(in));
    }
    return new WorkerResult(report, readOutcome(in));
  }

  private static Object readValue(DataInputStream in) throws IOException {
    return switch (in.readByte()) {
      case 'd' -> in.readDouble();
      case 'l' -> in.readLong();
      default -> WellFormedText.of(in.readUTF());
    };
  }

  private static MessageCode readCode(DataInputStream in) throws IOException {
    String code = WellFormedText.of(in.readUTF());
    return MessageCode.find(code)
        .orElseThrow(() -> new StreamCorruptedException("there is no message code " + code));
  }

  private static Outcome readOutcome(DataInputStream in) throws IOException {
    return switch (in.readByte()) {
      case 'f' ->
          new Outcome.Failed(
              new Failure(
                  readCode(in),
                  WellFormedText.of(in.readUTF()),
                  in.readDouble(),
                  in.readDouble(),
                  in.readInt(),
                  WellFormedText.of(in.readUTF()),
                  WellFormedText.of(in.readUTF())));
      case 's' -> new Outcome.Stopped();
      default -> new Outcome.Completed();
    };
  }
}
