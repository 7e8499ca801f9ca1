package org.mechservice.orb;

import java.lang.reflect.InvocationHandler;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.util.Arrays;
import java.util.UUID;
import java.util.concurrent.RejectedExecutionException;
import org.jspecify.annotations.Nullable;
import org.mechservice.idl.NotAuthorized;
import org.mechservice.idl.ServerFailure;
import org.mechservice.solver.catalogue.MessageCode;
import org.omg.CORBA.CompletionStatus;
import org.omg.CORBA.INTERNAL;
import org.omg.CORBA.NO_PERMISSION;
import org.omg.CORBA.OBJECT_NOT_EXIST;
import org.omg.CORBA.SystemException;
import org.omg.CORBA.UserException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Stands between the ORB and a servant. The ORB would send an unexpected exception of a servant to
 * the caller with class and message; here it becomes a {@link ServerFailure} (or, where the
 * operation knows none, an {@code INTERNAL}) that carries nothing but an incident number, under
 * which the server's log has the rest.
 */
public final class GuardedServant implements InvocationHandler {
  private static final Logger LOG = LoggerFactory.getLogger(GuardedServant.class);
  private static final Object[] NONE = {};

  /** Minor codes of refusals: "MS" in the upper half, the number of the message in the lower. */
  private static final int MINOR_CODES = 0x4D530000;

  /** Runs before every call. */
  public interface Before {
    /**
     * Lets the call through.
     *
     * @throws UserException if the caller may not make it; the operation must know the exception
     */
    void call() throws UserException;
  }

  /** Decides whether a caller may call an operation. */
  public interface Gate {
    /**
     * Lets a call through.
     *
     * @throws UserException if the caller may not make it; the operation must know the exception
     */
    void pass(Method operation) throws UserException;

    /**
     * Hears that a call was refused, here or by the servant itself.
     *
     * @param arguments of the call
     */
    void refused(Method operation, Object[] arguments, NotAuthorized refusal);
  }

  private final Object servant;
  private final Gate gate;

  private GuardedServant(Object servant, Gate gate) {
    this.servant = servant;
    this.gate = gate;
  }

  /**
   * Returns the servant, guarded.
   *
   * @param operations the operations interface of the IDL compiler
   * @param called runs before every call; renews a lease, for instance
   */
  public static <T> T of(Class<T> operations, T servant, Before called) {
    return of(
        operations,
        servant,
        new Gate() {
          @Override
          public void pass(Method operation) throws UserException {
            called.call();
          }

          @Override
          public void refused(Method operation, Object[] arguments, NotAuthorized refusal) {
            // A oneway call: its result is not read.
          }
        });
  }

  /**
   * Returns the servant, guarded.
   *
   * @param operations the operations interface of the IDL compiler
   * @param gate called before every call
   */
  public static <T> T of(Class<T> operations, T servant, Gate gate) {
    return operations.cast(
        Proxy.newProxyInstance(
            operations.getClassLoader(),
            new Class<?>[] {operations},
            new GuardedServant(servant, gate)));
  }

  @Override
  public @Nullable Object invoke(Object proxy, Method method, Object @Nullable [] arguments)
      throws UserException {
    try {
      gate.pass(method);
      return method.invoke(servant, arguments);
    } catch (NotAuthorized refusal) {
      gate.refused(method, arguments == null ? NONE : arguments, refusal);
      throw refused(method, refusal);
    } catch (InvocationTargetException e) {
      Throwable thrown = e.getCause() == null ? e : e.getCause();
      if (thrown instanceof NotAuthorized refusal) {
        gate.refused(method, arguments == null ? NONE : arguments, refusal);
      }
      if (thrown instanceof UserException expected) {
        throw expected;
      }
      if (thrown instanceof SystemException expected) {
        throw expected;
      }
      if (thrown instanceof RejectedExecutionException) {
        // All executors of the service have unbounded queues: they refuse work only when closed.
        throw new OBJECT_NOT_EXIST("the process is closing");
      }
      throw incident(method, thrown);
    } catch (IllegalAccessException e) {
      throw incident(method, e);
    }
  }

  /** Where the contract knows no refusal, the caller learns from the ORB that there is one. */
  private static NotAuthorized refused(Method method, NotAuthorized refusal) {
    if (Arrays.asList(method.getExceptionTypes()).contains(NotAuthorized.class)) {
      return refusal;
    }
    throw new NO_PERMISSION(refusal.code, minor(refusal.code), CompletionStatus.COMPLETED_NO);
  }

  /** The number of a code, marked as ours: the text of a system exception does not travel. */
  private static int minor(String code) {
    return MINOR_CODES | Integer.parseInt(code.substring(code.indexOf('-') + 1));
  }

  /** Returns whether a refusal was made by this class for a reason of the message catalogue. */
  public static boolean isRefusal(NO_PERMISSION refusal, MessageCode reason) {
    return refusal.minor == minor(reason.code());
  }

  private static UserException incident(Method method, Throwable thrown) {
    String incident = record(method.getName(), thrown);
    if (Arrays.asList(method.getExceptionTypes()).contains(ServerFailure.class)) {
      return new ServerFailure(
          MessageCode.INTERNAL_SERVER_ERROR.code(),
          "the server failed unexpectedly; its log has the details under incident " + incident,
          incident);
    }
    throw new INTERNAL(MessageCode.INTERNAL_SERVER_ERROR + " incident " + incident);
  }

  /**
   * Writes something unexpected to the log.
   *
   * @param where the operation it happened in
   * @return the incident number it is logged under
   */
  public static String record(String where, Throwable thrown) {
    String incident = UUID.randomUUID().toString().substring(0, 8);
    LOG.error(MessageCode.INTERNAL_SERVER_ERROR + " incident {} in {}", incident, where, thrown);
    return incident;
  }
}
