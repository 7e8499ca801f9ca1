package org.mechservice.sim.service.library;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class CheckReportsTest {
  private final ModelLibrary library = new ModelLibrary();

  @AfterEach
  void close() {
    library.close();
  }

  private String report(String text) {
    return library.checkReport("model.xml", text);
  }

  private static String model(String name) throws Exception {
    return Files.readString(Path.of("../../examples/pendulum/pendulum.xml"))
        .replace("FiveBarPendulum", name);
  }

  @Test
  void reportOfAModelIsComputedOnceForAllItsRuns() throws Exception {
    String first = report(model("One"));
    assertThat(first).startsWith("{").contains("One");
    assertThat(report(model("One"))).isSameAs(first);
  }

  @Test
  void everyModelHasItsOwn() throws Exception {
    String first = report(model("One"));
    for (int i = 0; i < 40; i++) {
      assertThat(report(model("Model" + i))).contains("Model" + i);
    }
    assertThat(report(model("One"))).isEqualTo(first).isNotSameAs(first);
  }

  @Test
  void modelWhoseTextIsNotKeptOrCannotBeReadHasNone() {
    assertThat(report("")).isEmpty();
    assertThat(report("no model")).isEmpty();
  }
}
