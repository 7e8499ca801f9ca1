package org.mechservice.solver.api;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.api.run.RunControl;

class RunControlTest {
  private static final long PATIENCE_MILLIS = 60_000;

  @Test
  void oneStepAskedForIsOneStepTakenWhenTheRunIsHeldAgain() throws InterruptedException {
    RunControl control = new RunControl();
    control.step();
    ExecutorService solver = Executors.newSingleThreadExecutor();
    solver.execute(() -> stepUntilStopped(control));
    for (int steps = 1; steps <= 1000; steps++) {
      assertThat(control.awaitHeld(PATIENCE_MILLIS)).isTrue();
      assertThat(control.steps()).isEqualTo(steps);
      control.step();
    }
    control.stop();
    solver.shutdown();
  }

  private static void stepUntilStopped(RunControl control) {
    for (long steps = 0; control.proceed((double) steps, 1, 1, steps); ) {
      steps++;
    }
  }

  @Test
  void runHeldBeyondTheTimeItMayGoToStaysHeld() throws InterruptedException {
    RunControl control = new RunControl();
    control.resumeTo(5);
    ExecutorService solver = Executors.newSingleThreadExecutor();
    solver.execute(() -> stepUntilStopped(control));
    assertThat(control.awaitHeld(PATIENCE_MILLIS)).isTrue();
    control.resumeTo(3);
    assertThat(control.held()).isTrue();
    assertThat(control.time()).isEqualTo(5);
    control.stop();
    solver.shutdown();
  }

  @Test
  void heldRunGivesItsStateInItsOwnThread() throws InterruptedException {
    RunControl control = new RunControl();
    control.resumeTo(5);
    double[] state = new double[1];
    assertThat(control.state(state, PATIENCE_MILLIS)).isEmpty();
    Thread[] asked = new Thread[1];
    control.setStates(
        Optional.of(
            values -> {
              asked[0] = Thread.currentThread();
              values[0] = 42;
            }));
    Thread solver = new Thread(() -> stepUntilStopped(control));
    solver.start();
    assertThat(control.awaitHeld(PATIENCE_MILLIS)).isTrue();
    assertThat(control.state(state, PATIENCE_MILLIS)).hasValue(5);
    assertThat(state).containsExactly(42);
    assertThat(asked[0]).isSameAs(solver);
    control.setStates(Optional.empty());
    assertThat(control.state(state, PATIENCE_MILLIS)).isEmpty();
    control.stop();
    solver.join();
  }

  @Test
  void stopAfterAStepThatDoesNotEndStopsAllTheSame() throws InterruptedException {
    RunControl control = new RunControl();
    control.stopAfterStep(30, () -> false);
    assertThat(control.stopRequested()).isTrue();
    RunControl ended = new RunControl();
    ended.stopAfterStep(Long.MAX_VALUE, () -> true);
    assertThat(ended.stopRequested()).isTrue();
  }
}
