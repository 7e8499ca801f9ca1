package org.mechservice.admin;

import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.jspecify.annotations.Nullable;
import org.mechservice.admin.AdminFailure.Reason;
import org.mechservice.idl.InvalidOption;
import org.mechservice.idl.MechAdmin;
import org.mechservice.idl.NotAuthorized;
import org.mechservice.idl.NotFound;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.orb.ServiceUnreachableException;
import org.mechservice.orb.tls.TlsIdentity;
import org.mechservice.solver.catalogue.MessageCode;
import org.omg.CORBA.COMM_FAILURE;
import org.omg.CORBA.INTERNAL;
import org.omg.CORBA.NO_PERMISSION;
import org.omg.CORBA.SystemException;
import org.omg.CORBA.TIMEOUT;
import org.omg.CORBA.UserException;

/**
 * Calls to servers, each in a thread of its own, so that a caller can stop waiting at any time. An
 * abandoned call ends by the ORB's own timeout.
 */
final class ServerCalls implements AutoCloseable {
  /** A call to a server. */
  interface Query<T> {
    T query(MechAdmin admin) throws UserException;
  }

  private final ServiceOrb orb;
  private final Duration patience;
  private final Map<String, MechAdmin> connections = new ConcurrentHashMap<>();
  private final ExecutorService threads =
      Executors.newCachedThreadPool(
          task -> {
            Thread asking = new Thread(task, "mechservice-admin");
            asking.setDaemon(true);
            return asking;
          });

  /**
   * @param patience longest wait for an answer
   * @param identity certificate of the caller; empty: connections are not encrypted
   */
  ServerCalls(Duration patience, Optional<TlsIdentity> identity) {
    orb = ServiceOrb.client(identity);
    this.patience = patience;
  }

  /** Begins a call that may be repeated without harm. */
  <T> Pending<T> begin(String address, Query<T> question) {
    return new Pending<>(address, threads.submit(() -> queryAgainIfLost(address, question)));
  }

  /** Begins a call that is made once at most, over a connection that was found to work. */
  <T> Pending<T> beginOnce(String address, Query<T> question) {
    return new Pending<>(address, threads.submit(() -> question.query(connect(address))));
  }

  private <T> T queryAgainIfLost(String address, Query<T> question) throws UserException {
    MechAdmin known = connections.get(address);
    if (known != null) {
      try {
        return question.query(known);
      } catch (COMM_FAILURE e) {
        // Its other end was closed, while idle or because the server was started anew.
        connections.remove(address, known);
      }
    }
    return question.query(connect(address));
  }

  private MechAdmin connect(String address) {
    MechAdmin admin = orb.connectAdmin(address);
    connections.put(address, admin);
    return admin;
  }

  /** A call under way. */
  final class Pending<T> {
    private final String address;
    private final Future<T> answer;
    private final long deadline = System.nanoTime() + patience.toNanos();

    private Pending(String address, Future<T> answer) {
      this.address = address;
      this.answer = answer;
    }

    /**
     * Waits for the answer, no longer than the patience from the beginning of the call on.
     *
     * @throws AdminFailure if there is none, or it is a refusal
     */
    T await() {
      try {
        return answer.get(Math.max(0, deadline - System.nanoTime()), TimeUnit.NANOSECONDS);
      } catch (TimeoutException e) {
        throw late(address);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        throw late(address);
      } catch (ExecutionException e) {
        throw failure(address, e.getCause());
      }
    }
  }

  private static AdminFailure late(String address) {
    return new AdminFailure(
        Reason.NO_ANSWER,
        MessageCode.SERVER_TIMEOUT + " the server at " + address + " did not answer in time");
  }

  private static AdminFailure failure(String address, @Nullable Throwable thrown) {
    if (thrown instanceof NotAuthorized refusal) {
      return new AdminFailure(Reason.NOT_ALLOWED, refusal.code + " " + refusal.text);
    } else if (thrown instanceof NotFound refusal) {
      return new AdminFailure(Reason.NOT_FOUND, refusal.code + " " + refusal.text);
    } else if (thrown instanceof InvalidOption refusal) {
      return new AdminFailure(Reason.NOT_USABLE, refusal.code + " " + refusal.text);
    } else if (thrown instanceof ServiceUnreachableException e) {
      return new AdminFailure(Reason.NO_ANSWER, String.valueOf(e.getMessage()));
    } else if (thrown instanceof IllegalArgumentException e) {
      return new AdminFailure(Reason.NOT_USABLE, String.valueOf(e.getMessage()));
    } else if (thrown instanceof SystemException e) {
      return ofTransport(address, e);
    }
    throw new IllegalStateException("asking " + address + " failed", thrown);
  }

  private static AdminFailure ofTransport(String address, SystemException failure) {
    if (failure instanceof TIMEOUT) {
      return late(address);
    } else if (failure instanceof NO_PERMISSION) {
      return new AdminFailure(
          Reason.NOT_ALLOWED,
          MessageCode.ACCESS_REFUSED + " the server at " + address + " refuses access");
    } else if (failure instanceof INTERNAL
        && String.valueOf(failure.getMessage())
            .contains(MessageCode.INTERNAL_SERVER_ERROR.code())) {
      return new AdminFailure(
          Reason.NO_ANSWER,
          MessageCode.INTERNAL_SERVER_ERROR
              + " the server at "
              + address
              + " failed unexpectedly; its log says why");
    }
    return new AdminFailure(
        Reason.NO_ANSWER,
        MessageCode.CONNECTION_LOST + " the connection to the server at " + address + " is lost");
  }

  @Override
  public void close() {
    threads.shutdownNow();
    orb.close();
  }
}
