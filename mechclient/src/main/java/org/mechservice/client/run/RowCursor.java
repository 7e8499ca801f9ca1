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

/** Pulls the rows of a remote run, in order and each once. */
public final class RowCursor implements AutoCloseable {
  private final RemoteCalls calls;
  private final ResultCursor cursor;
  private final LeaseRenewal.Hold hold;
  private final List<Variable> columns;
  private final int rowsPerBlock;
  private long taken;
  private boolean ended;

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

  boolean ended() {
    return ended;
  }

  /** Returns the number of rows taken. */
  long taken() {
    return taken;
  }

  /** Returns the next row; empty if there is none within the wait. */
  Optional<double[]> next(Duration wait) {
    long deadline = System.nanoTime() + wait.toNanos();
    while (true) {
      long left = Math.max(0, (deadline - System.nanoTime()) / 1_000_000);
      ResultBlock block = pull(1, (int) Math.min(left, MAX_WAIT_MILLIS.value));
      if (block.rowCount > 0) {
        return Optional.of(block.values);
      }
      if (ended || left == 0) {
        return Optional.empty();
      }
    }
  }

  /** Passes on the rows that are available or arrive within the wait. */
  void drainTo(ResultSink sink, Duration wait) throws IOException {
    ResultBlock block = pull(rowsPerBlock, (int) wait.toMillis());
    double[] row = new double[columns.size()];
    for (int i = 0; i < block.rowCount; i++) {
      System.arraycopy(block.values, i * row.length, row, 0, row.length);
      sink.row(row);
    }
  }

  private ResultBlock pull(int maxRows, int waitMillis) {
    ResultBlock block = pulled(maxRows, waitMillis);
    boolean fits =
        block.values.length == (long) block.rowCount * columns.size()
            && (block.rowCount == 0 || block.firstRow == taken);
    if (!fits) {
      throw new ServerFailureException(
          MessageCode.ANSWER_NOT_UNDERSTOOD.code(),
          "the server sent "
              + block.values.length
              + " numbers from row "
              + block.firstRow
              + " where "
              + block.rowCount
              + " rows of "
              + columns.size()
              + " from row "
              + taken
              + " were due",
          "");
    }
    taken += block.rowCount;
    ended = block.endOfData;
    return block;
  }

  /**
   * Pulls a block, over a new connection if the present one is cut. A block that was in transit is
   * lost and the server's cursor is after it, so this method moves the cursor back to the first row
   * not taken.
   */
  private ResultBlock pulled(int maxRows, int waitMillis) {
    try {
      return calls.get(() -> nextBlock(maxRows, waitMillis));
    } catch (ServerLostException cut) {
      return calls.again(
          cut,
          () -> {
            cursor.seekRow(taken);
            return nextBlock(maxRows, waitMillis);
          });
    }
  }

  private ResultBlock nextBlock(int maxRows, int waitMillis) throws UserException {
    ResultBlockHolder holder = new ResultBlockHolder();
    cursor.nextBlock(maxRows, waitMillis, holder);
    return holder.value;
  }

  @Override
  public void close() {
    hold.close();
  }
}
