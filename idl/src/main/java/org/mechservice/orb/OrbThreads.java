package org.mechservice.orb;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.function.Supplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The threads of one ORB: those it starts belong to the group its makers were in. What ends one of
 * them unexpectedly goes to the log; Java would print it on the user's terminal.
 */
final class OrbThreads extends ThreadGroup {
  private static final Logger LOG = LoggerFactory.getLogger(OrbThreads.class);

  /** The threads of connections, as the ORB names them. */
  private static final String READERS = "ServerMessageReceptor";

  private volatile boolean closing;

  OrbThreads() {
    super("mechservice-orb");
  }

  /** Runs something in a thread of the group, to which all threads it starts will belong. */
  <T> T call(Supplier<T> task) {
    CompletableFuture<T> result = new CompletableFuture<>();
    new Thread(
            this,
            () -> {
              try {
                result.complete(task.get());
              } catch (RuntimeException | Error e) {
                result.completeExceptionally(e);
              }
            },
            "mechservice-orb-start")
        .start();
    try {
      return result.join();
    } catch (CompletionException e) {
      if (e.getCause() instanceof RuntimeException cause) {
        throw cause;
      }
      throw e;
    }
  }

  /** Runs something as {@link #call} does. */
  void run(Runnable task) {
    call(
        () -> {
          task.run();
          return true;
        });
  }

  /** Records that the ORB is being closed: a late message then finds its adapter gone. */
  void closing() {
    closing = true;
  }

  @Override
  public void uncaughtException(Thread thread, Throwable thrown) {
    if (closing && thrown instanceof org.omg.CORBA.OBJECT_NOT_EXIST) {
      LOG.debug("{} had a message left when the ORB closed", thread.getName());
    } else if (thread.getName().startsWith(READERS) && thrown instanceof RuntimeException) {
      LOG.info("a message cannot be read; its connection is closed: {}", thrown.toString());
    } else {
      GuardedServant.record("thread " + thread.getName(), thrown);
    }
  }
}
