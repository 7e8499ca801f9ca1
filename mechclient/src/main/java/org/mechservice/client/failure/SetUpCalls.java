package org.mechservice.client.failure;

import java.time.Duration;
import java.util.Objects;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.mechservice.idl.MechSim;
import org.mechservice.solver.catalogue.MessageCode;
import org.omg.CORBA.UserException;

/**
 * Calls that set a model up at the server. A large mechanism takes minutes, so they have a limit of
 * their own, much longer than that of other calls. While one lasts, the server is asked from time
 * to time whether it is still there: a server that is lost is told at once, and not taken for a
 * long set-up.
 *
 * @param calls to the session's host
 * @param session the session, whose calls have the usual limit
 * @param patient the same session, whose calls have the limit of a set-up
 * @param limit that limit
 * @param interval time between two questions to the server
 */
public record SetUpCalls(
    RemoteCalls calls, MechSim session, MechSim patient, Duration limit, Duration interval) {
  /** Default time between two questions. */
  public static final Duration INTERVAL = Duration.ofSeconds(3);

  /** A call of the session. */
  public interface Call<T> {
    T of(MechSim session) throws UserException;
  }

  /**
   * Makes a call.
   *
   * @throws LimitExceededException S-230 if it takes longer than the limit
   * @throws ServiceException if the server refuses it or is lost
   */
  public <T> T get(Call<T> call) {
    FutureTask<T> task = new FutureTask<>(() -> calls.patiently(() -> call.of(patient)));
    Thread thread = new Thread(task, "set-up");
    thread.setDaemon(true);
    thread.start();
    boolean interrupted = false;
    try {
      while (true) {
        try {
          return task.get(interval.toMillis(), TimeUnit.MILLISECONDS);
        } catch (TimeoutException e) {
          calls.get(session::sessionId);
        } catch (ExecutionException e) {
          throw failure(Objects.requireNonNull(e.getCause()));
        } catch (InterruptedException e) {
          interrupted = true; // as calls of CORBA, this one waits on
        }
      }
    } finally {
      if (interrupted) {
        Thread.currentThread().interrupt();
      }
    }
  }

  private RuntimeException failure(Throwable cause) {
    if (cause instanceof ServerLostException lost
        && lost.code().equals(MessageCode.SERVER_TIMEOUT.code())) {
      LimitExceededException tooLong =
          new LimitExceededException(
              MessageCode.SET_UP_TOO_LONG.code(),
              "the server at "
                  + calls.address()
                  + " is there, but has not set the model up within "
                  + limit.toSeconds()
                  + " s; divide the mechanism, or leave out loops that repeat others",
              "setUp",
              limit.toSeconds(),
              limit.toSeconds());
      tooLong.initCause(lost);
      return tooLong;
    }
    if (cause instanceof Error error) {
      throw error;
    }
    return (RuntimeException) cause;
  }
}
