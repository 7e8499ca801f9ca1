package org.mechservice.sim.service;

import java.io.IOException;
import java.util.function.Consumer;
import java.util.function.IntSupplier;
import org.mechservice.idl.Channel;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.MAX_BLOCK_DOUBLES;
import org.mechservice.idl.MAX_WAIT_MILLIS;
import org.mechservice.idl.NotFound;
import org.mechservice.idl.ResultBlock;
import org.mechservice.idl.ResultBlockHolder;
import org.mechservice.idl.ResultCursorOperations;
import org.mechservice.orb.ReplyRoom;
import org.omg.CORBA.OBJECT_NOT_EXIST;
import org.omg.CORBA.TRANSIENT;

/** Hands out the rows of a run in order, at the pace of whoever asks. */
final class ResultCursorServant implements ResultCursorOperations {
  /** Blocks are no smaller for want of memory. */
  private static final int LEAST_BYTES = 1 << 13;

  private final ResultSpool spool;
  private final ColumnSelection selection;
  private final IntSupplier leaseSeconds;
  private final ReplyRoom room;
  private final Consumer<ResultCursorServant> destroyed;
  private long nextRow;

  /**
   * @param leaseSeconds the seconds a renewal grants
   * @param room the memory for blocks
   * @param destroyed told when the client ends the cursor
   */
  ResultCursorServant(
      ResultSpool spool,
      ColumnSelection selection,
      IntSupplier leaseSeconds,
      ReplyRoom room,
      Consumer<ResultCursorServant> destroyed) {
    this.spool = spool;
    this.selection = selection;
    this.leaseSeconds = leaseSeconds;
    this.room = room;
    this.destroyed = destroyed;
  }

  @Override
  public Channel[] channels() {
    return Wire.channels(selection.columns());
  }

  /** {@code maxRows} 0 means as many as fit into a block. */
  @Override
  public synchronized boolean nextBlock(int maxRows, int waitMillis, ResultBlockHolder block)
      throws LimitExceeded {
    int fitting = rowsPerBlock();
    int most = maxRows == 0 ? fitting : (int) Math.min(Integer.toUnsignedLong(maxRows), fitting);
    try {
      spool.await(nextRow, Math.min(Integer.toUnsignedLong(waitMillis), MAX_WAIT_MILLIS.value));
      double[] rows = spool.read(nextRow, affordable(most));
      int count = rows.length / spool.columns();
      long first = nextRow;
      nextRow += count;
      block.value =
          new ResultBlock(
              first,
              count,
              selection.count(),
              selection.pick(rows, spool.columns()),
              spool.endsAt(nextRow));
      return count > 0;
    } catch (IOException e) {
      throw new OBJECT_NOT_EXIST("the simulation was destroyed");
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new TRANSIENT("the server is closing");
    }
  }

  /** Returns how many rows there is memory for while others have not taken theirs; at least one. */
  private int affordable(int most) {
    long rowBytes = (long) Double.BYTES * Math.max(selection.count(), spool.columns());
    long present = Math.min(most, Math.max(0, spool.rows() - nextRow));
    long granted = room.share(present * rowBytes, Math.max(rowBytes, LEAST_BYTES));
    return (int) Math.min(most, granted / rowBytes);
  }

  private int rowsPerBlock() throws LimitExceeded {
    int widest = Math.max(selection.count(), spool.columns());
    if (selection.count() > MAX_BLOCK_DOUBLES.value) {
      throw Refusal.limit(
          "columns",
          MAX_BLOCK_DOUBLES.value,
          selection.count(),
          "a row has more columns than a block holds; open a cursor over some of them");
    }
    return Math.max(1, MAX_BLOCK_DOUBLES.value / widest);
  }

  @Override
  public synchronized void seekRow(long row) throws NotFound {
    long rows = spool.rows();
    if (row < 0 || row > rows) {
      throw Refusal.notFound("there is no row " + row + " yet; there are " + rows);
    }
    nextRow = row;
  }

  @Override
  public int renewLease() {
    return leaseSeconds.getAsInt();
  }

  @Override
  public void destroy() {
    destroyed.accept(this);
  }
}
