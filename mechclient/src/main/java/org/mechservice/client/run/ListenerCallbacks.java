package org.mechservice.client.run;

import java.util.List;
import java.util.function.Consumer;
import org.mechservice.client.failure.ModelMessage;
import org.mechservice.client.failure.RunState;
import org.mechservice.idl.Diagnostic;
import org.mechservice.idl.IMechClientOperations;
import org.mechservice.idl.Progress;
import org.mechservice.idl.SimState;
import org.mechservice.solver.catalogue.MessageCode;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Passes the server's callbacks to the user's listener and logs its exceptions. */
public final class ListenerCallbacks implements IMechClientOperations {
  private static final Logger LOG = LoggerFactory.getLogger(ListenerCallbacks.class);

  private final RunListener listener;

  public ListenerCallbacks(RunListener listener) {
    this.listener = listener;
  }

  @Override
  public void onStatus(String simId, SimState state, String text) {
    report(user -> user.onStatus(RunState.of(state), text));
  }

  @Override
  public void onProgress(Progress info) {
    report(user -> user.onProgress(RunProgress.of(info)));
  }

  @Override
  public void onMessages(String simId, Diagnostic[] messages) {
    report(user -> user.onMessages(ModelMessage.listOf(messages)));
  }

  @Override
  public void heartbeat() {}

  /** Passes a message of this client to the listener. */
  public void passOn(ModelMessage message) {
    report(user -> user.onMessages(List.of(message)));
  }

  private synchronized void report(Consumer<RunListener> message) {
    try {
      message.accept(listener);
    } catch (RuntimeException e) {
      LOG.warn(MessageCode.LISTENER_FAILED + " a run listener failed", e);
    }
  }
}
