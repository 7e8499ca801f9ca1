package org.mechservice.server.hosts;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.BiConsumer;
import org.jspecify.annotations.Nullable;
import org.mechservice.idl.MechSimHostOperations;
import org.mechservice.idl.NotAuthorized;
import org.omg.CORBA.COMM_FAILURE;
import org.omg.CORBA.OBJECT_NOT_EXIST;
import org.omg.CORBA.SystemException;
import org.omg.CORBA.TRANSIENT;
import org.omg.CORBA.UserException;

/**
 * Calls to hosts with a bounded wait. A call that takes too long keeps its own thread, until the
 * ORB's timeout ends it.
 */
public final class HostCalls implements AutoCloseable {
  /** A call to a host. */
  public interface Query<T> {
    T query(MechSimHostOperations host) throws UserException;
  }

  /**
   * The result of a call.
   *
   * @param value the answer; empty if there was none
   * @param refusal the exception of the contract the host answered with, if it did
   * @param failure why there was no answer at all; empty if there was one
   * @param connectionLost whether the host cannot be connected to
   */
  public record Answer<T>(
      Optional<T> value, Optional<UserException> refusal, String failure, boolean connectionLost) {
    private static <T> Answer<T> of(T value) {
      return new Answer<>(Optional.of(value), Optional.empty(), "", false);
    }
  }

  private final Duration longest;
  private final ExecutorService threads = Executors.newCachedThreadPool(named("host-call"));

  /**
   * @param longest longest wait for an answer
   */
  HostCalls(Duration longest) {
    this.longest = longest;
  }

  public static ThreadFactory named(String name) {
    return task -> {
      Thread thread = new Thread(task, "mechserver-" + name);
      thread.setDaemon(true);
      return thread;
    };
  }

  /** Calls one host. */
  public <T> Answer<T> query(MechSimHostOperations host, Query<T> question) {
    Future<T> answer = threads.submit(() -> question.query(host));
    try {
      return Answer.of(answer.get(longest.toNanos(), TimeUnit.NANOSECONDS));
    } catch (TimeoutException e) {
      return silent(late(longest), false);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return silent("the server is closing", false);
    } catch (ExecutionException e) {
      return failed(e.getCause());
    }
  }

  /** Returns the reason of a host that has not answered in time. */
  static String late(Duration wait) {
    return "no answer within " + wait.toMillis() * 1e-3 + " s";
  }

  /**
   * Calls a host without waiting for the answer.
   *
   * @param then receives the answer, in a thread of this object
   * @return done when {@code then} has returned
   */
  <T> Future<?> begin(
      RegisteredHost host, Query<T> question, BiConsumer<RegisteredHost, Answer<T>> then) {
    long askedAt = host.callBegins();
    return threads.submit(
        () -> {
          Answer<T> answer;
          try {
            answer = Answer.of(question.query(host.host()));
          } catch (UserException | RuntimeException e) {
            answer = failed(e);
          } finally {
            host.callEnded(askedAt);
          }
          then.accept(host, answer);
        });
  }

  private record Answered<T>(RegisteredHost host, Answer<T> answer) {}

  /**
   * Calls many hosts at once until one has an answer.
   *
   * @param failed receives the hosts that gave no answer
   * @throws NotAuthorized if none has, and one refuses it to the user
   */
  <T> Optional<T> firstAnswer(
      List<RegisteredHost> hosts, Query<T> question, BiConsumer<RegisteredHost, Answer<T>> failed)
      throws NotAuthorized {
    Optional<NotAuthorized> refusal = Optional.empty();
    BlockingQueue<Answered<T>> answers = new LinkedBlockingQueue<>();
    for (RegisteredHost host : hosts) {
      Future<?> unused =
          begin(host, question, (from, answer) -> answers.add(new Answered<>(from, answer)));
    }
    long deadline = System.nanoTime() + longest.toNanos();
    try {
      for (int i = 0; i < hosts.size(); i++) {
        Answered<T> next = answers.poll(deadline - System.nanoTime(), TimeUnit.NANOSECONDS);
        if (next == null) {
          break;
        } else if (next.answer().value().isPresent()) {
          return next.answer().value();
        } else if (!next.answer().failure().isEmpty()) {
          failed.accept(next.host(), next.answer());
        } else if (next.answer().refusal().orElseThrow() instanceof NotAuthorized refused) {
          refusal = Optional.of(refused);
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    if (refusal.isPresent()) {
      throw refusal.get();
    }
    return Optional.empty();
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
  public void awaitEnd(long millis) throws InterruptedException {
    threads.awaitTermination(millis, TimeUnit.MILLISECONDS);
  }
}
