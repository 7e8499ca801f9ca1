package org.mechservice.client.run;

import java.util.List;
import org.mechservice.client.failure.ModelMessage;
import org.mechservice.client.failure.RunState;

/**
 * Receives state, progress and messages of a run. Calls do not overlap; they come from a thread of
 * the connection or from the one that takes the rows. They must be quick and must not call the
 * service, because its next answer comes over the same connection. Progress arrives at most ten
 * times a second.
 */
public interface RunListener {
  /** Receives a change of the simulation's state. */
  default void onStatus(RunState state, String text) {}

  /** Receives the progress of a simulation. */
  default void onProgress(RunProgress progress) {}

  /** Receives messages of a simulation. */
  default void onMessages(List<ModelMessage> messages) {}
}
