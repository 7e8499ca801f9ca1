package org.mechservice.guard.worker;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.StreamCorruptedException;
import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.text.WellFormedText;

/** The rows that come from a worker, which may send anything. */
final class WorkerRows {
  private static final int MOST_COLUMNS = 1_000_000;

  /** Characters of their names and units: as many as those of 50 000 bodies with all columns. */
  private static final long MOST_CHARACTERS = 50_000_000;

  private final DataInputStream in;
  private final ResultSink sink;
  private double[] row = new double[0];

  WorkerRows(DataInputStream in, ResultSink sink) {
    this.in = in;
    this.sink = sink;
  }

  /** Takes the columns, once. */
  void begin() throws IOException {
    int count = WorkerProcess.receive(in::readInt);
    if (count < 1 || count > MOST_COLUMNS || row.length > 0) {
      throw new StreamCorruptedException(count + " columns");
    }
    List<Variable> columns = new ArrayList<>();
    long characters = 0;
    for (int i = 0; i < count; i++) {
      String name = WorkerProcess.receive(() -> WellFormedText.of(in.readUTF()));
      String unit = WorkerProcess.receive(() -> WellFormedText.of(in.readUTF()));
      characters += name.length() + unit.length();
      if (characters > MOST_CHARACTERS) {
        throw new StreamCorruptedException(
            "columns with more than " + MOST_CHARACTERS + " characters");
      }
      columns.add(new Variable(name, unit));
    }
    row = new double[count];
    sink.begin(columns);
  }

  /** Takes a row. */
  void next() throws IOException {
    sink.row(WorkerProcess.receive(this::read));
  }

  private double[] read() throws IOException {
    if (row.length == 0) {
      throw new StreamCorruptedException("a row before the columns");
    }
    for (int i = 0; i < row.length; i++) {
      row[i] = in.readDouble();
    }
    return row;
  }
}
