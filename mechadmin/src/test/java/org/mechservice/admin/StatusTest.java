package org.mechservice.admin;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
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

class StatusTest {
  private static final Instant NOW = Instant.parse("2026-01-02T03:04:05Z");
  private static final String SILENT_ADDRESS = "10.0.0.9:15000";

  private final List<ServerReading> readings =
      List.of(
          new ServerReading.Answering(
              "localhost:15000",
              new ServerStatus(
                  new ServerInfo("lab", "1.0", "0.1.0", at(Duration.ofMinutes(125)), new String[0]),
                  false,
                  1,
                  2,
                  1,
                  0,
                  new NameValue[0]),
              List.of(host("big")),
              List.of(simulation("pendulum"))),
          new ServerReading.Silent(SILENT_ADDRESS, "S-032 no answer in time"));

  @Test
  void tablesShowServersHostsAndRunningSimulations() {
    assertThat(new StatusText(NOW).all(readings))
        .isEqualTo(
            """
            SERVER  ADDRESS          STATE      UP         HOSTS  SESSIONS  RUNNING  QUEUED  VERSION  CERTIFICATE
            lab     localhost:15000  up         2 h 5 min  1      2         1        0       0.1.0
            -       10.0.0.9:15000   no answer

            HOST  SERVER  ADDRESS     STATE  CORES  RUNNING  QUEUED  CPU   MEMORY  USER CODE  CERTIFICATE             LAST MESSAGE
            big   lab     10.0.0.2:7  up     8      1 of 4   0       25 %  3 MiB   confined   2026-01-12 (10 d left)

            SIMULATION  HOST  MODEL     OWNER  STATE    TIME              STEPS  STEP SIZE  X REAL TIME  AGE   LAST MESSAGE
            s1          big   pendulum  ann    running  1.500 of 3.000 s  42     0.001000   1000         10 s  step by step
            """);
  }

  @Test
  void hostThatIsSilentSaysSinceWhenAndServerThatRefusesIsNotSilent() {
    HostStatus silent = host("big");
    silent.reachable = false;
    silent.text = "silent since 2026-01-02T03:04:05Z: no answer within 2 s";
    List<ServerReading> reading =
        List.of(
            new ServerReading.Answering(
                "a",
                ((ServerReading.Answering) readings.get(0)).status(),
                List.of(silent),
                List.of()),
            new ServerReading.Silent("b", "S-153 not yours", true));
    assertThat(new StatusText(NOW).all(reading))
        .containsPattern(
            "big .* no answer .* 3 MiB +confined +2026-01-12 \\(10 d left\\) +silent since"
                + " 2026-01-02T03:04:05Z: no answer")
        .containsPattern("- +b +refused");
  }

  @Test
  void namesCannotSteerTheTerminal() {
    String hostile = "\u001b[2Jgone\r\n";
    List<ServerReading> reading =
        List.of(
            new ServerReading.Answering(
                "a",
                ((ServerReading.Answering) readings.get(0)).status(),
                List.of(),
                List.of(simulation(hostile))));
    assertThat(new StatusText(NOW).all(reading)).contains("?[2Jgone??").doesNotContain("\u001b");
  }

  @Test
  void jsonHasTheSameFacts() {
    assertThat(AdminJson.text(AdminJson.status(readings)))
        .contains("\"name\": \"lab\"")
        .contains("\"startedAt\": \"2026-01-02T00:59:05Z\"")
        .contains("\"model\": \"pendulum\"")
        .contains("\"cpuLoad\": 0.25")
        .contains("\"answers\": false,\n      \"problem\": \"S-032 no answer in time\"");
  }

  private static long at(Duration ago) {
    return NOW.minus(ago).toEpochMilli();
  }

  private static final NameValue[] USER_CODE = {
    new NameValue("userCode", "confined: bubblewrap with a filter of system calls"),
    new NameValue("certificateExpires", Long.toString(NOW.plus(Duration.ofDays(10)).toEpochMilli()))
  };

  private static HostStatus host(String name) {
    HostInfo info = new HostInfo(name, "0.1.0", "10.0.0.2:7", 8, 1L << 33, 4, at(Duration.ZERO));
    HostLoad load = new HostLoad(2, 1, 0, 0.25, 3 << 20, false, USER_CODE);
    return new HostStatus(info, load, true, at(Duration.ZERO), "");
  }

  private static SimSummary simulation(String model) {
    Progress progress =
        new Progress("s1", SimState.SIM_RUNNING, 0, 1.5, 0, 3, 42, 1e-3, 5, 1000, 150);
    long created = at(Duration.ofSeconds(10));
    return new SimSummary(
        "s1", "x", "big", model, "ann", progress, created, created, 0, created, "step by step");
  }
}
