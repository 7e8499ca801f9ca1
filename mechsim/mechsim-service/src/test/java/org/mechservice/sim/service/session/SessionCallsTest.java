package org.mechservice.sim.service.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.lang.reflect.Proxy;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.mechservice.idl.MechSimOperations;
import org.mechservice.sim.service.limits.CurrentLimits;
import org.mechservice.sim.service.limits.HostLimit;
import org.mechservice.sim.service.limits.HostLimits;
import org.mechservice.sim.service.limits.SetUpPlaces;
import org.mechservice.solver.linear.Interruption;
import org.omg.CORBA.IMP_LIMIT;
import org.omg.CORBA.OBJECT_NOT_EXIST;

/** A session of which one call sets up a model without end. */
class SessionCallsTest {
  private final CountDownLatch begun = new CountDownLatch(1);
  private final ExecutorService client = Executors.newSingleThreadExecutor();
  private final SetUpPlaces places =
      new SetUpPlaces(new CurrentLimits(HostLimits.DEFAULT.with(HostLimit.SET_UP_TIME, 1)));
  private final SessionCalls calls = new SessionCalls(servant(), "ann", places);

  private MechSimOperations servant() {
    return (MechSimOperations)
        Proxy.newProxyInstance(
            MechSimOperations.class.getClassLoader(),
            new Class<?>[] {MechSimOperations.class},
            (proxy, operation, arguments) -> {
              switch (operation.getName()) {
                case "checkReport" -> {
                  begun.countDown();
                  while (true) {
                    Interruption.check();
                  }
                }
                case "destroy" -> calls.end();
                default -> {}
              }
              return operation.getReturnType() == int.class ? 1 : null;
            });
  }

  @AfterEach
  void close() {
    client.shutdownNow();
  }

  /** The limit is a second; the clock of the host looks each 0.1 s. */
  @Test
  void setUpThatTakesTooLongIsRefusedByNameAndTheSessionGoesOn() throws Exception {
    MechSimOperations session = calls.watched();
    Callable<String> setUp = () -> session.checkReport(true);
    Future<String> report = client.submit(setUp);
    begun.await();
    while (!report.isDone()) {
      Thread.sleep(100);
      places.interruptLate();
    }
    assertThatThrownBy(report::get)
        .isInstanceOf(ExecutionException.class)
        .hasCauseInstanceOf(IMP_LIMIT.class)
        .hasMessageContaining("S-230 the model was not set up within the 1 s");
    assertThat(session.renewLease()).isEqualTo(1);
    assertThat(client.submit(Thread::interrupted).get()).isNotEqualTo(true);
  }

  @Test
  void theEndOfTheSessionStopsItsSetUp() throws Exception {
    MechSimOperations session = calls.watched();
    Callable<String> setUp = () -> session.checkReport(true);
    Future<String> report = client.submit(setUp);
    begun.await();
    assertThat(session.renewLease()).isEqualTo(1);
    session.destroy();
    assertThatThrownBy(report::get)
        .isInstanceOf(ExecutionException.class)
        .hasCauseInstanceOf(OBJECT_NOT_EXIST.class);
    assertThat(client.submit(() -> Thread.currentThread().isInterrupted()).get()).isFalse();
    assertThatThrownBy(session::renewLease).isInstanceOf(OBJECT_NOT_EXIST.class);
    session.destroy();
  }
}
