package org.mechservice.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.NotFound;
import org.mechservice.idl.SimState;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.orb.testing.Eventually;

class PlacementTest {
  @Test
  void sessionGoesWhereMostPlacesAreFreeAndToARegisteredHostAmongEquals() throws Exception {
    try (Farm farm = new Farm(2)) {
      farm.host("large", 3);
      farm.host("small", 1);
      List<MechSim> sessions =
          List.of(
              farm.session(""), // 3 free at large, 2 own, 1 small
              farm.session(""), // 2 at large, 2 own: the registered one
              farm.session(""), // 1 at large, 2 own
              farm.session("")); // 1 everywhere: a registered one, by name
      assertThat(sessions)
          .extracting(MechSim::hostName)
          .containsExactly("large", "large", "own", "large");
    }
  }

  @Test
  void namedHostIsTaken() throws Exception {
    try (Farm farm = new Farm(1)) {
      farm.host("h", 8);
      assertThat(farm.session("own").hostName()).isEqualTo("own");
      assertThat(farm.session("h").hostName()).isEqualTo("h");
    }
  }

  @Test
  void unknownHostIsAnsweredWithTheKnownOnes() throws Exception {
    try (Farm farm = new Farm(1)) {
      farm.host("h", 1);
      NotFound refusal = catchThrowableOfType(NotFound.class, () -> farm.session("x"));
      assertThat(refusal.code).isEqualTo("S-011");
      assertThat(refusal.text).contains("\"x\"").contains("h, own");
    }
  }

  @Test
  void serverWithoutHostsHasNoPlace() throws Exception {
    try (Farm farm = new Farm(0)) {
      LimitExceeded refusal = catchThrowableOfType(LimitExceeded.class, () -> farm.session(""));
      assertThat(refusal.code).isEqualTo("S-012");
      farm.host("h", 1);
      assertThat(farm.session("").hostName()).isEqualTo("h");
    }
  }

  @Test
  void sessionIsFoundOnWhicheverHostItIs() throws Exception {
    try (Farm farm = new Farm(1)) {
      farm.host("h", 1);
      for (String host : List.of("h", "own")) {
        MechSim session = farm.session(host);
        MechSim found = farm.service.findSession(session.sessionId());
        assertThat(found.hostName()).isEqualTo(host);
      }
      NotFound refusal =
          catchThrowableOfType(NotFound.class, () -> farm.service.findSession("none"));
      assertThat(refusal.code).isEqualTo("S-011");
    }
  }

  @Test
  void twoClientsAtOnceDoNotMeet() throws Exception {
    try (Farm farm = new Farm(2);
        ServiceOrb other = ServiceOrb.client()) {
      MechSim first = farm.session("");
      MechSim second = other.connect(farm.server.url()).createSession("other", "", null);
      var runOfFirst = Farm.running(first);
      var runOfSecond = Farm.running(second);
      runOfFirst.cancel();
      first.destroy();
      Eventually.holds(() -> runOfSecond.getProgress().state == SimState.SIM_RUNNING);
    }
  }

  private static String placed(Farm farm, String client) throws Exception {
    return farm.service.createSession(client, "", null).hostName();
  }

  @Test
  void orderFillsOneHostAfterTheOtherAsTheyJoined() throws Exception {
    try (Farm farm = new Farm(1)) {
      farm.host("z", 2);
      farm.host("a", 1);
      farm.admin.setPlacement("order");
      assertThat(
              List.of(placed(farm, "1"), placed(farm, "2"), placed(farm, "3"), placed(farm, "4")))
          .containsExactly("own", "z", "z", "a");
      assertThat(placed(farm, "5")).as("all are full: the first again").isEqualTo("own");
    }
  }

  @Test
  void pinnedClientStaysWhereItWasAsLongAsThatTakesIt() throws Exception {
    try (Farm farm = new Farm(1)) {
      farm.host("h", 3);
      farm.admin.setPlacement("pinned");
      assertThat(placed(farm, "ann")).isEqualTo("h");
      farm.host("larger", 9);
      assertThat(placed(farm, "bob")).isEqualTo("larger");
      assertThat(placed(farm, "ann")).isEqualTo("h");
      farm.admin.drain("h");
      assertThat(placed(farm, "ann")).isEqualTo("larger");
      farm.admin.undrain("h");
      assertThat(placed(farm, "ann")).as("where it was last").isEqualTo("larger");
    }
  }
}
