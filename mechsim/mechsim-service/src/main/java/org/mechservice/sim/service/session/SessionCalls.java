package org.mechservice.sim.service.session;

import java.lang.reflect.InvocationHandler;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.util.HashSet;
import java.util.Set;
import java.util.concurrent.CancellationException;
import org.jspecify.annotations.Nullable;
import org.mechservice.idl.MechSimOperations;
import org.omg.CORBA.OBJECT_NOT_EXIST;

/**
 * The calls of a session that are under way, each with its thread. The end of the session
 * interrupts them, so that nothing is computed for a client that has gone: a set-up may take
 * minutes. Thread-safe.
 */
final class SessionCalls implements InvocationHandler {
  private static final String END = "destroy";

  private final MechSimOperations servant;
  private final Set<Thread> threads = new HashSet<>();
  private boolean ended;

  SessionCalls(MechSimOperations servant) {
    this.servant = servant;
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
      return operation.invoke(servant, arguments);
    } catch (InvocationTargetException e) {
      Throwable thrown = e.getCause() == null ? e : e.getCause();
      throw thrown instanceof CancellationException ? gone() : thrown;
    } finally {
      if (stops) {
        done();
      }
    }
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
