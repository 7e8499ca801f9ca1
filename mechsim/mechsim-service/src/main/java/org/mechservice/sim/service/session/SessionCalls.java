package org.mechservice.sim.service.session;

import java.lang.reflect.InvocationHandler;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.util.HashSet;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletionException;
import org.jspecify.annotations.Nullable;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.MechSimOperations;
import org.mechservice.sim.service.contract.ContractErrors;
import org.mechservice.sim.service.limits.SetUpPlaces;
import org.omg.CORBA.IMP_LIMIT;
import org.omg.CORBA.OBJECT_NOT_EXIST;

/**
 * The calls of a session that are under way, each with its thread. The end of the session
 * interrupts them, so that nothing is computed for a client that has gone: a set-up may take
 * minutes. Thread-safe.
 */
final class SessionCalls implements InvocationHandler {
  private static final String END = "destroy";

  /** Operations that read, check, generate or build a model. */
  private static final Set<String> SET_UPS =
      Set.of(
          "loadModel",
          "getModelInfo",
          "parameters",
          "roadmap",
          "checkReport",
          "checkReportWith",
          "readWith",
          "generatedSource",
          "createSimulation",
          "prepareSimulation",
          "compileToJar",
          "prepareJar");

  private final MechSimOperations servant;
  private final Set<Thread> threads = new HashSet<>();
  private final String client;
  private final SetUpPlaces places;
  private boolean ended;

  /**
   * @param client owner of the session
   * @param places of the set-ups of all clients
   */
  SessionCalls(MechSimOperations servant, String client, SetUpPlaces places) {
    this.servant = servant;
    this.client = client;
    this.places = places;
  }

  /** Returns the servant, whose calls are watched. */
  MechSimOperations watched() {
    return (MechSimOperations)
        Proxy.newProxyInstance(
            MechSimOperations.class.getClassLoader(),
            new Class<?>[] {MechSimOperations.class},
            this);
  }

  @Override
  public @Nullable Object invoke(Object proxy, Method operation, Object @Nullable [] arguments)
      throws Throwable {
    boolean stops = !operation.getName().equals(END);
    if (stops) {
      begin();
    }
    try {
      return SET_UPS.contains(operation.getName())
          ? setUp(operation, arguments)
          : operation.invoke(servant, arguments);
    } catch (InvocationTargetException e) {
      Throwable thrown = e.getCause() == null ? e : e.getCause();
      throw thrown instanceof CancellationException ? gone() : thrown;
    } finally {
      if (stops) {
        done();
      }
    }
  }

  private @Nullable Object setUp(Method operation, Object @Nullable [] arguments)
      throws ReflectiveOperationException, IMP_LIMIT, LimitExceeded {
    SetUpPlaces.@Nullable Place place;
    try {
      place = places.enter(client);
    } catch (LimitExceeded e) {
      throw asDeclared(operation, e);
    } catch (CancellationException e) {
      throw gone();
    }
    try {
      return operation.invoke(servant, arguments);
    } catch (InvocationTargetException e) {
      boolean late = places.leave(place);
      place = null;
      if (late) {
        throw asDeclared(operation, places.tooLong());
      } else if (isOutOfMemory(e.getCause())) {
        throw asDeclared(operation, SetUpPlaces.tooLarge());
      }
      throw e;
    } finally {
      if (place != null) {
        places.leave(place);
      }
    }
  }

  private static boolean isOutOfMemory(@Nullable Throwable thrown) {
    return thrown instanceof OutOfMemoryError
        || (thrown instanceof CompletionException && thrown.getCause() instanceof OutOfMemoryError);
  }

  /** An operation whose contract has no such refusal gives the one that each operation has. */
  private static IMP_LIMIT asDeclared(Method operation, LimitExceeded refusal)
      throws LimitExceeded {
    if (Set.of(operation.getExceptionTypes()).contains(LimitExceeded.class)) {
      throw refusal;
    }
    return ContractErrors.undeclared(refusal);
  }

  private synchronized void begin() {
    if (ended) {
      throw gone();
    }
    threads.add(Thread.currentThread());
  }

  private static OBJECT_NOT_EXIST gone() {
    return new OBJECT_NOT_EXIST("the session has ended");
  }

  /** The thread serves other clients next. */
  private synchronized void done() {
    threads.remove(Thread.currentThread());
    if (Thread.interrupted() && !ended) {
      Thread.currentThread().interrupt();
    }
  }

  /** Interrupts the calls that are under way, and refuses further ones. */
  synchronized void end() {
    ended = true;
    threads.forEach(Thread::interrupt);
  }
}
