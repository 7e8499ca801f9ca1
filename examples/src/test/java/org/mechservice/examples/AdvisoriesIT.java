package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** No library has an advisory of the stored list that a later version mends. Needs no network. */
class AdvisoriesIT {
  private static final Path LIST = WorkingTree.TOP.resolve("dist/advisories.tsv");
  private static final Pattern JAR = Pattern.compile("(.+?)-(\\d[\\w.-]*)\\.jar");

  private record Advisory(String id, String library, String from, String mended, String what) {
    boolean concerns(String version) {
      return compared(version, from) >= 0 && compared(version, mended) < 0;
    }
  }

  private static List<Advisory> advisories() throws IOException {
    return Files.readAllLines(LIST).stream()
        .filter(line -> !line.startsWith("#"))
        .map(line -> line.split("\t", -1))
        .map(cells -> new Advisory(cells[0], cells[1], cells[2], cells[3], cells[4]))
        .toList();
  }

  /** Compares versions by their numbers, from the first on. */
  private static int compared(String one, String other) {
    int[] a = numbers(one);
    int[] b = numbers(other);
    for (int i = 0; i < Math.max(a.length, b.length); i++) {
      int difference = Integer.compare(i < a.length ? a[i] : 0, i < b.length ? b[i] : 0);
      if (difference != 0) {
        return difference;
      }
    }
    return 0;
  }

  private static int[] numbers(String version) {
    return Pattern.compile("\\d{1,9}")
        .matcher(version)
        .results()
        .mapToInt(found -> Integer.parseInt(found.group()))
        .toArray();
  }

  @CsvSource({"1.5.38, 1.5.25, 1", "1.5.9, 1.5.13, -1", "2.12.2, 2.12.2, 0", "1.87, 1.9, 1"})
  @ParameterizedTest
  void versionsAreComparedByTheirNumbers(String one, String other, int sign) {
    assertThat(Integer.signum(compared(one, other))).isEqualTo(sign);
  }

  @Test
  void noLibraryHasAnAdvisoryThatIsMended() throws IOException {
    Map<String, String> versions = versions();
    assertThat(versions).containsKeys("jacorb", "logback-core", "bcprov-jdk18on", "assertj-core");
    List<Advisory> known = advisories();
    assertThat(known).hasSizeGreaterThan(20);
    assertThat(known)
        .filteredOn(one -> versions.containsKey(one.library()))
        .hasSizeGreaterThan(15)
        .noneMatch(one -> one.concerns(versions.getOrDefault(one.library(), "")));
  }

  @Test
  void libraryBeforeItsMendedVersionWouldBeFound() throws IOException {
    assertThat(advisories())
        .filteredOn(one -> one.library().equals("logback-core"))
        .anyMatch(one -> one.concerns("1.5.21"));
  }

  /** Returns the versions of what the product runs with, and of what its tests do. */
  private static Map<String, String> versions() throws IOException {
    Map<String, String> versions = new TreeMap<>();
    try (Stream<Path> lib = Files.list(WorkingTree.TOP.resolve("mechcli/target/lib"))) {
      Stream<String> tests =
          Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator))
              .map(path -> new File(path).getName());
      Stream.concat(lib.map(jar -> jar.getFileName().toString()), tests)
          .map(JAR::matcher)
          .filter(Matcher::matches)
          .forEach(jar -> versions.put(jar.group(1), jar.group(2)));
    }
    return versions;
  }
}
