package org.mechservice.sim.service;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;

class CheckReportsTest {
  private final CheckReports reports = new CheckReports();

  private static RunIdentity run(String simId, String text) {
    return new RunIdentity(
        simId, "session", "host", "ann", "model", "model.xml", text, 0, List.of());
  }

  private static String model(String name) throws Exception {
    return Files.readString(Path.of("../../examples/pendulum/pendulum.xml"))
        .replace("FiveBarPendulum", name);
  }

  @Test
  void reportOfAModelIsComputedOnceForAllItsRuns() throws Exception {
    String first = reports.of(run("a", model("One")));
    assertThat(first).startsWith("{").contains("One");
    assertThat(reports.of(run("b", model("One")))).isSameAs(first);
  }

  @Test
  void everyModelHasItsOwn() throws Exception {
    String first = reports.of(run("a", model("One")));
    for (int i = 0; i < 40; i++) {
      assertThat(reports.of(run("b", model("Model" + i)))).contains("Model" + i);
    }
    assertThat(reports.of(run("a", model("One")))).isEqualTo(first).isNotSameAs(first);
  }

  @Test
  void modelWhoseTextIsNotKeptOrCannotBeReadHasNone() {
    assertThat(reports.of(run("a", ""))).isEmpty();
    assertThat(reports.of(run("a", "no model"))).isEmpty();
  }
}
