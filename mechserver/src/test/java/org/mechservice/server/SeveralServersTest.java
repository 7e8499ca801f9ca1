package org.mechservice.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.MechSim;
import org.mechservice.orb.ServiceUnreachableException;
import org.mechservice.orb.testing.Eventually;
import org.mechservice.sim.host.HostOptions;
import org.mechservice.sim.host.HostSettings;
import org.mechservice.sim.host.SimHostProcess;
import org.mechservice.sim.service.testing.PacedSolver;

/**
 * Servers side by side with one host between them.
 *
 * <pre>
 *   first    second
 *       \\   /
 *       shared
 * </pre>
 */
@Tag("slow")
class SeveralServersTest {
  private static SimHostProcess shared(List<String> urls) {
    return SimHostProcess.start(
        new HostSettings(urls, "127.0.0.1", 0, new HostOptions("shared", 4)),
        PacedSolver.endless());
  }

  private static boolean knows(Farm farm, String host) throws Exception {
    return Arrays.stream(farm.admin.listHosts())
        .anyMatch(known -> known.info.name.equals(host) && known.reachable);
  }

  @Test
  void hostServesAllItsServersAndOutlivesEachOfThem() throws Exception {
    try (Farm second = new Farm(0)) {
      SimHostProcess host;
      try (Farm first = new Farm(0)) {
        host = shared(List.of(first.server.url(), second.server.url()));
        assertThat(first.session("").hostName()).isEqualTo("shared");
      }
      try {
        MechSim session = second.session("");
        assertThat(session.hostName()).isEqualTo("shared");
        IMechSimRemote run = Farm.running(session);
        Eventually.holds(() -> run.getProgress().rowsReady > 0);
        Eventually.holds(() -> second.admin.getStatus().sessions == 2);
      } finally {
        host.close();
      }
    }
  }

  @Test
  void hostJoinsAServerThatStartsLater() throws Exception {
    int port;
    try (Farm gone = new Farm(0)) {
      port = Integer.parseInt(gone.server.url().replaceAll(".*:(\\d+)/.*", "$1"));
    }
    try (Farm present = new Farm(0);
        SimHostProcess host = shared(List.of("127.0.0.1:" + port, present.server.url()))) {
      assertThat(knows(present, "shared")).isTrue();
      try (MechServerProcess late =
          MechServerProcess.start(
              new ServerSettings("late", "127.0.0.1", port, 0), Farm.STEADY, Farm.ENDLESS_HOST)) {
        Eventually.holds(
            () ->
                Arrays.stream(present.orb.connectAdmin(late.url()).listHosts())
                    .anyMatch(known -> known.info.address.equals(host.address())));
      }
    }
  }

  @Test
  void hostWithoutAnyServerDoesNotStart() {
    assertThatThrownBy(() -> shared(List.of("127.0.0.1:1", "127.0.0.1:2")))
        .isInstanceOf(ServiceUnreachableException.class)
        .hasMessageStartingWith("S-002")
        .hasMessageContaining("127.0.0.1:1");
  }
}
