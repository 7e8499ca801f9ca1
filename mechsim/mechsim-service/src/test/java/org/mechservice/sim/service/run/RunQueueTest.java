package org.mechservice.sim.service.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.sim.service.limits.CurrentLimits;
import org.mechservice.sim.service.limits.HostLimit;
import org.mechservice.sim.service.limits.HostLimits;

/** Nobody waits longer because somebody else has many runs. */
class RunQueueTest {
  private final List<String> begun = Collections.synchronizedList(new ArrayList<>());
  private final Semaphore begins = new Semaphore(0);
  private final Semaphore mayEnd = new Semaphore(0);
  private final CurrentLimits limits =
      new CurrentLimits(HostLimits.DEFAULT.with(HostLimit.QUEUE, 10));
  private RunQueue queue = new RunQueue(1, limits);

  @AfterEach
  void close() throws InterruptedException {
    mayEnd.release(100_000);
    queue.close();
    queue.awaitEnd(10_000);
  }

  private Runnable submit(String user, String name) {
    Runnable run =
        () -> {
          begun.add(name);
          begins.release();
          mayEnd.acquireUninterruptibly();
        };
    queue.submit(user, run);
    return run;
  }

  private void awaitBegun(int count) throws InterruptedException {
    assertThat(begins.tryAcquire(count, 1, TimeUnit.MINUTES)).isTrue();
  }

  @Test
  void oneRunDoesNotWaitForAThousandOfAnotherUser() throws Exception {
    for (int i = 0; i < 1000; i++) {
      submit("ann", "ann");
    }
    Runnable ofBob = submit("bob", "bob");
    assertThat(queue.positionOf(ofBob)).isEqualTo(1);
    awaitBegun(1);
    mayEnd.release();
    awaitBegun(1);
    assertThat(begun).containsExactly("ann", "bob");
  }

  @Test
  void usersTakeTurnsAndTheRunsOfEachKeepTheirOrder() throws Exception {
    submit("ann", "a1");
    awaitBegun(1);
    submit("ann", "a2");
    Runnable last = submit("ann", "a3");
    submit("bob", "b1");
    submit("bob", "b2");
    submit("eve", "e1");
    assertThat(queue.positionOf(last)).isEqualTo(5);
    mayEnd.release(5);
    awaitBegun(5);
    // One place: nobody has a run when it becomes free, so that who has waited longest is served.
    assertThat(begun).containsSubsequence("a1", "a2", "a3").containsSubsequence("b1", "b2");
    assertThat(begun.subList(1, 4)).containsExactlyInAnyOrder("a2", "b1", "e1");
  }

  @Test
  void freePlaceGoesToWhoHasFewest() throws Exception {
    queue = new RunQueue(3, limits);
    for (int i = 0; i < 6; i++) {
      submit("ann", "ann");
    }
    awaitBegun(3);
    submit("bob", "bob");
    awaitBegun(1);
    submit("bob", "bob again");
    mayEnd.release(2);
    awaitBegun(1);
    assertThat(begun.subList(0, 4)).containsExactly("ann", "ann", "ann", "bob");
  }

  /** The runs of ann may take a day each. */
  @Test
  void userWithoutARunDoesNotWaitForAUserWithSeveral() throws Exception {
    queue = new RunQueue(2, limits);
    for (int i = 0; i < 10; i++) {
      submit("ann", "ann");
    }
    awaitBegun(2);
    submit("bob", "bob");
    awaitBegun(1); // threads of their own note that they have begun
    submit("eve", "eve");
    awaitBegun(1);
    Runnable third = submit("dan", "dan");
    assertThat(begun).containsExactly("ann", "ann", "bob", "eve");
    assertThat(queue.positionOf(third)).isEqualTo(1);
  }

  @Test
  void fullQueueHasRoomForWhoHasLessThanAnEqualPart() throws Exception {
    for (int i = 0; i < 11; i++) {
      queue.requireRoom("ann");
      submit("ann", "ann");
    }
    assertThatThrownBy(() -> queue.requireRoom("ann")).isInstanceOf(LimitExceeded.class);
    for (int i = 0; i < 5; i++) {
      queue.requireRoom("bob");
      submit("bob", "bob");
    }
    assertThatThrownBy(() -> queue.requireRoom("bob")).isInstanceOf(LimitExceeded.class);
  }

  @Test
  void withdrawnRunNeverBegins() throws Exception {
    submit("ann", "first");
    awaitBegun(1);
    Runnable second = submit("ann", "second");
    assertThat(queue.withdraw(second)).isTrue();
    assertThat(queue.withdraw(second)).isFalse();
    assertThat(queue.positionOf(second)).isZero();
    submit("ann", "third");
    mayEnd.release();
    awaitBegun(1);
    assertThat(begun).containsExactly("first", "third");
  }
}
