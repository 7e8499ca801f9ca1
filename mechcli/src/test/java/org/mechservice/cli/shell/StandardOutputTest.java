package org.mechservice.cli.shell;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

class StandardOutputTest {
  private static StandardOutput writtenTo(String failure) {
    OutputStream refusing =
        new OutputStream() {
          @Override
          public void write(int b) throws IOException {
            throw new IOException(failure);
          }
        };
    StandardOutput out = new StandardOutput(refusing);
    new PrintWriter(out, true, StandardCharsets.UTF_8).println("{}");
    return out;
  }

  @Test
  void outputThatIsLostIsTold() {
    assertThat(writtenTo("No space left on device").failure()).contains("No space left on device");
  }

  @Test
  void readerWhoHasReadEnoughMissesNothing() {
    assertThat(writtenTo("Broken pipe").failure()).isEmpty();
  }

  @Test
  void whatIsWrittenIsNoTrouble() {
    assertThat(new StandardOutput(OutputStream.nullOutputStream()).failure()).isEmpty();
  }
}
