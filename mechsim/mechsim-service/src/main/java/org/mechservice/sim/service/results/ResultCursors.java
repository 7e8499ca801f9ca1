package org.mechservice.sim.service.results;

import java.io.IOException;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.IntSupplier;
import org.mechservice.idl.Channel;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.MAX_BLOCK_DOUBLES;
import org.mechservice.idl.MAX_WAIT_MILLIS;
import org.mechservice.idl.NotFound;
import org.mechservice.idl.ResultBlock;
import org.mechservice.idl.ResultBlockHolder;
import org.mechservice.idl.ResultCursor;
import org.mechservice.idl.ResultCursorHelper;
import org.mechservice.idl.ResultCursorOperations;
import org.mechservice.idl.ResultCursorPOATie;
import org.mechservice.orb.ActiveObject;
import org.mechservice.orb.GuardedServant;
import org.mechservice.orb.connection.ReplyMemory;
import org.mechservice.sim.service.contract.ContractErrors;
import org.mechservice.sim.service.contract.ContractTypes;
import org.mechservice.sim.service.contract.OwnerGate;
import org.mechservice.sim.service.limits.HostLimit;
import org.mechservice.sim.service.limits.HostLimits;
import org.omg.CORBA.OBJECT_NOT_EXIST;
import org.omg.CORBA.TRANSIENT;
import org.omg.PortableServer.Servant;

/** The open cursors over the rows of one run. */
public final class ResultCursors {
  /** The session that the cursors belong to. */
  public interface Owner {
    HostLimits limits();

    /** Returns the memory for blocks. */
    ReplyMemory replyRoom();

    /** Makes a cursor callable until it is closed or the session ends. */
    ActiveObject activate(Servant servant);

    /** Returns what decides who may call its objects. */
    OwnerGate gate();
  }

  private final Owner owner;
  private final ResultSpool rows;
  private final RunColumns columns;
  private final Map<Cursor, ActiveObject> open = new HashMap<>();
  private boolean closed;

  public ResultCursors(Owner owner, ResultSpool rows, RunColumns columns) {
    this.owner = owner;
    this.rows = rows;
    this.columns = columns;
  }

  /**
   * Opens a cursor.
   *
   * @param channelNames columns or column groups wanted; empty: all
   */
  public ResultCursor open(String[] channelNames) throws NotFound, LimitExceeded {
    return open(columns.select(channelNames));
  }

  /** Opens a cursor over all columns. */
  public ResultCursor openAll() throws LimitExceeded {
    return open(columns.selectAll());
  }

  private ResultCursor open(RunColumns.Selection selection) throws LimitExceeded {
    synchronized (open) {
      if (closed) {
        throw new OBJECT_NOT_EXIST("the simulation was destroyed");
      }
      owner.limits().requireBelow(HostLimit.CURSORS, open.size());
      Cursor cursor =
          new Cursor(
              rows, selection, () -> owner.limits().leaseSeconds(), owner.replyRoom(), this::close);
      ActiveObject object =
          owner.activate(
              new ResultCursorPOATie(
                  GuardedServant.of(ResultCursorOperations.class, cursor, owner.gate())));
      open.put(cursor, object);
      return ResultCursorHelper.unchecked_narrow(object.reference());
    }
  }

  private void close(Cursor cursor) {
    synchronized (open) {
      ActiveObject object = open.remove(cursor);
      if (object != null) {
        object.close();
      }
    }
  }

  /** Ends all cursors; there will be no new ones. */
  public void close() {
    synchronized (open) {
      closed = true;
      open.values().forEach(ActiveObject::close);
      open.clear();
    }
  }

  /** Returns the rows of a run in order, as its client reads them. */
  private static final class Cursor implements ResultCursorOperations {
    /** Least size of a block when memory is short, bytes. */
    private static final int LEAST_BYTES = 1 << 13;

    private final ResultSpool spool;
    private final RunColumns.Selection selection;
    private final IntSupplier leaseSeconds;
    private final ReplyMemory room;
    private final Consumer<Cursor> destroyed;
    private long nextRow;

    /**
     * @param leaseSeconds the seconds a renewal grants
     * @param room the memory for blocks
     * @param destroyed called when the client ends the cursor
     */
    Cursor(
        ResultSpool spool,
        RunColumns.Selection selection,
        IntSupplier leaseSeconds,
        ReplyMemory room,
        Consumer<Cursor> destroyed) {
      this.spool = spool;
      this.selection = selection;
      this.leaseSeconds = leaseSeconds;
      this.room = room;
      this.destroyed = destroyed;
    }

    @Override
    public Channel[] channels() {
      return ContractTypes.channels(selection.columns());
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

    /** Returns the number of rows that fit the memory other replies leave; at least one. */
    private int affordable(int most) {
      long rowBytes = (long) Double.BYTES * Math.max(selection.count(), spool.columns());
      long present = Math.min(most, Math.max(0, spool.rows() - nextRow));
      long granted = room.share(present * rowBytes, Math.max(rowBytes, LEAST_BYTES));
      return (int) Math.min(most, granted / rowBytes);
    }

    private int rowsPerBlock() throws LimitExceeded {
      int widest = Math.max(selection.count(), spool.columns());
      if (selection.count() > MAX_BLOCK_DOUBLES.value) {
        throw ContractErrors.limit(
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
        throw ContractErrors.notFound("there is no row " + row + " yet; there are " + rows);
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
}
