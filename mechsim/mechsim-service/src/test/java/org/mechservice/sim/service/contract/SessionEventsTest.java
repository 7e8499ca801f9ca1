package org.mechservice.sim.service.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.mechservice.idl.Progress;
import org.mechservice.idl.SimEvent;
import org.mechservice.idl.SimState;

class SessionEventsTest {
  private static Progress progress(String simId, long steps) {
    return new Progress(simId, SimState.SIM_RUNNING, 0, 0, 0, 1, steps, 0, 0, 0, 0);
  }

  @Test
  void eventsAreNumberedAndComeOnce() throws InterruptedException {
    SessionEvents log = new SessionEvents();
    log.status(progress("a", 0), "queued");
    log.status(progress("a", 1), "running");
    SimEvent[] first = log.after(0, 1, 0);
    assertThat(first).hasSize(1);
    assertThat(first[0].text).isEqualTo("queued");
    SimEvent[] rest = log.after(first[0].seqNo, 10, 0);
    assertThat(Arrays.stream(rest).map(event -> event.text)).containsExactly("running");
    assertThat(log.after(rest[0].seqNo, 10, 0)).isEmpty();
  }

  @Test
  void onlyTheLatestProgressOfEachSimulationIsKept() throws InterruptedException {
    SessionEvents log = new SessionEvents();
    for (int steps = 0; steps < 10_000; steps++) {
      log.progress(progress("a", steps));
      log.progress(progress("b", steps));
    }
    assertThat(Arrays.stream(log.after(0, 10, 0)).map(event -> event.info.stepsDone))
        .containsExactly(9999L, 9999L);
  }

  @Test
  void statusIsNotLostBehindProgress() throws InterruptedException {
    SessionEvents log = new SessionEvents();
    log.status(progress("a", 0), "running");
    for (int steps = 0; steps < 10_000; steps++) {
      log.progress(progress("a", steps));
    }
    assertThat(log.after(0, 10, 0)[0].text).isEqualTo("running");
  }
}
