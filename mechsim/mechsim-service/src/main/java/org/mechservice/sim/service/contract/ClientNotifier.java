package org.mechservice.sim.service.contract;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.concurrent.Executor;
import java.util.concurrent.RejectedExecutionException;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.mechservice.idl.Diagnostic;
import org.mechservice.idl.IMechClient;
import org.mechservice.idl.Progress;
import org.mechservice.idl.SimState;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Calls a client back, in order, from a thread of its own, so that a slow or dead client does not
 * delay others. New progress replaces progress that was not delivered yet; at most {@value
 * #WAITING} messages wait. Messages lost here stay in the {@link SessionEvents}.
 */
public final class ClientNotifier {
  private static final Logger LOG = LoggerFactory.getLogger(ClientNotifier.class);
  private static final int WAITING = 256;

  /** A message on its way; {@code progressOf} is the simulation whose progress it is, or "". */
  private record Message(IMechClient client, String progressOf, Consumer<IMechClient> call) {}

  private final Executor threads;
  private final Deque<Message> waiting = new ArrayDeque<>();
  private boolean delivering;

  public ClientNotifier(Executor threads) {
    this.threads = threads;
  }

  public void status(IMechClient client, String simId, SimState state, String text) {
    send(new Message(client, "", callee -> callee.onStatus(simId, state, text)));
  }

  public void messages(IMechClient client, String simId, Diagnostic[] messages) {
    send(new Message(client, "", callee -> callee.onMessages(simId, messages)));
  }

  public synchronized void progress(IMechClient client, Progress progress) {
    waiting.removeIf(message -> message.progressOf().equals(progress.simId));
    send(new Message(client, progress.simId, callee -> callee.onProgress(progress)));
  }

  private synchronized void send(Message message) {
    if (waiting.size() >= WAITING) {
      waiting.removeFirst();
    }
    waiting.addLast(message);
    if (!delivering) {
      delivering = true;
      try {
        threads.execute(this::deliver);
      } catch (RejectedExecutionException e) {
        LOG.debug("the host is closing; a client is not told any more");
      }
    }
  }

  private void deliver() {
    for (Message message = next(); message != null; message = next()) {
      try {
        message.call().accept(message.client());
      } catch (RuntimeException e) {
        // Not only the ORB's exceptions: a reference that a client has made up ends in others.
        LOG.debug("a client could not be called back: {}", e.toString());
      }
    }
  }

  private synchronized @Nullable Message next() {
    Message message = waiting.pollFirst();
    delivering = message != null;
    return message;
  }
}
