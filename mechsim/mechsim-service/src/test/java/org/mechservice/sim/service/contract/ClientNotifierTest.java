package org.mechservice.sim.service.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Proxy;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.mechservice.idl.IMechClient;
import org.mechservice.idl.Progress;
import org.mechservice.idl.SimState;

class ClientNotifierTest {
  private final ExecutorService threads = Executors.newCachedThreadPool();
  private final List<String> heard = new CopyOnWriteArrayList<>();
  private final CountDownLatch letThrough = new CountDownLatch(1);

  /** A client that answers its first call only when it is let through. */
  private IMechClient slowClient() {
    return (IMechClient)
        Proxy.newProxyInstance(
            IMechClient.class.getClassLoader(),
            new Class<?>[] {IMechClient.class},
            (proxy, method, arguments) -> {
              letThrough.await();
              Object said = arguments.length == 1 ? arguments[0] : arguments[2];
              heard.add(said instanceof Progress told ? "step " + told.stepsDone : said.toString());
              return null;
            });
  }

  private List<String> heardInTheEnd() throws InterruptedException {
    letThrough.countDown();
    threads.shutdown();
    assertThat(threads.awaitTermination(1, TimeUnit.MINUTES)).isTrue();
    return heard;
  }

  private static Progress progress(long steps) {
    return new Progress("a", SimState.SIM_RUNNING, 0, 0, 0, 1, steps, 0, 0, 0, 0);
  }

  @Test
  void slowClientHoldsUpNobodyAndHearsEverythingInOrder() throws InterruptedException {
    ClientNotifier notifier = new ClientNotifier(threads);
    IMechClient client = slowClient();
    for (int i = 0; i < 100; i++) {
      notifier.status(client, "a", SimState.SIM_RUNNING, "message " + i);
    }
    List<String> all = heardInTheEnd();
    assertThat(all).hasSize(100).startsWith("message 0", "message 1").endsWith("message 99");
  }

  @Test
  void slowClientHearsTheLatestProgressOnly() throws InterruptedException {
    ClientNotifier notifier = new ClientNotifier(threads);
    IMechClient client = slowClient();
    notifier.status(client, "a", SimState.SIM_RUNNING, "running");
    for (int steps = 0; steps < 1000; steps++) {
      notifier.progress(client, progress(steps));
    }
    notifier.status(client, "a", SimState.SIM_DONE, "done");
    assertThat(heardInTheEnd()).containsExactly("running", "step 999", "done");
  }

  /** Such as one that gives a reference that the ORB cannot read. */
  @Test
  void clientThatCannotBeCalledKeepsNoOtherFromHearing() throws InterruptedException {
    ClientNotifier notifier = new ClientNotifier(threads);
    IMechClient broken =
        (IMechClient)
            Proxy.newProxyInstance(
                IMechClient.class.getClassLoader(),
                new Class<?>[] {IMechClient.class},
                (proxy, method, arguments) -> {
                  throw new ArrayIndexOutOfBoundsException("no address");
                });
    IMechClient client = slowClient();
    notifier.status(client, "a", SimState.SIM_RUNNING, "first");
    notifier.status(broken, "b", SimState.SIM_RUNNING, "lost");
    notifier.status(client, "a", SimState.SIM_DONE, "last");
    assertThat(heardInTheEnd()).containsExactly("first", "last");
  }

  @Test
  void messagesThatNobodyTakesDoNotPileUp() throws InterruptedException {
    ClientNotifier notifier = new ClientNotifier(threads);
    IMechClient client = slowClient();
    for (int i = 0; i < 10_000; i++) {
      notifier.status(client, "a", SimState.SIM_RUNNING, "message " + i);
    }
    List<String> all = heardInTheEnd();
    // One is being delivered, 256 wait.
    assertThat(all).hasSizeLessThanOrEqualTo(257).endsWith("message 9999");
  }
}
