package org.mechservice.admin;

import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.lang.reflect.Proxy;
import org.junit.jupiter.api.Test;
import org.mechservice.idl.MechAdmin;
import org.mechservice.idl.ServerStatus;
import org.omg.CORBA.COMM_FAILURE;
import org.omg.CORBA.TRANSIENT;

/** A server that ends at once may close the connection before its answer is through. */
class ShutdownAnswerTest {
  private static final AdminAction AT_ONCE = new AdminAction.Shutdown(0);

  private interface Status {
    ServerStatus get();
  }

  /** A server whose answer to a shutdown is lost. */
  private static MechAdmin server(Status afterwards) {
    return (MechAdmin)
        Proxy.newProxyInstance(
            MechAdmin.class.getClassLoader(),
            new Class<?>[] {MechAdmin.class},
            (proxy, method, arguments) -> {
              if (method.getName().equals("getStatus")) {
                return afterwards.get();
              }
              throw new COMM_FAILURE();
            });
  }

  @Test
  void serverThatIsGoneAfterwardsWasShutDown() {
    assertThatCode(() -> AT_ONCE.perform(server(() -> refused(new TRANSIENT()))))
        .doesNotThrowAnyException();
    assertThatCode(() -> AT_ONCE.perform(server(() -> refused(new COMM_FAILURE()))))
        .doesNotThrowAnyException();
  }

  private static ServerStatus refused(RuntimeException failure) {
    throw failure;
  }

  @Test
  void serverThatStillAnswersWasNot() {
    assertThatThrownBy(() -> AT_ONCE.perform(server(ServerStatus::new)))
        .isInstanceOf(COMM_FAILURE.class);
  }
}
