package org.mechservice.admin;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.mechservice.idl.HostInfo;
import org.mechservice.idl.HostLoad;
import org.mechservice.idl.HostStatus;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.Progress;
import org.mechservice.idl.ServerInfo;
import org.mechservice.idl.ServerStatus;
import org.mechservice.idl.SimState;
import org.mechservice.idl.SimSummary;

/**
 * What is meant by the names an operator types.
 *
 * <pre>
 * a:1  lab   hosts lab, shared (at h:7)      simulations 1111-a, 1111-b, 2222-c (lost)
 * b:1  west  hosts shared (at h:7), twin     simulations 2222-c
 * c:1  east  host twin
 * d:1  (silent)
 * </pre>
 */
class NamesTest {
  private final List<ServerReading> readings =
      List.of(
          answering(
              "a:1",
              "lab",
              List.of(host("lab", "a:1"), host("shared", "h:7")),
              List.of(
                  simulation("1111-a", "running"),
                  simulation("1111-b", "running"),
                  simulation("2222-c", "S-113 the simulation was lost with host shared"))),
          answering(
              "b:1",
              "west",
              List.of(host("shared", "h:7"), host("twin", "h:8")),
              List.of(simulation("2222-c", "running"))),
          answering("c:1", "east", List.of(host("twin", "h:9")), List.of()),
          new ServerReading.Silent("d:1", "S-032"));

  private static ServerReading answering(
      String address, String name, List<HostStatus> hosts, List<SimSummary> simulations) {
    ServerInfo info = new ServerInfo(name, "1.0", "0.1.0", 0, new String[0]);
    ServerStatus status = new ServerStatus(info, false, 0, 0, 0, 0, new NameValue[0]);
    return new ServerReading.Answering(address, status, hosts, simulations);
  }

  private static HostStatus host(String name, String address) {
    HostInfo info = new HostInfo(name, "0.1.0", address, 1, 1, 1, 0);
    HostLoad load = new HostLoad(0, 0, 0, 0, 0, false, new NameValue[0]);
    return new HostStatus(info, load, true, 0, "");
  }

  private static SimSummary simulation(String id, String text) {
    Progress progress = new Progress(id, SimState.SIM_RUNNING, 0, 0, 0, 1, 0, 0, 0, 0, 0);
    return new SimSummary(id, "", "", "", "", progress, 0, 0, 0, 0, text);
  }

  @Test
  void serverIsMeantByItsNameOrAddress() {
    assertThat(AdminTarget.named(readings, "west")).isEqualTo(new AdminTarget("b:1", ""));
    assertThat(AdminTarget.named(readings, "c:1")).isEqualTo(new AdminTarget("c:1", ""));
    assertThat(AdminTarget.named(readings, "server:d:1")).isEqualTo(new AdminTarget("d:1", ""));
  }

  @Test
  void hostOfSeveralServersIsOneHost() {
    assertThat(AdminTarget.named(readings, "shared")).isEqualTo(new AdminTarget("a:1", "shared"));
  }

  @Test
  void nameOfServerAndHostMustBeToldApart() {
    assertThatThrownBy(() -> AdminTarget.named(readings, "lab"))
        .hasMessage(
            "S-131 lab may be the server at a:1 or host lab of the server at a:1;"
                + " write host:NAME or server:NAME, and name one server with --server");
    assertThat(AdminTarget.named(readings, "server:lab")).isEqualTo(new AdminTarget("a:1", ""));
    assertThat(AdminTarget.named(readings, "host:lab")).isEqualTo(new AdminTarget("a:1", "lab"));
  }

  @Test
  void hostsOfOneNameAtTwoServersMustBeToldApart() {
    assertThatThrownBy(() -> AdminTarget.named(readings, "twin")).hasMessageStartingWith("S-131 ");
  }

  @Test
  void unknownNameGetsTheKnownOnesAndWhoWasSilent() {
    assertThatThrownBy(() -> AdminTarget.named(readings, "no\u001b[2J"))
        .hasMessage(
            "S-130 there is no server or host no?[2J;"
                + " there are lab, shared, west, twin, east, d:1; no answer from d:1");
  }

  @Test
  void simulationIsMeantByTheFirstCharactersOfItsId() {
    assertThat(KnownSimulation.find(readings, "1111-a").summary().simId).isEqualTo("1111-a");
    assertThat(KnownSimulation.find(readings, "2222").server()).isEqualTo("b:1");
    assertThatThrownBy(() -> KnownSimulation.find(readings, "1111"))
        .hasMessageStartingWith("S-131 2 simulations ");
    assertThatThrownBy(() -> KnownSimulation.find(readings, "222"))
        .hasMessageStartingWith("S-130 there is no simulation 222; no answer from d:1");
  }

  @Test
  void simulationOfAHostOfTwoServersIsListedOnceAsTheBetterInformedSaysIt() {
    assertThat(KnownSimulation.all(readings))
        .extracting(known -> known.summary().simId + " " + known.server())
        .containsExactly("1111-a a:1", "1111-b a:1", "2222-c b:1");
  }

  @Test
  void commandLinesAreQuotedForTheShell() {
    assertThat(new AdminAction.StopSimulation("s1", "it's; rm -rf /").commandLine("h:1"))
        .isEqualTo("mech admin --server h:1 stop s1 --reason 'it'\\''s; rm -rf /'");
    assertThat(new AdminAction.SetLimits("lab", Map.of("queue", 3L, "lease", -1L)).commandLine("h"))
        .isEqualTo("mech admin --server h limits --host lab lease=-1 queue=3");
  }
}
