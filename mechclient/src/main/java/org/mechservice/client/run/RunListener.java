package org.mechservice.client.run;

import java.util.List;
import org.mechservice.client.failure.ModelMessage;
import org.mechservice.client.failure.RunState;

/**
 * Hears of a run while it goes on. The methods are called one after the other, from a thread of the
 * connection or the one that takes the rows; they must be quick and must not call the service,
 * because its next answer comes over the same connection. Progress arrives at most ten times a
 * second.
 */
public interface RunListener {
  /** Hears that a simulation has changed its state. */
  default void onStatus(RunState state, String text) {}

  /** Hears how far a simulation is. */
  default void onProgress(RunProgress progress) {}

  /** Hears what a simulation has to say. */
  default void onMessages(List<ModelMessage> messages) {}
}
