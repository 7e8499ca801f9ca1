package org.mechservice.sim.service.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.linear.Interruption;

/** Words, at most three of them and ten letters together. */
class BoundedCacheTest {
  private final BoundedCache<String, String> latest = new BoundedCache<>(3, 10, String::length);
  private final List<String> made = new ArrayList<>();

  private String get(String word) {
    return latest.get(
        word,
        Runnable::run,
        () -> {
          made.add(word);
          return word;
        });
  }

  private void assertKept(String... words) {
    assertThat(List.of("a", "b", "c", "d", "sevenof", "larger than all"))
        .filteredOn(word -> latest.known(word).isPresent())
        .containsExactlyInAnyOrder(words);
  }

  @Test
  void aValueThatIsThereIsNotMadeAgain() {
    assertThat(get("a")).isEqualTo("a");
    assertThat(get("a")).isEqualTo("a");
    assertThat(made).containsExactly("a");
  }

  @Test
  void theOneUsedLongestAgoGoesWhereThereAreTooMany() {
    List.of("a", "b", "c", "a", "d").forEach(this::get);
    assertKept("a", "c", "d");
  }

  @Test
  void thoseUsedLongestAgoGoWhereAllAreTooLarge() {
    List.of("a", "b", "sevenof").forEach(this::get);
    assertKept("a", "b", "sevenof");
    get("c");
    assertKept("b", "c", "sevenof");
  }

  @Test
  void oneThatIsTooLargeByItselfStaysUntilTheNext() {
    List.of("a", "larger than all").forEach(this::get);
    assertKept("larger than all");
    get("b");
    assertKept("b");
  }

  @Test
  void whatIsForgottenIsMadeAgain() {
    get("a");
    latest.forget("a");
    assertKept();
    get("a");
    assertThat(made).containsExactly("a", "a");
  }

  @Test
  void whatFailedIsThrownAndTriedAgain() {
    assertThatThrownBy(
            () ->
                latest.get(
                    "a",
                    Runnable::run,
                    () -> {
                      throw new IllegalArgumentException("no");
                    }))
        .isInstanceOf(IllegalArgumentException.class);
    assertThat(get("a")).isEqualTo("a");
  }

  /** Two wait for a value whose making goes on until it is interrupted. */
  @Test
  void makingStopsWhenTheLastWhoWaitsIsInterrupted() throws Exception {
    CountDownLatch begun = new CountDownLatch(1);
    CountDownLatch stopped = new CountDownLatch(1);
    ExecutorService builds = Executors.newSingleThreadExecutor();
    Supplier<String> endless =
        () -> {
          begun.countDown();
          try {
            while (true) {
              Interruption.check();
            }
          } finally {
            stopped.countDown();
          }
        };
    List<Thread> waiting = new ArrayList<>();
    List<Throwable> thrown = Collections.synchronizedList(new ArrayList<>());
    for (int i = 0; i < 2; i++) {
      Thread thread =
          new Thread(
              () -> {
                try {
                  latest.get("long", builds, endless);
                } catch (CancellationException e) {
                  thrown.add(e);
                }
              });
      thread.start();
      waiting.add(thread);
    }
    begun.await();
    while (waiting.stream().anyMatch(t -> t.getState() != Thread.State.WAITING)) {
      Thread.onSpinWait();
    }
    waiting.get(0).interrupt();
    waiting.get(0).join();
    assertThat(stopped.getCount()).isEqualTo(1);
    waiting.get(1).interrupt();
    stopped.await();
    waiting.get(1).join();
    assertThat(thrown).hasSize(2);
    assertThat(latest.get("long", builds, () -> "made")).isEqualTo("made");
    assertThat(builds.submit(() -> Thread.currentThread().isInterrupted()).get()).isFalse();
    builds.shutdown();
  }
}
