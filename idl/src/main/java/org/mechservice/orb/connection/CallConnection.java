package org.mechservice.orb.connection;

import org.jacorb.orb.ORB;
import org.jacorb.orb.giop.ClientConnection;
import org.jacorb.orb.giop.GIOPConnection;
import org.jacorb.orb.giop.MessageOutputStream;
import org.jacorb.orb.giop.ReplyPlaceholder;
import org.omg.ETF.Profile;

/**
 * A connection calls go out over, which forgets no call when it is closed.
 *
 * <p>A connection that is closing first tells those who wait for a reply and then closes. Whoever
 * sends in between is not told; his bytes may still leave, or open the connection anew with nobody
 * to read from it, and he would wait until his patience ends. So a sender looks afterwards whether
 * the connection is closed.
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
      close(); // which tells all who wait
    }
  }

  /** Returns whether the connection is closed; one that is just closing is waited for. */
  private boolean closedAfterAll() {
    getGIOPConnection().getTransport(); // comes back when nobody is closing it
    return isClosed();
  }
}
