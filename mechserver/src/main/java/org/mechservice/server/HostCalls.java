package org.mechservice.server;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.jspecify.annotations.Nullable;
import org.mechservice.idl.MechSimHostOperations;
import org.omg.CORBA.COMM_FAILURE;
import org.omg.CORBA.OBJECT_NOT_EXIST;
import org.omg.CORBA.SystemException;
import org.omg.CORBA.TRANSIENT;
import org.omg.CORBA.UserException;

/**
 * Calls to hosts that come back in time, whatever the host does: a call that takes too long is left
 * to its own thread, which the ORB's timeout ends.
 */
final class HostCalls implements AutoCloseable {
  /** Something a host is asked. */
  interface Question<T> {
    T ask(MechSimHostOperations host) throws UserException;
  }

  /** Something a host is asked that depends on what is known of it. */
  interface QuestionToKnown<T> {
    T ask(MechSimHostOperations host, KnownHost known) throws UserException;
  }

  /**
   * What came of a call.
   *
   * @param value the answer; empty if there was none
   * @param refusal the exception of the contract the host answered with, if it did
   * @param failure why there was no answer at all; empty if there was one
   * @param connectionLost whether the host cannot be connected to
   */
  record Answer<T>(
      Optional<T> value, Optional<UserException> refusal, String failure, boolean connectionLost) {}

  private final Duration longest;
  private final ExecutorService threads = Executors.newCachedThreadPool(named("host-call"));

  /**
   * @param longest longest wait for an answer
   */
  HostCalls(Duration longest) {
    this.longest = longest;
  }

  static ThreadFactory named(String name) {
    return task -> {
      Thread thread = new Thread(task, "mechserver-" + name);
      thread.setDaemon(true);
      return thread;
    };
  }

  /** Asks one host. */
  <T> Answer<T> ask(MechSimHostOperations host, Question<T> question) {
    return await(threads.submit(() -> question.ask(host)), System.nanoTime() + longest.toNanos());
  }

  /** Asks many hosts at once; the waits do not add up. */
  <T> Map<KnownHost, Answer<T>> askAll(List<KnownHost> hosts, QuestionToKnown<T> question) {
    Map<KnownHost, Future<T>> asked = new LinkedHashMap<>();
    for (KnownHost host : hosts) {
      asked.put(host, threads.submit(() -> question.ask(host.host(), host)));
    }
    long deadline = System.nanoTime() + longest.toNanos();
    Map<KnownHost, Answer<T>> answers = new LinkedHashMap<>();
    asked.forEach((host, future) -> answers.put(host, await(future, deadline)));
    return answers;
  }

  private <T> Answer<T> await(Future<T> future, long deadline) {
    try {
      T value = future.get(Math.max(0, deadline - System.nanoTime()), TimeUnit.NANOSECONDS);
      return new Answer<>(Optional.of(value), Optional.empty(), "", false);
    } catch (TimeoutException e) {
      return silent("no answer within " + longest.toMillis() * 1e-3 + " s", false);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return silent("the server is closing", false);
    } catch (ExecutionException e) {
      return failed(e.getCause());
    }
  }

  private static <T> Answer<T> failed(@Nullable Throwable thrown) {
    if (thrown instanceof UserException refusal) {
      return new Answer<>(Optional.empty(), Optional.of(refusal), "", false);
    } else if (thrown instanceof COMM_FAILURE || thrown instanceof TRANSIENT) {
      return silent("nobody answers at its address", true);
    } else if (thrown instanceof OBJECT_NOT_EXIST) {
      return silent("another process answers at its address", true);
    } else if (thrown instanceof SystemException e) {
      return silent(e.getClass().getSimpleName(), false);
    }
    throw new IllegalStateException(thrown);
  }

  private static <T> Answer<T> silent(String why, boolean connectionLost) {
    return new Answer<>(Optional.empty(), Optional.empty(), why, connectionLost);
  }

  @Override
  public void close() {
    threads.shutdown();
  }

  /** Waits until no call is under way. */
  void awaitEnd(long millis) throws InterruptedException {
    threads.awaitTermination(millis, TimeUnit.MILLISECONDS);
  }
}
