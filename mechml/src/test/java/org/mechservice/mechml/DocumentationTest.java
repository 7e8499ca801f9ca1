package org.mechservice.mechml;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.mechml.unit.UnitSymbols;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.symbol.MathFunction;
import org.w3c.dom.Element;
import org.w3c.dom.Node;

/** The user guide says what the reader does, and its examples run. */
class DocumentationTest {
  private static final Pattern EXAMPLE = Pattern.compile("```xml\n(.*?)```", Pattern.DOTALL);
  private static final Pattern ELEMENT = Pattern.compile("<!ELEMENT (\\w+)");
  private static final Pattern ATTRIBUTE = Pattern.compile("\n  (\\w+) +(?:CDATA|\\()");
  private static final Pattern LIST = Pattern.compile("<!ATTLIST (\\w+)([^>]*)>");
  private static final Pattern ROW = Pattern.compile("\n\\| (`.*?) \\| (.*) \\|");
  private static final Pattern QUOTED = Pattern.compile("`(\\w+)`");
  private static final Pattern LINK = Pattern.compile("examples/elements/([\\w.-]+)\\)");
  private static final Path ELEMENTS = Path.of("..", "examples", "elements");
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
    // Parts of the guide define parameters that other parts use.
    ReadOptions part = ReadOptions.NONE.silencing(Set.of(MessageCode.PARAMETER_NOT_USED.word()));
    byte[] content = file.getBytes(StandardCharsets.UTF_8);
    MechmlModel model = MechmlReader.read("guide.xml", content, part);
    assertThat(model.warnings()).isEmpty();
    assertThat(model.mechanism().bodies()).hasSize(2);
  }

  @Test
  void everyElementStandsInAnExample() throws IOException {
    Matcher element = ELEMENT.matcher(Files.readString(Path.of("..", "mechml.dtd")));
    String all = examples().collect(Collectors.joining());
    assertThat(element.results().map(e -> e.group(1)))
        .contains("MechML", "Joints")
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

  /** Returns the examples of each element, as the guide's last table lists them. */
  private static Map<String, List<String>> examplesOfElements() throws IOException {
    String table = guide().split("## Every element at work", 2)[1].split("\n## ", 2)[0];
    Map<String, List<String>> files = new TreeMap<>();
    for (MatchResult row : ROW.matcher(table).results().toList()) {
      List<String> linked = LINK.matcher(row.group(2)).results().map(l -> l.group(1)).toList();
      QUOTED.matcher(row.group(1)).results().forEach(e -> files.put(e.group(1), linked));
    }
    return files;
  }

  @Test
  void everyElementAndAttributeIsInAnExampleThatTheGuideLinks() throws Exception {
    Map<String, List<String>> files = examplesOfElements();
    Map<String, Set<String>> declared = attributesOfElements();
    assertThat(files.keySet()).containsExactlyInAnyOrderElementsOf(declared.keySet());
    Map<String, Set<String>> used = new TreeMap<>();
    for (String file : new TreeSet<>(files.values().stream().flatMap(List::stream).toList())) {
      if (file.endsWith(".xml") || file.endsWith(".part")) {
        collect(ExampleFile.parse(Files.newInputStream(ELEMENTS.resolve(file))), used);
      }
    }
    for (Map.Entry<String, List<String>> entry : files.entrySet()) {
      String own = Files.readString(ELEMENTS.resolve(entry.getValue().get(0)));
      assertThat(own).as(entry.getValue().get(0)).containsPattern("<" + entry.getKey() + "[ />]");
    }
    assertThat(used).isEqualTo(declared);
  }

  @Test
  void everyExampleOfAnElementIsInTheGuide() throws IOException {
    try (Stream<Path> files = Files.list(ELEMENTS)) {
      assertThat(files.map(f -> f.getFileName().toString()).filter(f -> !f.endsWith(".md")))
          .containsExactlyInAnyOrderElementsOf(
              examplesOfElements().values().stream().flatMap(List::stream).distinct().toList());
    }
  }

  /** Every element's attributes as the grammar declares them. */
  private static Map<String, Set<String>> attributesOfElements() throws IOException {
    String grammar = Files.readString(Path.of("..", "mechml.dtd"));
    Map<String, Set<String>> attributes = new TreeMap<>();
    ELEMENT.matcher(grammar).results().forEach(e -> attributes.put(e.group(1), new TreeSet<>()));
    for (MatchResult list : LIST.matcher(grammar).results().toList()) {
      Set<String> ofElement = attributes.computeIfAbsent(list.group(1), name -> new TreeSet<>());
      ATTRIBUTE.matcher(list.group(2)).results().forEach(a -> ofElement.add(a.group(1)));
    }
    return attributes;
  }

  private static void collect(Element element, Map<String, Set<String>> used) {
    Set<String> attributes = used.computeIfAbsent(element.getTagName(), e -> new TreeSet<>());
    for (int i = 0; i < element.getAttributes().getLength(); i++) {
      attributes.add(element.getAttributes().item(i).getNodeName());
    }
    for (Node n = element.getFirstChild(); n != null; n = n.getNextSibling()) {
      if (n instanceof Element child) {
        collect(child, used);
      }
    }
  }

  @Test
  void guideNamesEveryFunctionAndUnit() throws IOException {
    assertThat(WORD.matcher(guide()).results().map(w -> w.group()))
        .containsAll(MathFunction.symbols())
        .containsAll(UnitSymbols.all());
  }
}
