package org.mechservice.client.run;

import java.io.IOException;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.mechservice.client.failure.RemoteCalls;
import org.mechservice.client.failure.ServerFailureException;
import org.mechservice.client.failure.ServerLostException;
import org.mechservice.idl.Channel;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.MAX_BLOCK_DOUBLES;
import org.mechservice.idl.MAX_WAIT_MILLIS;
import org.mechservice.idl.ResultBlock;
import org.mechservice.idl.ResultBlockHolder;
import org.mechservice.idl.ResultCursor;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.catalogue.MessageCode;
import org.omg.CORBA.UserException;

/** Pulls the rows of a remote run in blocks and passes each on once, in order. */
public final class RowCursor implements AutoCloseable {
  private final RemoteCalls calls;
  private final ResultCursor cursor;
  private final LeaseRenewal.Hold hold;
  private final List<Variable> columns;
  private final int rowsPerBlock;
  private long pulled;
  private long taken;
  private boolean lastPulled;

  /** The block pulled last; the rows in it from row {@link #taken} on wait to be passed on. */
  private double[] block = {};

  private RowCursor(
      RemoteCalls calls, ResultCursor cursor, LeaseRenewal.Hold hold, Channel[] channels) {
    this.calls = calls;
    this.cursor = cursor;
    this.hold = hold;
    columns =
        Arrays.stream(channels).map(channel -> new Variable(channel.name, channel.unit)).toList();
    rowsPerBlock = Math.max(1, MAX_BLOCK_DOUBLES.value / Math.max(1, columns.size()));
  }

  /** Opens a cursor over all columns of the simulation. */
  static RowCursor open(RemoteCalls calls, LeaseRenewal leases, IMechSimRemote simulation) {
    ResultCursor cursor = calls.get(() -> simulation.openResults(new String[0]));
    return over(calls, leases, cursor, calls.get(cursor::channels));
  }

  /** Wraps an open cursor with its columns. */
  public static RowCursor over(
      RemoteCalls calls, LeaseRenewal leases, ResultCursor cursor, Channel[] channels) {
    return new RowCursor(calls, cursor, leases.hold(cursor), channels);
  }

  List<Variable> columns() {
    return columns;
  }

  /** Returns whether the last row was passed on. */
  boolean ended() {
    return lastPulled && taken == pulled;
  }

  /** Returns the number of rows passed on. */
  long taken() {
    return taken;
  }

  /** Returns the next row; empty if there is none within the wait. */
  Optional<double[]> next(Duration wait) {
    long deadline = System.nanoTime() + wait.toNanos();
    while (taken == pulled) {
      long left = Math.max(0, (deadline - System.nanoTime()) / 1_000_000);
      pull((int) Math.min(left, MAX_WAIT_MILLIS.value));
      if (taken == pulled && (lastPulled || left == 0)) {
        return Optional.empty();
      }
    }
    double[] row = new double[columns.size()];
    take(row);
    return Optional.of(row);
  }

  /** Passes on the rows that are available or arrive within the wait. */
  void drainTo(ResultSink sink, Duration wait) throws IOException {
    if (taken == pulled) {
      pull((int) wait.toMillis());
    }
    double[] row = new double[columns.size()];
    while (taken < pulled) {
      take(row);
      sink.row(row);
    }
  }

  private void take(double[] row) {
    int waiting = (int) (pulled - taken);
    System.arraycopy(block, block.length - waiting * row.length, row, 0, row.length);
    taken++;
  }

  private void pull(int waitMillis) {
    ResultBlock next = pulled(waitMillis);
    boolean fits =
        next.values.length == (long) next.rowCount * columns.size()
            && (next.rowCount == 0 || next.firstRow == pulled);
    if (!fits) {
      throw new ServerFailureException(
          MessageCode.ANSWER_NOT_UNDERSTOOD.code(),
          "the server sent "
              + next.values.length
              + " numbers from row "
              + next.firstRow
              + " where "
              + next.rowCount
              + " rows of "
              + columns.size()
              + " from row "
              + pulled
              + " were due",
          "");
    }
    pulled += next.rowCount;
    lastPulled = next.endOfData;
    block = next.values;
  }

  /**
   * Pulls a block, over a new connection if the present one is cut. A block that was in transit is
   * lost and the server's cursor is after it, so this method moves the cursor back to the first row
   * not received.
   */
  private ResultBlock pulled(int waitMillis) {
    try {
      return calls.get(() -> nextBlock(waitMillis));
    } catch (ServerLostException cut) {
      return calls.again(
          cut,
          () -> {
            cursor.seekRow(pulled);
            return nextBlock(waitMillis);
          });
    }
  }

  private ResultBlock nextBlock(int waitMillis) throws UserException {
    ResultBlockHolder holder = new ResultBlockHolder();
    cursor.nextBlock(rowsPerBlock, waitMillis, holder);
    return holder.value;
  }

  @Override
  public void close() {
    hold.close();
  }
}
