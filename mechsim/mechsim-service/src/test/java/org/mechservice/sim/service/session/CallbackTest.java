package org.mechservice.sim.service.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.mechservice.sim.service.session.HostedClient.ALL;

import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.idl.Diagnostic;
import org.mechservice.idl.IMechClientOperations;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.Progress;
import org.mechservice.idl.SimState;
import org.mechservice.orb.testing.CursorRows;
import org.mechservice.sim.service.testing.PacedSolver;

@Tag("slow")
class CallbackTest {
  private static final NameValue[] AS_IN_FILE = new NameValue[0];

  /** Writes down what it hears; may be told to be slow. */
  private static final class Listener implements IMechClientOperations {
    final BlockingQueue<String> heard = new LinkedBlockingQueue<>();
    final AtomicInteger progress = new AtomicInteger();
    final CountDownLatch blocked;

    Listener(int blocks) {
      blocked = new CountDownLatch(blocks);
    }

    private void hear(String said) {
      try {
        blocked.await();
        heard.add(said);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
    }

    @Override
    public void onStatus(String simId, SimState state, String text) {
      hear(text);
    }

    @Override
    public void onProgress(Progress info) {
      progress.incrementAndGet();
    }

    @Override
    public void onMessages(String simId, Diagnostic[] messages) {
      hear(messages[messages.length - 1].code);
    }

    @Override
    public void heartbeat() {
      hear("heartbeat");
    }
  }

  @Test
  void clientHearsOfItsRunInOrder() throws Exception {
    Listener listener = new Listener(0);
    try (HostedClient there = HostedClient.withInstalledSolver()) {
      MechSim session = there.session();
      IMechSimRemote run = session.createSimulation(AS_IN_FILE, there.clientOrb.export(listener));
      run.start();
      for (String expected : List.of("S-017", "waiting for a place", "running", "done")) {
        assertThat(listener.heard.poll(1, TimeUnit.MINUTES)).isEqualTo(expected);
      }
    }
  }

  @Test
  void longRunTellsItsProgressAndItsHolds() throws Exception {
    Listener listener = new Listener(0);
    try (HostedClient there = HostedClient.with(PacedSolver.endless())) {
      IMechSimRemote run =
          there.session().createSimulation(AS_IN_FILE, there.clientOrb.export(listener));
      run.start();
      while (listener.progress.get() < 3) {
        Thread.sleep(10);
      }
      run.pause();
      String said = "";
      while (!said.startsWith("paused at t=")) {
        said = String.valueOf(listener.heard.poll(1, TimeUnit.MINUTES));
      }
    }
  }

  @Test
  void clientThatHangsInACallbackHoldsUpNobody() throws Exception {
    Listener hanging = new Listener(1);
    try (HostedClient there = HostedClient.with(new PacedSolver(1000, 10_000))) {
      IMechSimRemote run =
          there.session().createSimulation(AS_IN_FILE, there.clientOrb.export(hanging));
      run.start();
      assertThat(CursorRows.toEnd(run.openResults(ALL), 0)).hasSize(1000);
      assertThat(run.getProgress().state).isEqualTo(SimState.SIM_DONE);
      hanging.blocked.countDown();
    }
  }
}
