package org.mechservice.cli.shell;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;

class SafeWriterTest {
  private static String written(String text) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    SafeWriter writer = new SafeWriter(bytes);
    writer.print(text);
    writer.flush();
    return bytes.toString(StandardCharsets.UTF_8);
  }

  @Test
  void controlCharactersBecomeQuestionMarks() {
    assertThat(written("\u001b[2Jgone")).isEqualTo("?[2Jgone");
    assertThat(written("\u001b]0;title\u0007")).isEqualTo("?]0;title?");
    assertThat(written("\u009b31mred")).isEqualTo("?31mred");
    assertThat(written("hidden\rshown")).isEqualTo("hidden?shown");
    assertThat(written("a\u0000b\u007fc\bd")).isEqualTo("a?b?c?d");
    assertThat(written("a\u202eb")).isEqualTo("a?b");
  }

  @Test
  void textLinesTabsAndColoursStay() {
    for (String text :
        List.of(
            "Größe 3 µs → 4\r\n",
            "two\nlines",
            "a\tb",
            "\u001b[1;31mred\u001b[0m",
            "\uD83D\uDE00")) {
      assertThat(written(text)).isEqualTo(text);
    }
  }
}
