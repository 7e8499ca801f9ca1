package org.mechservice.server.hosts;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Proxy;
import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.mechservice.idl.HostInfo;
import org.mechservice.idl.HostLoad;
import org.mechservice.idl.MechSimHostOperations;
import org.mechservice.idl.NameValue;
import org.mechservice.orb.connection.Endpoint;

class RegisteredHostTest {
  private static final HostLoad IDLE = new HostLoad(0, 0, 0, 0, 0, false, new NameValue[0]);

  private final RegisteredHost host =
      new RegisteredHost(
          new HostInfo(), neverAsked(), /* own= */ false, new Endpoint("127.0.0.1", 1));

  private static MechSimHostOperations neverAsked() {
    return (MechSimHostOperations)
        Proxy.newProxyInstance(
            RegisteredHostTest.class.getClassLoader(),
            new Class<?>[] {MechSimHostOperations.class},
            (proxy, method, arguments) -> {
              throw new UnsupportedOperationException(method.getName());
            });
  }

  @Test
  void silentHostIsReachableAgainOnceItAnswers() {
    host.silent("no answer");
    host.answered(IDLE, System.nanoTime());
    assertThat(host.open()).isTrue();
  }

  /** An answer may be on its way while the host is dropped. */
  @Test
  void droppedHostStaysDroppedWhenALateAnswerArrives() {
    host.dropped("it has not renewed");
    host.answered(IDLE, System.nanoTime());
    host.silent("no answer");
    assertThat(host.open()).isFalse();
    assertThat(host.status().text).isEqualTo("dropped: it has not renewed");
  }

  /** What it says of itself may have been asked for before it was told. */
  @Test
  void hostIsAsItWasToldToBeUntilItSaysOtherwise() {
    long before = System.nanoTime();
    host.recordDraining(true);
    host.answered(IDLE, before);
    assertThat(host.open()).isFalse();
    host.answered(IDLE, System.nanoTime());
    assertThat(host.open()).isTrue();
  }

  /** A session is counted once, whether the load was asked for before it was placed or after. */
  @Test
  void sessionPlacedWhileTheLoadIsAskedForIsCountedOnce() {
    int free = host.freePlaces();
    long before = System.nanoTime();
    host.placed();
    assertThat(host.freePlaces()).isEqualTo(free - 1);
    host.answered(IDLE, before);
    assertThat(host.freePlaces()).as("not in the load yet").isEqualTo(free - 1);
    host.answered(withSessions(1), before);
    assertThat(host.freePlaces()).as("in the load").isEqualTo(free - 1);
    host.placed();
    host.placed();
    host.answered(withSessions(2), before);
    assertThat(host.freePlaces()).isEqualTo(free - 3);
    host.answered(withSessions(3), System.nanoTime());
    assertThat(host.freePlaces()).isEqualTo(free - 3);
    host.answered(IDLE, System.nanoTime());
    assertThat(host.freePlaces()).isEqualTo(free);
  }

  private static HostLoad withSessions(int sessions) {
    return new HostLoad(sessions, 0, 0, 0, 0, false, new NameValue[0]);
  }

  /** An answer may still be on its way, or one question hang. */
  @Test
  void hostThatAnswersOthersOwesNoAnswerThatIsLate() throws InterruptedException {
    Duration late = Duration.ofSeconds(1);
    host.callBegins();
    Thread.sleep(late.plusMillis(100).toMillis());
    assertThat(host.isOverdue(late)).isTrue();
    host.answered(IDLE, System.nanoTime());
    assertThat(host.isOverdue(late)).isFalse();
  }
}
