package org.mechservice.client.failure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.lang.reflect.Proxy;
import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.mechservice.idl.MechSim;
import org.omg.CORBA.NO_MEMORY;
import org.omg.CORBA.TIMEOUT;

/** A set-up that lasts is not a server that is lost. */
class SetUpCallsTest {
  private static final Duration LIMIT = Duration.ofHours(1);

  /** A session whose calls all give the same. */
  private static MechSim session(Supplier<Object> answer) {
    return (MechSim)
        Proxy.newProxyInstance(
            MechSim.class.getClassLoader(),
            new Class<?>[] {MechSim.class},
            (self, method, values) -> answer.get());
  }

  private static SetUpCalls calls(MechSim session, MechSim patient) {
    return new SetUpCalls(new RemoteCalls("here:1"), session, patient, LIMIT, Duration.ofMillis(1));
  }

  private static Object timeout() {
    throw new TIMEOUT();
  }

  @Test
  void theServerIsAskedWhetherItIsThereUntilTheAnswerComes() {
    AtomicInteger asked = new AtomicInteger();
    CountDownLatch enough = new CountDownLatch(3);
    MechSim session =
        session(
            () -> {
              enough.countDown();
              asked.incrementAndGet();
              return "id";
            });
    MechSim patient =
        session(
            () -> {
              await(enough);
              return "report";
            });
    assertThat(calls(session, patient).<String>get(s -> s.checkReport(true))).isEqualTo("report");
    assertThat(asked).hasValueGreaterThanOrEqualTo(3);
  }

  @Test
  void aSetUpBeyondItsLimitHasAMessageOfItsOwn() {
    MechSim patient = session(SetUpCallsTest::timeout);
    assertThatExceptionOfType(LimitExceededException.class)
        .isThrownBy(() -> calls(session(() -> "id"), patient).get(s -> s.checkReport(true)))
        .withMessageStartingWith(
            "S-230 the server at here:1 is there, but has not set the model up")
        .withMessageContaining("within 3600 s")
        .satisfies(e -> assertThat(e.limit()).isEqualTo("setUp"));
  }

  /** The ORB refuses a message above its bound with an exception that names memory. */
  @Test
  void anAnswerLargerThanAMessageIsALimitAndNotAnotherVersion() {
    MechSim patient =
        session(
            () -> {
              throw new NO_MEMORY();
            });
    assertThatExceptionOfType(LimitExceededException.class)
        .isThrownBy(() -> calls(session(() -> "id"), patient).get(s -> s.checkReport(true)))
        .withMessageStartingWith("S-010 what the server at here:1 was sent or has to answer")
        .withMessageContaining("33554432 bytes")
        .satisfies(e -> assertThat(e.limit()).isEqualTo("messageBytes"));
  }

  @Test
  void aServerThatIsLostMeanwhileIsToldAtOnce() {
    CountDownLatch never = new CountDownLatch(1);
    MechSim patient =
        session(
            () -> {
              await(never);
              return "";
            });
    MechSim silent = session(SetUpCallsTest::timeout);
    assertThatExceptionOfType(ServerLostException.class)
        .isThrownBy(() -> calls(silent, patient).get(s -> s.checkReport(true)))
        .withMessageContaining("S-032");
    never.countDown();
  }

  private static void await(CountDownLatch latch) {
    try {
      latch.await();
    } catch (InterruptedException e) {
      throw new IllegalStateException(e);
    }
  }
}
