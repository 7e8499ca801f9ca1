package org.mechservice.orb;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.lang.reflect.Proxy;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.mechservice.idl.MechServerOperations;
import org.mechservice.idl.NotFound;
import org.mechservice.idl.ServerFailure;
import org.omg.CORBA.INTERNAL;
import org.omg.CORBA.NO_PERMISSION;
import org.omg.CORBA.OBJECT_NOT_EXIST;

class GuardedServantTest {
  private final AtomicInteger calls = new AtomicInteger();

  private MechServerOperations guarded(Throwable thrown) {
    MechServerOperations failing =
        (MechServerOperations)
            Proxy.newProxyInstance(
                MechServerOperations.class.getClassLoader(),
                new Class<?>[] {MechServerOperations.class},
                (proxy, method, arguments) -> {
                  throw thrown;
                });
    return GuardedServant.of(MechServerOperations.class, failing, calls::incrementAndGet);
  }

  @Test
  void unexpectedFailureIsAnIncidentWithoutJavaText() {
    MechServerOperations server = guarded(new IllegalStateException("secret"));
    ServerFailure failure =
        catchThrowableOfType(ServerFailure.class, () -> server.createSession("", "", null));
    assertThat(failure.code).isEqualTo("S-001");
    assertThat(failure.incidentId).isNotEmpty();
    assertThat(failure.text).contains(failure.incidentId).doesNotContain("secret");
  }

  @Test
  void operationWithoutServerFailureAnswersInternal() {
    assertThatThrownBy(guarded(new StackOverflowError())::getInfo)
        .isInstanceOf(INTERNAL.class)
        .hasMessageContaining("S-001 incident");
  }

  @Test
  void callOfAClosingProcessIsNoIncident() {
    assertThatThrownBy(guarded(new RejectedExecutionException())::getInfo)
        .isInstanceOf(OBJECT_NOT_EXIST.class);
  }

  @Test
  void expectedRefusalsPass() {
    NotFound refusal = new NotFound("S-011", "none");
    assertThatThrownBy(() -> guarded(refusal).findSession("x")).isSameAs(refusal);
    NO_PERMISSION denied = new NO_PERMISSION();
    assertThatThrownBy(() -> guarded(denied).findSession("x")).isSameAs(denied);
  }

  @Test
  void everyCallIsNoticed() {
    MechServerOperations server = guarded(new NO_PERMISSION());
    assertThatThrownBy(server::getInfo).isInstanceOf(NO_PERMISSION.class);
    assertThatThrownBy(server::limits).isInstanceOf(NO_PERMISSION.class);
    assertThat(calls).hasValue(2);
  }
}
