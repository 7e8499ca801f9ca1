package org.mechservice.sim.service;

import java.util.HashMap;
import java.util.Map;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.NotFound;
import org.mechservice.idl.ResultCursor;
import org.mechservice.idl.ResultCursorHelper;
import org.mechservice.idl.ResultCursorOperations;
import org.mechservice.idl.ResultCursorPOATie;
import org.mechservice.orb.ActiveObject;
import org.mechservice.orb.GuardedServant;
import org.omg.CORBA.OBJECT_NOT_EXIST;

/** The open cursors over the rows of one run. */
final class Cursors {
  private final Session session;
  private final ResultSpool rows;
  private final RunColumns columns;
  private final Map<ResultCursorServant, ActiveObject> open = new HashMap<>();
  private boolean closed;

  Cursors(Session session, ResultSpool rows, RunColumns columns) {
    this.session = session;
    this.rows = rows;
    this.columns = columns;
  }

  /**
   * Opens a cursor.
   *
   * @param channelNames columns or column groups wanted; empty: all
   */
  ResultCursor open(String[] channelNames) throws NotFound, LimitExceeded {
    return open(ColumnSelection.of(channelNames, columns));
  }

  /** Opens a cursor over all columns. */
  ResultCursor openAll() throws LimitExceeded {
    return open(ColumnSelection.ofAll(columns));
  }

  private ResultCursor open(ColumnSelection selection) throws LimitExceeded {
    synchronized (open) {
      if (closed) {
        throw new OBJECT_NOT_EXIST("the simulation was destroyed");
      }
      session.limits().requireBelow(HostLimit.CURSORS, open.size());
      ResultCursorServant cursor =
          new ResultCursorServant(
              rows,
              selection,
              () -> session.limits().leaseSeconds(),
              session.host().orb().replyRoom(),
              this::close);
      ActiveObject object =
          session.activate(
              new ResultCursorPOATie(
                  GuardedServant.of(ResultCursorOperations.class, cursor, session::renew)));
      open.put(cursor, object);
      return ResultCursorHelper.unchecked_narrow(object.reference());
    }
  }

  private void close(ResultCursorServant cursor) {
    synchronized (open) {
      ActiveObject object = open.remove(cursor);
      if (object != null) {
        object.close();
      }
    }
  }

  /** Ends all cursors; there will be no new ones. */
  void close() {
    synchronized (open) {
      closed = true;
      open.values().forEach(ActiveObject::close);
      open.clear();
    }
  }
}
