package org.mechservice.sim.service.limits;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.orb.testing.Eventually;

/** Set-ups of a client that asks for all at once, and of another one beside it. */
@Timeout(60)
class SetUpPlacesTest {
  private final SetUpPlaces places =
      new SetUpPlaces(new CurrentLimits(HostLimits.DEFAULT.with(HostLimit.CLIENT_BUILDS, 2)));
  private final AtomicInteger in = new AtomicInteger();
  private final List<Thread> threads = new ArrayList<>();

  private Thread entering(String client) {
    Thread thread =
        new Thread(
            () -> {
              try {
                places.enter(client);
                in.incrementAndGet();
              } catch (LimitExceeded | CancellationException e) {
                // It did not get in.
              }
            });
    thread.start();
    threads.add(thread);
    return thread;
  }

  @Test
  void furtherSetUpsOfAClientWaitAndOthersGoOn() throws Exception {
    SetUpPlaces.Place first = places.enter("ann");
    places.enter("ann");
    Thread third = entering("ann");
    Eventually.holds(() -> third.getState() == Thread.State.TIMED_WAITING);
    places.leave(places.enter("bob"));
    places.leave(places.enter("bob"));
    assertThat(third.isAlive()).isTrue();
    assertThat(places.leave(first)).isFalse();
    third.join();
    assertThat(in.get()).isEqualTo(1);
  }

  @Test
  void moreThanWaitAreRefusedAtOnceByName() throws Exception {
    places.enter("ann");
    places.enter("ann");
    for (int i = 0; i < 64; i++) {
      entering("ann");
    }
    Eventually.holds(
        () -> threads.stream().allMatch(t -> t.getState() == Thread.State.TIMED_WAITING));
    assertThatThrownBy(() -> places.enter("ann"))
        .isInstanceOfSatisfying(
            LimitExceeded.class,
            refusal -> {
              assertThat(refusal.code).isEqualTo("S-119");
              assertThat(refusal.limitName).isEqualTo("clientBuilds");
              assertThat(refusal.text).contains("2 models of one client at once", "64 wait");
            });
    places.enter("bob");
    threads.forEach(Thread::interrupt);
    for (Thread thread : threads) {
      thread.join();
    }
    assertThat(in.get()).isZero();
  }
}
