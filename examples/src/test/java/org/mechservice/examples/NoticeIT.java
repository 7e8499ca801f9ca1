package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** NOTICE lists exactly the dependencies. */
class NoticeIT {
  private static final Pattern LIBRARY = Pattern.compile("(?<![\\w-])[a-z][\\w-]* \\d[\\w.]*");

  @Test
  void namesEveryLibraryWithItsVersion() throws IOException {
    List<String> libraries =
        fetched(
            Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator))
                .map(path -> new File(path).getName()));

    assertThat(libraries).isNotEmpty();
    assertThat(notice()).contains(libraries);
  }

  @Test
  void productRunsWithTheLibrariesThatNoticeNamesAsItsOwnAndNoOthers() throws IOException {
    List<String> besideTheCommand;
    try (Stream<Path> lib = Files.list(WorkingTree.TOP.resolve("mechcli/target/lib"))) {
      besideTheCommand = fetched(lib.map(jar -> jar.getFileName().toString()));
    }
    String named = notice();
    String ofTheProduct =
        named.substring(
            named.indexOf("Libraries the product runs with"),
            named.indexOf("What each of them is for"));

    assertThat(besideTheCommand)
        .containsExactlyInAnyOrderElementsOf(
            LIBRARY.matcher(ofTheProduct).results().map(match -> match.group()).toList());
  }

  @Test
  void eachLibraryOfTheProductHasItsReason() throws IOException {
    String all = notice();
    String libraries =
        all.substring(
            all.indexOf("Libraries the product runs with"),
            all.indexOf("What each of them is for"));
    String reasons =
        all.substring(all.indexOf("What each of them is for"), all.indexOf("A build compares"));
    List<String> names =
        libraries
            .lines()
            .skip(1)
            .filter(line -> line.startsWith("  ") && !line.startsWith("   "))
            .map(line -> line.strip().split(":| \\d", 2)[0])
            .toList();
    assertThat(names).hasSizeGreaterThan(10);
    assertThat(names).allSatisfy(name -> assertThat(reasons).contains(name));
  }

  private static String notice() throws IOException {
    return Files.readString(WorkingTree.TOP.resolve("NOTICE"));
  }

  /** Returns name and version of those JARs that are not modules of this project. */
  private static List<String> fetched(Stream<String> files) throws IOException {
    Set<String> modules;
    try (Stream<Path> poms =
        Files.find(WorkingTree.TOP, 3, (file, attributes) -> file.endsWith("pom.xml"))) {
      modules =
          poms.map(pom -> String.valueOf(pom.resolveSibling(".").normalize().getFileName()))
              .collect(Collectors.toSet());
    }
    return files
        .filter(name -> name.endsWith(".jar"))
        .filter(name -> !modules.contains(name.replaceFirst("(-[0-9].*)?\\.jar$", "")))
        .map(name -> name.replaceFirst("-([0-9][^-]*)\\.jar$", " $1"))
        .toList();
  }
}
