package org.mechservice.admin;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.admin.AdminFailure.Reason;
import org.mechservice.idl.SimState;

/** The console asks over CORBA what a scripted server answers. */
@Tag("slow")
class AdminConsoleTest {
  private static final Duration PATIENCE = Duration.ofSeconds(60);

  private final ScriptedAdmin server = new ScriptedAdmin("lab");
  private final AdminConsole console = new AdminConsole(List.of(server.address()), PATIENCE);

  @AfterEach
  void end() {
    console.close();
    server.close();
  }

  private static AdminFailure failure(ThrowingCallable call) {
    return catchThrowableOfType(AdminFailure.class, call);
  }

  @Test
  void actionsCallWhatTheyAreNamedAfter() {
    server.host("big", 0.1, true, "");
    server.simulation("sim-1", "big", "arm", SimState.SIM_RUNNING);
    for (AdminAction action :
        List.of(
            new AdminAction.StopSimulation("sim-1", "maintenance"),
            new AdminAction.EndSessions("ann", "", "too many"),
            new AdminAction.EndSessions("", "3f2a-1", "too many"),
            new AdminAction.Drain("big"),
            new AdminAction.Undrain(""),
            new AdminAction.SetLimits("", Map.of("queue", 7L)),
            new AdminAction.SetPlacement("order"),
            new AdminAction.Shutdown(5))) {
      console.perform(server.address(), action);
    }
    assertThat(server.calls())
        .containsExactly(
            "kill sim-1 maintenance",
            "endSessions ann too many",
            "endSessions 3f2a-1 too many",
            "drain big",
            "undrain ",
            "limit  queue=7",
            "placement order",
            "shutdown 5");
    assertThat(console.limits(server.address(), "")).extracting(limit -> limit.value).contains(7L);
    assertThat(console.placement(server.address())).isEqualTo("order");
  }

  @Test
  void refusalsSayWhy() {
    assertThat(failure(() -> console.show(server.address(), "none")).reason())
        .isEqualTo(Reason.NOT_FOUND);
    AdminFailure limit =
        failure(
            () ->
                console.perform(
                    server.address(), new AdminAction.SetLimits("", Map.of("queue", -5L))));
    assertThat(limit.reason()).isEqualTo(Reason.NOT_USABLE);
    assertThat(limit).hasMessage("S-015 queue cannot be -5");
    server.forbid();
    AdminFailure rights =
        failure(() -> console.perform(server.address(), new AdminAction.Drain("")));
    assertThat(rights.reason()).isEqualTo(Reason.NOT_ALLOWED);
    assertThat(rights).hasMessage("S-151 not for you");
    assertThat(console.read(server.address()))
        .isEqualTo(new ServerReading.Silent(server.address(), "S-151 not for you", true));
  }

  @Test
  void onlyTheServersOfTheConsoleAreAsked() {
    assertThat(failure(() -> console.read("10.0.0.1:15000"))).hasMessageStartingWith("S-130 ");
    assertThat(failure(() -> console.perform("x", new AdminAction.Drain(""))))
        .hasMessageStartingWith("S-130 ");
  }

  @Test
  void moreSimulationsThanFitIntoOneAnswerAreAllListed() {
    for (int i = 0; i < 2100; i++) {
      server.simulation("sim-" + i, "big", "arm", SimState.SIM_DONE);
    }
    assertThat(console.read(server.address()))
        .isInstanceOfSatisfying(
            ServerReading.Answering.class,
            reading -> assertThat(reading.simulations()).hasSize(2100));
  }

  @Test
  void serverThatHangsIsSilentAndTheOthersAnswerAllTheSame() {
    try (ScriptedAdmin other = new ScriptedAdmin("other");
        AdminConsole both =
            new AdminConsole(List.of(server.address(), other.address()), Duration.ofSeconds(8))) {
      server.hang();
      List<ServerReading> readings = both.read();
      assertThat(readings.get(0))
          .isEqualTo(
              new ServerReading.Silent(
                  server.address(),
                  "S-032 the server at " + server.address() + " did not answer in time"));
      assertThat(readings.get(1)).isInstanceOf(ServerReading.Answering.class);
    }
  }

  @Test
  void serverThatComesBackAtItsAddressAnswersAgain() {
    assertThat(console.read(server.address())).isInstanceOf(ServerReading.Answering.class);
    server.close();
    assertThat(console.read(server.address())).isInstanceOf(ServerReading.Silent.class);
    try (ScriptedAdmin again = new ScriptedAdmin("again", server.port())) {
      assertThat(console.read(again.address()).name()).isEqualTo("again");
    }
  }
}
