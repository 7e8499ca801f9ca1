package org.mechservice.sim.packaging;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Sizes and speed of generated code; the soak run writes them to a page of docs/reports. */
class GeneratedCodePageTest {
  private static final Path PAGE = Path.of("..", "..", "docs", "reports", "generated-code.md");

  @TempDir private Path folder = Path.of("");

  static Stream<CodeSizes.Row> bounded() {
    return CodeSizes.ROWS.stream().filter(row -> row.bound() != Integer.MAX_VALUE);
  }

  @ParameterizedTest
  @MethodSource("bounded")
  void aModelIsNoLargerThanItMayBe(CodeSizes.Row row) throws Exception {
    JarImage jar = CodeSizes.jar(CodeSizes.built(row));
    assertThat(jar.modelBytes()).isLessThanOrEqualTo(row.bound());
    assertThat(jar.bytes().length - jar.modelBytes()).isLessThanOrEqualTo(CodeSizes.OVERHEAD);
  }

  @Tag("soak")
  @Test
  void pageOfSizesAndSpeed() throws Exception {
    List<String> lines = new ArrayList<>();
    lines.add("# Generated code: sizes and speed");
    lines.add("");
    lines.add(
        String.format(
            Locale.ROOT,
            "Measured on %s by `mvn verify -Psoak`: %s %s, %d cores at load %.0f, Java %s.",
            LocalDate.now(ZoneOffset.UTC),
            System.getProperty("os.name"),
            System.getProperty("os.arch"),
            Runtime.getRuntime().availableProcessors(),
            ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage(),
            System.getProperty("java.version")));
    lines.add("");
    lines.addAll(new CodeSizes().lines());
    lines.add("");
    lines.addAll(new CodeSpeeds(folder).lines());
    Files.writeString(PAGE, String.join("\n", lines) + "\n");
  }
}
