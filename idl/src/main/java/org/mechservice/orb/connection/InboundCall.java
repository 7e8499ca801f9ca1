package org.mechservice.orb.connection;

import java.net.Socket;
import java.util.Optional;
import org.mechservice.orb.connection.InboundSocketFactory.Accepted;

/**
 * The call that this thread executes, as seen by the connection over which it came. The ORB runs
 * interceptors and servant in one thread.
 */
public final class InboundCall {
  private static final ThreadLocal<Optional<InboundCall>> CURRENT =
      ThreadLocal.withInitial(Optional::empty);

  private final Accepted connection;
  private final long refusedBytes;

  private InboundCall(Accepted connection, long refusedBytes) {
    this.connection = connection;
    this.refusedBytes = refusedBytes;
  }

  /**
   * Begins a call; {@link #ends} must follow.
   *
   * @param opened the connection, as the port has accepted it; a connection opened by this process
   *     is not watched
   * @param request the id of the request
   */
  public static void begins(Socket opened, int request) {
    if (opened instanceof Accepted accepted) {
      accepted.callBegins();
      CURRENT.set(Optional.of(new InboundCall(accepted, accepted.takeRefused(request))));
    }
  }

  /** Ends the call. */
  public static void ends() {
    CURRENT.get().ifPresent(call -> call.connection.callEnds());
    CURRENT.remove();
  }

  /**
   * Binds this thread to its caller, for work that is of use to him alone: when his connection ends
   * before the bond is released, the thread is interrupted. Afterwards it is not, since it serves
   * others next. A call within this process has no connection that could end.
   */
  public static Bond boundToCaller() {
    Optional<Accepted> connection = CURRENT.get().map(call -> call.connection);
    Thread caller = Thread.currentThread();
    connection.ifPresent(opened -> opened.interruptsAtItsEnd(caller));
    return () -> connection.ifPresent(opened -> opened.leavesAlone(caller));
  }

  /** What ends the work of a thread with its caller. */
  @FunctionalInterface
  public interface Bond {
    /** Leaves the thread alone from now on. */
    void release();
  }

  /** Returns the size of a request whose arguments are missing because it is too large, or 0. */
  public static long refusedBytes() {
    return CURRENT.get().map(call -> call.refusedBytes).orElse(0L);
  }

  /**
   * Records whether the caller has an object here that lives as long as it is called: its
   * connection is then kept while others are closed to make room.
   */
  public static void leased(boolean leased) {
    CURRENT.get().ifPresent(call -> call.connection.setLeased(leased));
  }
}
