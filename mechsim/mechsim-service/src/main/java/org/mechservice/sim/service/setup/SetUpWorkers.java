package org.mechservice.sim.service.setup;

import java.io.IOException;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import org.jspecify.annotations.Nullable;
import org.mechservice.guard.LostProcessException;
import org.mechservice.guard.WarmProcesses;
import org.mechservice.guard.WorkerBounds;
import org.mechservice.idl.NameValue;
import org.mechservice.sim.service.library.ClassLibrary;
import org.mechservice.sim.service.limits.CurrentLimits;
import org.mechservice.sim.service.limits.HostLimit;
import org.mechservice.sim.service.limits.HostLimits;
import org.mechservice.sim.service.limits.SetUpPlaces;
import org.omg.CORBA.UserException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Reads, generates and builds in processes of their own, so that no text of a client takes the
 * memory of a host or outlives its client. Their heap is the limit {@code setUpMemory}; a host
 * whose limit is none serves its own user alone, and does it in its own process. Thread-safe.
 */
public final class SetUpWorkers implements InvocationHandler, AutoCloseable {
  /** One for each processor is warm; while all of them work long, others get their share. */
  static final int WARM = Runtime.getRuntime().availableProcessors();

  /** Processes that work at once; further set-ups wait. */
  static final int MOST = 4 * WARM;

  /** Operations that load the classes of the usual ones. */
  private static final List<String> WARM_UP = List.of("load", "info", "build", "pack");

  private static final Logger LOG = LoggerFactory.getLogger(SetUpWorkers.class);

  private final CurrentLimits limits;
  private final SetUpsHere here;
  private final WarmProcesses processes = new WarmProcesses(SetUpMain.class, true, MOST, WARM);
  private final SetUps setUps =
      (SetUps)
          Proxy.newProxyInstance(
              SetUps.class.getClassLoader(), new Class<?>[] {SetUps.class}, this);

  private volatile Optional<ModelFiles> warmUp = Optional.empty();

  /**
   * @param limits of the host
   * @param classes receives the classes of models that are built in this process
   */
  public SetUpWorkers(CurrentLimits limits, ClassLibrary classes) {
    this.limits = limits;
    here = new SetUpsHere(classes);
  }

  /** Returns the operations. */
  public SetUps setUps() {
    return setUps;
  }

  /** Returns whether models are read in this process. */
  public boolean areHere() {
    return limits.now().of(HostLimit.SET_UP_MEMORY) == HostLimits.UNLIMITED;
  }

  /**
   * Starts processes that read and build a model at once, so that the first clients need not wait
   * for Java to start.
   *
   * @param small a small model
   */
  public void prepare(ModelFiles small) throws IOException {
    warmUp = Optional.of(small);
    for (int i = 0; i < WARM && !areHere(); i++) {
      prepareOne(small);
    }
  }

  private void prepareOne(ModelFiles small) throws IOException {
    processes.prepare(
        bounds(),
        (out, in) -> {
          for (String operation : WARM_UP) {
            Method called = SetUpCall.operation(operation);
            Object[] arguments =
                called.getParameterCount() == 1
                    ? new Object[] {small}
                    : new Object[] {small, new NameValue[0]};
            SetUpCall.hold(called, arguments, out, in);
          }
          return "";
        });
  }

  /** Puts a process in the place of one that has ended. */
  private void replace() {
    warmUp.ifPresent(
        small -> {
          Thread starting =
              new Thread(
                  () -> {
                    try {
                      prepareOne(small);
                    } catch (IOException e) {
                      LOG.warn("the next model will take longer: {}", e.toString());
                    }
                  },
                  "mechservice-set-up-start");
          starting.setDaemon(true);
          starting.start();
        });
  }

  private WorkerBounds bounds() {
    return new WorkerBounds(limits.now().of(HostLimit.SET_UP_MEMORY), -1);
  }

  @Override
  public Object invoke(Object proxy, Method operation, Object @Nullable [] given) throws Throwable {
    Object[] arguments = given == null ? new Object[0] : given;
    if (areHere()) {
      return invokeHere(operation, arguments);
    }
    Object topic = arguments[0] instanceof ModelFiles files ? files.key() : "";
    WorkerBounds bounds = bounds();
    try {
      Object answer =
          processes.ask(
              bounds,
              topic,
              limits.now().bound(HostLimit.SET_UP_TIME),
              (out, in) -> SetUpCall.hold(operation, arguments, out, in));
      if (answer instanceof UserException refusal) {
        throw refusal;
      }
      return answer;
    } catch (LostProcessException e) {
      replace();
      throw refusal(e, bounds);
    } catch (CancellationException e) {
      replace();
      throw e;
    }
  }

  private Object invokeHere(Method operation, Object[] arguments) throws Throwable {
    try {
      return operation.invoke(here, arguments);
    } catch (InvocationTargetException e) {
      throw e.getCause() == null ? e : e.getCause();
    }
  }

  private Exception refusal(LostProcessException lost, WorkerBounds bounds) {
    return switch (lost.why()) {
      case MEMORY -> SetUpPlaces.tooLarge(HostLimit.SET_UP_MEMORY, bounds.heapBytes());
      case TIME -> SetUpPlaces.tooLong(limits.now());
      case OTHER ->
          new IllegalStateException("the process that sets up models has ended unexpectedly", lost);
    };
  }

  @Override
  public void close() {
    processes.close();
    here.close();
  }
}
