package org.mechservice.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collector;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.provider.CsvSource;

/** The picture of modules and packages in CONTRIBUTING.md is the one in the code. */
@Tag("slow")
class ContributingTest {
  private static final String ROOT = "org.mechservice.";
  private static final Pattern EDGE = Pattern.compile("(?m)^  ([\\w-]+) --> ([\\w-]+)$");
  private static final Pattern MODULE = Pattern.compile("(?m)^\\| `([\\w-]+)` \\| ([^|]*) \\|$");
  private static final Pattern PACKAGE =
      Pattern.compile("(?m)^\\| `([\\w.]+)` \\| `([\\w-]+)` \\| \\S.* \\|$");
  private static final Pattern NAME = Pattern.compile("`([\\w-]+)`");

  private static String layout() throws IOException {
    return Files.readString(Path.of("..", "CONTRIBUTING.md"))
        .split("\n## Layout\n", 2)[1]
        .split("\n## ", 2)[0];
  }

  @Test
  void tableOfPackagesNamesThePackagesOfTheProduct() throws IOException {
    Set<String> named = PACKAGE.matcher(layout()).results().map(r -> r.group(1)).collect(treeSet());
    Set<String> inCode =
        ArchitectureTest.PRODUCT.stream()
            .map(JavaClass::getPackageName)
            .map(name -> name.substring(ROOT.length()))
            // The IDL compiler adds one package for the nested types of each interface.
            .filter(name -> !name.startsWith("idl."))
            .collect(treeSet());
    assertThat(named).isEqualTo(inCode);
  }

  @Test
  void everyPackageStandsBesideItsModule() throws IOException {
    List<MatchResult> rows = PACKAGE.matcher(layout()).results().toList();
    assertThat(rows).isNotEmpty();
    for (MatchResult row : rows) {
      assertThat(ArchitectureTest.moduleOf(row.group(1))).as(row.group(1)).isEqualTo(row.group(2));
    }
  }

  @Test
  void tableOfModulesIsTheOneThatTheArchitectureTestEnforces() throws Exception {
    assertThat(modulesOfThePage()).isEqualTo(modulesOfTheTest());
  }

  @Test
  void picturesArrowsLeadToExactlyTheAllowedModules() throws Exception {
    Map<String, Set<String>> arrows = new TreeMap<>();
    EDGE.matcher(layout())
        .results()
        .forEach(e -> arrows.computeIfAbsent(e.group(1), k -> new TreeSet<>()).add(e.group(2)));
    Map<String, Set<String>> allowed = modulesOfTheTest();
    arrows.forEach(
        (module, targets) -> {
          if (!module.equals("mechcli")) {
            assertThat(allowed.get(module)).as(module).containsAll(targets);
          }
        });
    allowed.forEach(
        (module, targets) -> assertThat(reached(module, arrows)).as(module).containsAll(targets));
    assertThat(reached("mechcli", arrows)).isEqualTo(allowed.keySet());
  }

  private static Map<String, Set<String>> modulesOfThePage() throws IOException {
    Map<String, Set<String>> modules = new TreeMap<>();
    String table = layout().split("\n### Packages\n", 2)[0];
    for (MatchResult row : MODULE.matcher(table).results().toList()) {
      modules.put(
          row.group(1),
          NAME.matcher(row.group(2)).results().map(r -> r.group(1)).collect(treeSet()));
    }
    return modules;
  }

  private static Map<String, Set<String>> modulesOfTheTest() throws NoSuchMethodException {
    CsvSource rows =
        Objects.requireNonNull(
            ArchitectureTest.class
                .getDeclaredMethod(
                    "moduleDependsOnlyOnTheModulesTheDesignAllows", String.class, String.class)
                .getAnnotation(CsvSource.class));
    Map<String, Set<String>> modules = new TreeMap<>();
    for (String row : rows.value()) {
      String[] columns = row.split(",", 2);
      modules.put(
          columns[0].strip(),
          Arrays.stream(columns[1].replace("'", "").strip().split(" ", -1))
              .filter(name -> !name.isEmpty())
              .collect(treeSet()));
    }
    return modules;
  }

  private static Set<String> reached(String from, Map<String, Set<String>> arrows) {
    Set<String> reached = new TreeSet<>();
    Deque<String> open = new ArrayDeque<>(arrows.getOrDefault(from, Set.of()));
    while (!open.isEmpty()) {
      String module = open.remove();
      if (reached.add(module)) {
        open.addAll(arrows.getOrDefault(module, Set.of()));
      }
    }
    return reached;
  }

  private static Collector<String, ?, Set<String>> treeSet() {
    return Collectors.toCollection(TreeSet::new);
  }
}
