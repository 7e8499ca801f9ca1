package org.mechservice.orb.connection;

import org.jacorb.orb.ORB;
import org.jacorb.orb.giop.ClientConnection;
import org.jacorb.orb.giop.GIOPConnection;
import org.jacorb.orb.giop.MessageOutputStream;
import org.jacorb.orb.giop.ReplyPlaceholder;
import org.omg.ETF.Profile;

/**
 * A connection for calls that ends each pending call when it is closed.
 *
 * <p>A closing connection first wakes the threads that wait for a reply and then closes. A call
 * sent between the two is not woken: its bytes may still leave, or open the connection anew without
 * a reader, and the call would wait until its timeout. So each sender checks afterwards whether the
 * connection is closed.
 */
final class CallConnection extends ClientConnection {
  /**
   * @param clientInitiated false: the peer opened it, and is called back over it
   */
  CallConnection(
      GIOPConnection connection,
      ORB orb,
      ConnectionTable table,
      Profile profile,
      boolean clientInitiated) {
    super(connection, orb, table, profile, clientInitiated);
  }

  @Override
  public void sendRequest(
      MessageOutputStream message,
      ReplyPlaceholder reply,
      int requestId,
      boolean responseExpected) {
    super.sendRequest(message, reply, requestId, responseExpected);
    if (closedAfterAll()) {
      close(); // wakes all threads that wait
    }
  }

  /** Returns whether the connection is closed; one that is just closing is waited for. */
  private boolean closedAfterAll() {
    getGIOPConnection().getTransport(); // returns when no thread is closing it
    return isClosed();
  }
}
