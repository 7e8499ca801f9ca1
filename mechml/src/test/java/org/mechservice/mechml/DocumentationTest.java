package org.mechservice.mechml;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.mechml.expression.Function;
import org.mechservice.mechml.unit.UnitSymbols;

/** The user guide says what the reader does, and its examples run. */
class DocumentationTest {
  private static final Pattern EXAMPLE = Pattern.compile("```xml\n(.*?)```", Pattern.DOTALL);
  private static final Pattern ELEMENT = Pattern.compile("<!ELEMENT (\\w+)");
  private static final Pattern ATTRIBUTE = Pattern.compile("\n  (\\w+) +(?:CDATA|\\()");
  private static final Pattern WORD = Pattern.compile("[A-Za-z_][A-Za-z0-9_]*");

  private static String guide() throws IOException {
    return Files.readString(Path.of("..", "docs", "mechml.md"));
  }

  private static List<String> blocks() throws IOException {
    return EXAMPLE.matcher(guide()).results().map(e -> e.group(1)).toList();
  }

  static Stream<String> examples() throws IOException {
    List<String> blocks = blocks();
    return Stream.concat(
        Stream.of(blocks.get(0)),
        blocks.stream().skip(1).map(part -> new ExampleFile(blocks.get(0)).with(part)));
  }

  @ParameterizedTest
  @MethodSource("examples")
  void exampleOfTheGuideIsReadWithoutAWarning(String file) throws Exception {
    MechmlModel model = MechmlReader.read("guide.xml", file.getBytes(StandardCharsets.UTF_8));
    assertThat(model.warnings()).isEmpty();
    assertThat(model.mechanism().bodies()).hasSize(2);
  }

  @Test
  void everyElementStandsInAnExample() throws IOException {
    Matcher element = ELEMENT.matcher(Files.readString(Path.of("..", "mechml.dtd")));
    String all = examples().collect(Collectors.joining());
    assertThat(element.results().map(e -> e.group(1)))
        .allSatisfy(name -> assertThat(all).contains("<" + name));
  }

  @Test
  void guideNamesEveryElementAndAttribute() throws IOException {
    String grammar = Files.readString(Path.of("..", "mechml.dtd"));
    Set<String> words =
        WORD.matcher(guide()).results().map(w -> w.group()).collect(Collectors.toSet());
    assertThat(words)
        .containsAll(ELEMENT.matcher(grammar).results().map(e -> e.group(1)).toList())
        .containsAll(
            ATTRIBUTE
                .matcher(grammar)
                .results()
                .map(a -> a.group(1))
                .filter(name -> !name.endsWith("Unit"))
                .toList());
  }

  @Test
  void guideNamesEveryFunctionAndUnit() throws IOException {
    assertThat(WORD.matcher(guide()).results().map(w -> w.group()))
        .containsAll(Function.symbols())
        .containsAll(UnitSymbols.all());
  }
}
