package org.mechservice.mechml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Random damage to a good file: it is read or refused with a message, nothing else happens. */
class MutatedFileTest {
  private static final Duration PATIENCE = Duration.ofMinutes(5);
  private static final int FILES = 1500;

  /** Words that mean something somewhere in a file. */
  private static final List<String> WORDS =
      List.of(
          "<",
          ">",
          "/>",
          "</",
          "\"",
          "'",
          "&",
          "&amp;",
          "&#0;",
          "&x;",
          "<!--",
          "-->",
          "<![CDATA[",
          "]]>",
          "<?x?>",
          "<!DOCTYPE MechML>",
          "\u0000",
          "\uFFFE",
          "\uD83D\uDE00",
          "1e999",
          "NaN",
          "Infinity",
          "-1",
          "1/0",
          "(((",
          "1e-320",
          "unit=\"deg\"",
          "unit=\"kg\"",
          "type=\"F\"",
          "vector2=\"u1\"",
          "name=\"\"",
          "name=\"Ground\"",
          "<body/>",
          "<joint/>",
          ";",
          "PI",
          "^^",
          "sqrt(",
          "'",
          "1e5000000000",
          "9".repeat(400));

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4})
  void damagedFilesAreReadOrRefusedWithAMessage(long seed) throws IOException {
    byte[] original = Resources.bytes("FiveBarPendulum.xml");
    Random random = new Random(seed);
    assertTimeoutPreemptively(
        PATIENCE,
        () -> {
          for (int i = 0; i < FILES; i++) {
            readOrRefuse(damaged(original, random));
          }
        });
  }

  private static void readOrRefuse(byte[] content) {
    try {
      MechmlModel model = MechmlReader.read("damaged.xml", content);
      assertThat(initialState(model)).allMatch(Double::isFinite);
    } catch (MechmlException e) {
      assertThat(e.diagnostics()).anyMatch(d -> d.severity() == Severity.ERROR);
      assertThat(e.diagnostics())
          .allSatisfy(d -> assertThat(d.message()).isNotBlank().doesNotContain("\n", "MSG_"));
    } catch (RuntimeException | Error e) {
      throw new AssertionError(new String(content, StandardCharsets.UTF_8), e);
    }
  }

  private static List<Double> initialState(MechmlModel model) {
    double[] y = new double[model.mechanism().positionCount() + model.mechanism().velocityCount()];
    model.mechanism().initialState(y);
    return Arrays.stream(y).boxed().toList();
  }

  private static byte[] damaged(byte[] original, Random random) {
    byte[] content = original;
    for (int k = random.nextInt(1, 5); k > 0; k--) {
      content = damagedOnce(content, random);
    }
    return content;
  }

  private static byte[] damagedOnce(byte[] content, Random random) {
    int from = random.nextInt(content.length);
    int to = Math.min(content.length, from + random.nextInt(60));
    return switch (random.nextInt(5)) {
      case 0 -> spliced(content, from, to, new byte[0]);
      case 1 -> spliced(content, from, from, Arrays.copyOfRange(content, from, to));
      case 2 -> spliced(content, from, Math.min(content.length, from + 1), randomByte(random));
      case 3 -> spliced(content, from, from, word(random));
      default -> valueReplaced(content, from, random);
    };
  }

  private static byte[] randomByte(Random random) {
    return new byte[] {(byte) random.nextInt(256)};
  }

  private static byte[] word(Random random) {
    return WORDS.get(random.nextInt(WORDS.size())).getBytes(StandardCharsets.UTF_8);
  }

  /** Replaces the next attribute's value, which leaves the file well-formed more often. */
  private static byte[] valueReplaced(byte[] content, int from, Random random) {
    String text = new String(content, StandardCharsets.ISO_8859_1);
    int open = text.indexOf('"', from);
    int close = text.indexOf('"', open + 1);
    return open < 0 || close < 0 ? content : spliced(content, open + 1, close, word(random));
  }

  private static byte[] spliced(byte[] content, int from, int to, byte[] inserted) {
    byte[] result = new byte[content.length - (to - from) + inserted.length];
    System.arraycopy(content, 0, result, 0, from);
    System.arraycopy(inserted, 0, result, from, inserted.length);
    System.arraycopy(content, to, result, from + inserted.length, content.length - to);
    return result;
  }
}
