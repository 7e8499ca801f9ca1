package org.mechservice.client;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;

/** Shares of what the client waits for are told apart by the server's own times. */
final class SetUpReportTest {
  private static final ServerTimes RUN = new ServerTimes(0.125, 0.5, 0.0625);

  @Test
  void whatIsNeitherTreatingNorCompilingIsMakingAndFetchingJars() {
    Map<String, Object> times = SetUpReport.local(1, 2, RUN, 4);

    assertThat(times)
        .containsEntry("t1c", 1.125)
        .containsEntry("t1s", 0.125)
        .containsEntry("tcc", 0.5)
        .containsEntry("t2c", 1.375)
        .containsEntry("t2s", 0.0625)
        .containsEntry("tL", 4.0);
  }

  @Test
  void makingJarsTakesTheClientAsLongAsTheServerIfTheModelWasTreatedBeforehand() {
    Map<String, Object> times = SetUpReport.local(1, 0.25, RUN, 4);

    assertThat(times).containsEntry("t2c", 0.0625).containsEntry("t1c", 1.0);
  }
}
