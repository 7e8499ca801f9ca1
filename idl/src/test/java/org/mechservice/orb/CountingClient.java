package org.mechservice.orb;

import java.util.concurrent.atomic.AtomicInteger;
import org.mechservice.idl.Diagnostic;
import org.mechservice.idl.IMechClientOperations;
import org.mechservice.idl.Progress;
import org.mechservice.idl.SimState;

/** Counts how often it is asked whether it is alive. */
final class CountingClient implements IMechClientOperations {
  final AtomicInteger heartbeats = new AtomicInteger();

  @Override
  public void onStatus(String simId, SimState state, String text) {
    heartbeats.get();
  }

  @Override
  public void onProgress(Progress info) {
    heartbeats.get();
  }

  @Override
  public void onMessages(String simId, Diagnostic[] messages) {
    heartbeats.get();
  }

  @Override
  public void heartbeat() {
    heartbeats.incrementAndGet();
  }
}
