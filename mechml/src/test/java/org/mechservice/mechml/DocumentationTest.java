package org.mechservice.mechml;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.mechservice.mechml.expression.Function;
import org.mechservice.mechml.unit.UnitSymbols;

/** The user guide says what the reader does. */
class DocumentationTest {
  private static final Pattern EXAMPLE = Pattern.compile("```xml\n(.*?)```", Pattern.DOTALL);
  private static final Pattern ELEMENT = Pattern.compile("<!ELEMENT (\\w+)");
  private static final Pattern WORD = Pattern.compile("[A-Za-z_][A-Za-z0-9_]*");

  private static String guide() throws IOException {
    return Files.readString(Path.of("..", "docs", "mechml.md"));
  }

  @Test
  void exampleOfTheGuideIsReadWithoutAWarning() throws Exception {
    Matcher example = EXAMPLE.matcher(guide());
    assertThat(example.find()).isTrue();
    MechmlModel model =
        MechmlReader.read("guide.xml", example.group(1).getBytes(StandardCharsets.UTF_8));
    assertThat(model.warnings()).isEmpty();
    assertThat(model.mechanism().velocityCount()).isEqualTo(2);
  }

  @Test
  void guideNamesEveryElementThatIsRead() throws IOException {
    Matcher element = ELEMENT.matcher(Files.readString(Path.of("..", "mechml.dtd")));
    assertThat(element.results().map(e -> e.group(1)))
        .filteredOn(name -> !name.matches("DISTConstraint|bodyrod|force|MechML"))
        .allSatisfy(name -> assertThat(guide()).containsPattern("[`<]" + name + "\\b"));
  }

  @Test
  void guideNamesEveryFunctionAndUnit() throws IOException {
    assertThat(WORD.matcher(guide()).results().map(w -> w.group()))
        .containsAll(Function.symbols())
        .containsAll(UnitSymbols.all());
  }
}
