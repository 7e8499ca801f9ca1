package org.mechservice.sim.service.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.mechservice.orb.testing.Eventually;
import org.mechservice.sim.service.results.RunIdentity;
import org.mechservice.sim.service.setup.SetUps;

/** Reports that administrators look at, of models whose report takes long. */
class CheckReportsTest {
  private final AtomicInteger begun = new AtomicInteger();
  private final CountDownLatch held = new CountDownLatch(1);
  private final ExecutorService executor = Executors.newCachedThreadPool();
  private final CheckReports reports = new CheckReports(slow(), executor);

  private SetUps slow() {
    return (SetUps)
        Proxy.newProxyInstance(
            SetUps.class.getClassLoader(),
            new Class<?>[] {SetUps.class},
            (proxy, operation, arguments) -> {
              begun.incrementAndGet();
              held.await();
              return "{} of " + arguments[1];
            });
  }

  private static RunIdentity run(int model) {
    return new RunIdentity(
        "id", "session", "host", "ann", "m", "m.xml", "text " + model, 0, List.of());
  }

  @AfterEach
  void close() {
    held.countDown();
    executor.shutdown();
  }

  @Test
  void fewAreMadeAtOnceHoweverManyAreLookedAt() throws Exception {
    int looked = 3 * CheckReports.AT_ONCE;
    List<Future<String>> answers = new ArrayList<>();
    for (int i = 0; i < looked; i++) {
      RunIdentity run = run(i);
      answers.add(executor.submit(() -> reports.of(run)));
    }
    for (Future<String> answer : answers) {
      assertThat(answer.get()).isEmpty();
    }
    assertThat(begun).hasValue(CheckReports.AT_ONCE);
    held.countDown();
    for (int i = 0; i < looked; i++) {
      RunIdentity run = run(i);
      Eventually.holds(() -> reports.of(run).equals("{} of " + run.modelText()));
    }
    assertThat(begun).hasValue(looked);
  }
}
