package org.mechservice.client.failure;

import java.util.LinkedHashMap;
import java.util.Map;
import org.mechservice.idl.InvalidModel;
import org.mechservice.idl.InvalidOption;
import org.mechservice.idl.InvalidState;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.NotAuthorized;
import org.mechservice.idl.NotAvailable;
import org.mechservice.idl.NotFound;
import org.mechservice.idl.ServerFailure;
import org.mechservice.orb.GuardedServant;
import org.mechservice.orb.connection.LimitedBuffers;
import org.mechservice.solver.catalogue.MessageCode;
import org.omg.CORBA.COMM_FAILURE;
import org.omg.CORBA.NO_MEMORY;
import org.omg.CORBA.NO_PERMISSION;
import org.omg.CORBA.OBJECT_NOT_EXIST;
import org.omg.CORBA.SystemException;
import org.omg.CORBA.TIMEOUT;
import org.omg.CORBA.TRANSIENT;
import org.omg.CORBA.UserException;

/**
 * Calls to one server; errors of CORBA become {@link ServiceException}s.
 *
 * @param address the server's address, as messages name it
 */
public record RemoteCalls(String address) {
  /** Name of the limit of a message, as a {@link LimitExceededException} tells it. */
  public static final String MESSAGE_BYTES = "messageBytes";

  /** Pauses before the retries of a cut connection, ms; after the last, the server is lost. */
  private static final long[] PAUSES_MILLIS = {0, 200, 800};

  /** A call that returns something. */
  public interface Call<T> {
    T run() throws UserException;
  }

  /** A call that returns nothing. */
  public interface Command {
    void run() throws UserException;
  }

  /**
   * Makes a call. A server that is silent for seconds is told by a warning.
   *
   * @throws ServiceException if the server refuses it or is lost
   */
  public <T> T get(Call<T> call) {
    return CallWatch.around(address, () -> patiently(call));
  }

  /**
   * Makes a call that may take long.
   *
   * @throws ServiceException if the server refuses it or is lost
   */
  <T> T patiently(Call<T> call) {
    try {
      return call.run();
    } catch (UserException e) {
      throw refusal(e);
    } catch (SystemException e) {
      throw failure(e);
    }
  }

  /**
   * Makes a call that may be made twice, over a new connection if the present one is cut.
   *
   * @throws ServiceException if the server refuses it or stays lost
   */
  public <T> T read(Call<T> call) {
    try {
      return get(call);
    } catch (ServerLostException cut) {
      return again(cut, call);
    }
  }

  /**
   * Repeats a call that was lost with its connection.
   *
   * @param first exception of the lost call
   * @throws ServiceException if the server refuses this one or stays lost
   */
  public <T> T again(ServerLostException first, Call<T> call) {
    ServerLostException cut = first;
    for (long pause : PAUSES_MILLIS) {
      if (!cut.isConnectionCut()) {
        break;
      }
      try {
        Thread.sleep(pause);
        return get(call);
      } catch (ServerLostException next) {
        cut = next;
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        break;
      }
    }
    throw cut;
  }

  /**
   * Makes a call.
   *
   * @throws ServiceException if the server refuses it or is lost
   */
  public void run(Command command) {
    get(
        () -> {
          command.run();
          return true;
        });
  }

  /** Returns pairs of the contract as a map, in their order. */
  public static Map<String, String> textsOf(NameValue[] pairs) {
    Map<String, String> texts = new LinkedHashMap<>();
    for (NameValue pair : pairs) {
      texts.put(pair.key, pair.text);
    }
    return texts;
  }

  private static ServiceException refusal(UserException said) {
    if (said instanceof InvalidModel e) {
      return new InvalidModelException(e.code, e.text, ModelMessage.listOf(e.diagnostics));
    } else if (said instanceof InvalidOption e) {
      return new InvalidOptionException(e.code, e.text, e.optionName);
    } else if (said instanceof InvalidState e) {
      return new InvalidStateException(e.code, e.text, RunState.of(e.current));
    } else if (said instanceof LimitExceeded e) {
      return new LimitExceededException(e.code, e.text, e.limitName, e.limitValue, e.requested);
    } else if (said instanceof NotAuthorized e) {
      return new NotAuthorizedException(e.code, e.text);
    } else if (said instanceof NotAvailable e) {
      return new NotAvailableException(e.code, e.text);
    } else if (said instanceof NotFound e) {
      return new NotFoundException(e.code, e.text);
    } else if (said instanceof ServerFailure e) {
      return new ServerFailureException(e.code, e.text, e.incidentId);
    }
    throw new IllegalStateException("the contract has no " + said.getClass().getName(), said);
  }

  private ServiceException failure(SystemException said) {
    ServiceException failure;
    if (said instanceof COMM_FAILURE || said instanceof TRANSIENT) {
      failure =
          lost(
              MessageCode.CONNECTION_LOST.code(),
              "the connection to the server at " + address + " is lost");
    } else if (said instanceof TIMEOUT) {
      failure =
          lost(
              MessageCode.SERVER_TIMEOUT.code(),
              "the server at " + address + " did not answer in time");
    } else if (said instanceof OBJECT_NOT_EXIST) {
      failure =
          lost(
              MessageCode.SESSION_UNKNOWN.code(),
              "the server at "
                  + address
                  + " no longer knows this session: its lease ran out or the server was restarted");
    } else if (said instanceof NO_PERMISSION refusal
        && GuardedServant.isRefusal(refusal, MessageCode.NOT_THE_OWNER)) {
      failure =
          new NotAuthorizedException(
              MessageCode.NOT_THE_OWNER.code(),
              "the session or simulation on the server at "
                  + address
                  + " belongs to another user; use the identity that opened it");
    } else if (said instanceof NO_PERMISSION) {
      failure =
          new NotAuthorizedException(
              MessageCode.ACCESS_REFUSED.code(), "the server at " + address + " refuses access");
    } else if (said instanceof NO_MEMORY) {
      int most = LimitedBuffers.MAX_MESSAGE_BYTES;
      failure =
          new LimitExceededException(
              MessageCode.LIMIT_EXCEEDED.code(),
              "what the server at "
                  + address
                  + " was sent or has to answer is larger than a message may be: "
                  + most
                  + " bytes, of which a text takes up to four for each character; ask for less at"
                  + " once, or split the model",
              MESSAGE_BYTES,
              most,
              most + 1L);
    } else {
      failure =
          lost(
              MessageCode.ANSWER_NOT_UNDERSTOOD.code(),
              "what answers at "
                  + address
                  + " does not speak this version of the service ("
                  + said.getClass().getSimpleName()
                  + ")");
    }
    failure.initCause(said);
    return failure;
  }

  private ServerLostException lost(String code, String text) {
    return new ServerLostException(code, text, address);
  }
}
